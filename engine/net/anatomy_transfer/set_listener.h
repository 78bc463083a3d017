#pragma once

#include "engine/io/anatomy_set/carried_sets.h"
#include "engine/net/anatomy_transfer/set_sender.h"
#include "engine/net/anatomy_transfer/set_server.h"
#include "engine/net/anatomy_transfer/transfer_frame.h"
#include "engine/net/anatomy_transfer/transfer_places.h"

#include <QPointer>
#include <QSslServer>
#include <QTimer>

#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace carina
{

/// The part of SetServer on its thread: accepts connections, authenticates clients and finds sets.
class SetListener : public QSslServer
{
public:
    SetListener(const std::filesystem::path& anatomyCache, const SetPatience& patience);

    /// @returns AddressInUse with the port.
    [[nodiscard]] Result<std::uint16_t> bind(std::uint16_t port, bool open);
    void admit(const std::string& sessionId, HostTransport::KeyOf keyOf, SetServer::IsNamed isNamed,
               SetServer::IsWelcome isWelcome);

    /// The set with this content hash, ready to be sent.
    [[nodiscard]] tl::expected<CarriedSet, transfer::Reason> find(const std::string& contentHash);
    [[nodiscard]] std::filesystem::path fileOf(const CarriedSet& set) const
    {
        return m_sets.file(set.digest);
    }
    /// Lets a sender send in round-robin turns until it has nothing left.
    void giveTurns(SetSender& sender);

private:
    /// A key that a client was told to have.
    struct Key {
        PskIdentity identity;
        AccessKey key;
    };
    struct Asked {
        QPointer<QSslSocket> socket;
        Key key;
    };
    struct Transfer {
        QPointer<SetSender> sender;
        Key key;
        SourcePrefix from;
    };

    void answerKey(QSslSocket* socket, QSslPreSharedKeyAuthenticator& question);
    /// With which the handshake of this connection was made.
    [[nodiscard]] std::optional<Key> takeKey(const QSslSocket* socket);
    /// Whether the key is still the one of its identity, and its holder in the session.
    [[nodiscard]] bool mayHave(const Key& key) const;
    void welcome();
    /// Gives it a place, and ends another for it where it must. @returns whether it has one
    [[nodiscard]] bool findPlace(SetSender& sender, const Key& key, const SourcePrefix& from);
    void endVoid();
    void sendOneChunk();

    CarriedSets m_sets;
    SetPatience m_patience;
    HostTransport::KeyOf m_keyOf;
    SetServer::IsNamed m_isNamed;
    SetServer::IsWelcome m_isWelcome;
    std::map<std::string, CarriedSet> m_prepared; // by content hash
    SourceLimiter m_limiter;
    std::vector<Asked> m_asked; // whose handshake is under way
    std::vector<Transfer> m_transfers;
    std::deque<QPointer<SetSender>> m_turns; // the next one first
    QTimer m_pace{this};
    QTimer m_look{this};
};

} // namespace carina
