#pragma once

#include "engine/net/secure/client_path.h"
#include "engine/net/secure/secure_transport.h"

#include <memory>

namespace carina
{

/// A client's end: the encrypted path to the host, and whoever watches over it.
///
/// DTLS waits a second before it repeats a lost part of a handshake, so it is not left to: each try
/// that is not through after max(250 ms, 4 round trips) gets another beside it, with a port of its
/// own, up to three at once, and the first that is encrypted wins. The same begins when a path has
/// been silent for 750 ms (the host's keep-alive is 250 ms), while the old one is still used: so a
/// client that roams, or whose host was restarted, finds back by itself.
class ClientTransport : public SecureTransport
{
public:
    static constexpr std::size_t kMostTries = 3;
    static constexpr Duration kShortestTry = std::chrono::milliseconds{250};
    static constexpr int kTryRoundTrips = 4;
    static constexpr Duration kSilence = std::chrono::milliseconds{750};

    /// @param credentials outlive the transport
    /// @param expected what the host must prove first, where it has to
    ClientTransport(const QHostAddress& host, std::uint16_t port, ClientCredentials& credentials,
                    LocalTime now, std::optional<ExpectedCertificate> expected = {});
    ~ClientTransport() override;

    void serve(TransportListener& listener, LocalTime now) override;
    [[nodiscard]] LocalTime nextWake() const override;
    void send(PeerAddress to, std::span<const std::byte> bytes) override;
    void close() override;
    [[nodiscard]] std::uint16_t port() const override { return 0; }

    /// How many tries were begun.
    [[nodiscard]] int tries() const { return m_tries; }

private:
    void serveTries(TransportListener& listener, LocalTime now);
    void servePath(TransportListener& listener, LocalTime now);
    void take(std::unique_ptr<ClientPath> path, TransportListener& listener, LocalTime now);
    [[nodiscard]] bool needsPath(LocalTime now) const;
    void beginTry(LocalTime now);

    QHostAddress m_host;
    std::uint16_t m_port;
    ClientCredentials& m_credentials;
    std::optional<ExpectedCertificate> m_expected; // the paths refer to it
    std::unique_ptr<ClientPath> m_path;
    PeerAddress m_address = 0; // of the path; one more for each
    std::vector<std::unique_ptr<ClientPath>> m_opening;
    LocalTime m_nextTry;
    Duration m_roundTrip{};
    int m_tries = 0;
    bool m_toldRefusal = false;
};

} // namespace carina
