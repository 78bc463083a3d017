#pragma once

#include "engine/core/session_time.h"
#include "engine/net/anatomy_transfer/set_server.h"
#include "engine/net/anatomy_transfer/transfer_frame.h"

#include <QFile>
#include <QSslSocket>
#include <QTimer>

namespace carina
{

class SetListener;

/// The host's end of one connection: answers Want with an Offer, and Get with the bytes of the set,
/// in turns and no faster than the connection transmits them. Ends it where it moves too little
/// (SetPatience). A child of the socket.
class SetSender : public QObject
{
public:
    SetSender(QSslSocket& socket, SetListener& listener, const SetPatience& patience);

    /// Begins to hear the client.
    void start();
    /// Sends a Refusal and ends the connection.
    void refuse(transfer::Reason reason);
    /// Ends the connection at once, whatever is under way.
    void abort() { m_socket.abort(); }

    [[nodiscard]] bool isOver() const
    {
        return m_socket.state() == QAbstractSocket::UnconnectedState;
    }
    /// Since the connection was made.
    [[nodiscard]] Duration held(LocalTime now) const { return now - m_began; }
    /// That the client took in this window and the one before.
    [[nodiscard]] double bytesPerSecond(LocalTime now) const;

    [[nodiscard]] bool hasMore() const { return m_left > 0; }
    /// @returns false while earlier bytes are not transmitted yet.
    bool sendChunk();

private:
    void endWindow();
    void read();
    void take(const transfer::Frame& frame);
    void offer(const transfer::Want& want);
    void begin(std::uint64_t offset);
    void write(const transfer::Frame& frame);

    QSslSocket& m_socket;
    SetListener& m_listener;
    std::uint64_t m_leastBytes;
    QByteArray m_received; // less than one frame
    QFile m_file;          // that was offered; open while it is sent
    std::uint64_t m_left = 0;
    LocalTime m_began;
    LocalTime m_measuredFrom; // the start of the window before, if there was one
    LocalTime m_windowBegan;
    std::uint64_t m_movedBefore = 0; // bytes, in the window before
    std::uint64_t m_moved = 0;       // in this
    QTimer m_window;
};

} // namespace carina
