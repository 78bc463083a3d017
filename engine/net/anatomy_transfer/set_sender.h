#pragma once

#include "engine/net/anatomy_transfer/transfer_frame.h"

#include <QFile>
#include <QSslSocket>
#include <QTimer>

namespace carina
{

class SetListener;

/// The host's end of one connection: answers Want with an Offer, and Get with the bytes of the set,
/// in turns and no faster than the connection transmits them. A child of the socket.
class SetSender : public QObject
{
public:
    SetSender(QSslSocket& socket, SetListener& listener);

    /// Sends a Refusal and ends the connection.
    void refuse(transfer::Reason reason);

    [[nodiscard]] bool hasMore() const { return m_left > 0; }
    /// @returns false while earlier bytes are not transmitted yet.
    bool sendChunk();

private:
    void read();
    void take(const transfer::Frame& frame);
    void offer(const transfer::Want& want);
    void begin(std::uint64_t offset);
    void write(const transfer::Frame& frame);

    QSslSocket& m_socket;
    SetListener& m_listener;
    QByteArray m_received; // less than one frame
    QFile m_file;          // that was offered; open while it is sent
    std::uint64_t m_left = 0;
    QTimer m_patience;
};

} // namespace carina
