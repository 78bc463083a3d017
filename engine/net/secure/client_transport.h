#pragma once

#include "engine/net/discovery/session_search.h"
#include "engine/net/secure/client_path.h"
#include "engine/net/secure/secure_transport.h"

#include <memory>

namespace carina
{

/// A client's transport: the encrypted path to the host, and its supervision.
///
/// DTLS retransmits a lost part of a handshake only after a second, which is too slow. Therefore,
/// while an attempt is not complete after max(250 ms, 4 round trips), another is started beside it
/// from another port, up to three at once; the first that completes is used. The same happens when
/// a path is silent for 750 ms (the host's keep-alive is 250 ms), while the old path remains in
/// use: a client that roams, or whose host was restarted, reconnects without help.
///
/// A host that comes back at another address or port is searched for as well: a client that was in
/// a session asks the networks for it when the session is silent for kSearchAfter, and tries the
/// places that answer beside the one it knows, three at a time and each for kFoundTry. So does one
/// whose program was started again, while nobody answers at the place that it was given
/// (ClientCredentials::sought). The first that proves to have the client's token is the host from
/// then on; what others say has no effect (HostPlace::Found).
///
/// A host that answers and does not go on has as many handshakes as it takes from this address:
/// after kEagerTries of those, a client asks each kPatientTry, so that all who wait get in sooner.
class ClientTransport : public SecureTransport
{
public:
    static constexpr std::size_t kMostTries = 3;
    static constexpr Duration kShortestTry = std::chrono::milliseconds{250};
    static constexpr int kTryRoundTrips = 4;
    static constexpr int kEagerTries = 5;
    static constexpr Duration kPatientTry = std::chrono::seconds{1};
    static constexpr Duration kSilence = std::chrono::milliseconds{750};
    static constexpr Duration kSearchAfter = std::chrono::milliseconds{1500};
    static constexpr Duration kFoundTry = std::chrono::milliseconds{1000};
    /// Called with the address and port of a host that was found.
    using OnMoved = std::function<void(const std::string& address, std::uint16_t port)>;

    /// @param credentials outlive the transport
    /// @param expected the certificate that the host must have, if any
    /// @param from address of this computer; null: any that reaches the host
    ClientTransport(const QHostAddress& host, std::uint16_t port, ClientCredentials& credentials,
                    LocalTime now, std::optional<ExpectedCertificate> expected = {},
                    std::uint16_t discoveryPort = kDiscoveryPort, QHostAddress from = {});
    ~ClientTransport() override;

    /// Sets a callback, called before the listener hears of the new path.
    void onMoved(OnMoved callback) { m_onMoved = std::move(callback); }

    void serve(TransportListener& listener, LocalTime now) override;
    [[nodiscard]] LocalTime nextWake() const override;
    void send(PeerAddress to, std::span<const std::byte> bytes) override;
    void close() override;
    [[nodiscard]] std::uint16_t port() const override { return 0; }

    /// Number of attempts started.
    [[nodiscard]] int tries() const { return m_tries; }

private:
    void serveTries(TransportListener& listener, LocalTime now);
    void servePath(TransportListener& listener, LocalTime now);
    void take(std::unique_ptr<ClientPath> path, TransportListener& listener, LocalTime now);
    [[nodiscard]] bool needsPath(LocalTime now) const;
    void beginTry(LocalTime now);
    [[nodiscard]] Duration untilNextTry() const;
    void serveSearch(TransportListener& listener, LocalTime now);
    [[nodiscard]] bool needsSearch(LocalTime now) const;
    void tryFound(LocalTime now);
    void moveTo(const ClientPath& path);

    QHostAddress m_host;
    std::uint16_t m_port;
    QHostAddress m_from;
    ClientCredentials& m_credentials;
    std::optional<ExpectedCertificate> m_expected; // the paths refer to it
    std::unique_ptr<ClientPath> m_path;
    PeerAddress m_address = 0; // of the path; incremented for each
    std::vector<std::unique_ptr<ClientPath>> m_opening;
    std::vector<std::unique_ptr<ClientPath>> m_found; ///< tries at places that were found
    std::unique_ptr<SessionSearch> m_search;
    std::uint16_t m_discoveryPort;
    LocalTime m_lastAlive; ///< when the last path was heard, or the host before there was one
    OnMoved m_onMoved;
    LocalTime m_nextTry;
    Duration m_roundTrip{};
    int m_tries = 0;
    int m_unfinished = 0; ///< tries since the last path that were answered and came to nothing
    bool m_toldRefusal = false;
};

} // namespace carina
