#pragma once

#include "engine/io/anatomy_set/carried_sets.h"
#include "engine/net/anatomy_transfer/set_sender.h"
#include "engine/net/anatomy_transfer/set_server.h"
#include "engine/net/anatomy_transfer/transfer_frame.h"

#include <QPointer>
#include <QSslServer>
#include <QTimer>

#include <deque>
#include <map>

namespace carina
{

/// The part of SetServer on its thread: accepts connections, authenticates clients and finds sets.
class SetListener : public QSslServer
{
public:
    explicit SetListener(const std::filesystem::path& anatomyCache);

    /// @returns AddressInUse with the port.
    [[nodiscard]] Result<std::uint16_t> bind(std::uint16_t port, bool open);
    void admit(const std::string& sessionId, HostTransport::KeyOf keyOf,
               SetServer::IsNamed isNamed);

    /// The set with this content hash, ready to be sent.
    [[nodiscard]] tl::expected<CarriedSet, transfer::Reason> find(const std::string& contentHash);
    [[nodiscard]] std::filesystem::path fileOf(const CarriedSet& set) const
    {
        return m_sets.file(set.digest);
    }
    /// Lets a sender send in round-robin turns until it has nothing left.
    void giveTurns(SetSender& sender);

private:
    void answerKey(QSslPreSharedKeyAuthenticator& question) const;
    void welcome();
    void sendOneChunk();

    CarriedSets m_sets;
    HostTransport::KeyOf m_keyOf;
    SetServer::IsNamed m_isNamed;
    std::map<std::string, CarriedSet> m_prepared; // by content hash
    HelloLimiter m_limiter;
    std::size_t m_transfers = 0;
    std::deque<QPointer<SetSender>> m_turns; // the next one first
    QTimer m_pace{this};
};

} // namespace carina
