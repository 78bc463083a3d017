#pragma once

#include "engine/net/secure/client_transport.h"
#include "engine/session/facts/facts.h"
#include "evaluation/network/transport_pump.h"

#include <memory>
#include <string>
#include <vector>

namespace carina::lab
{

/// How an intruder gets in: what anybody with a role's code has.
struct WayIn {
    std::uint16_t port = 0; ///< of the host, on this computer
    Role role = Role::Observer;
    JoinCode code;
    DeriveKey derive; ///< quick: the key is known already
};

/// A client that keeps to none of the rules: one encrypted path to a host, over which it sends what
/// it likes. Runs in the event loop of its thread.
class Intruder : public TransportListener
{
public:
    explicit Intruder(const WayIn& way);

    /// Whether the path is encrypted.
    [[nodiscard]] bool isIn() const { return m_path != 0; }
    /// Paths that the host ended.
    [[nodiscard]] int ended() const { return m_ended; }
    /// As whom the host admitted it last; nothing before.
    [[nodiscard]] const std::optional<Welcome>& welcome() const { return m_welcome; }
    /// The station that the host admitted it to; kNoStation before it was told.
    [[nodiscard]] StationId station() const;
    /// Why the host refused its last Hello, if it did.
    [[nodiscard]] const std::optional<Errc>& helloRefused() const { return m_helloRefused; }
    /// The facts that the host sent, in order of arrival.
    [[nodiscard]] const std::vector<FactRecord>& facts() const { return m_facts; }
    /// Datagrams sent over the path.
    [[nodiscard]] std::int64_t sent() const { return m_sent; }
    /// Session time by the newest datagram of the host.
    [[nodiscard]] SessionTime sessionNow() const;

    /// Sends a Hello with this join. @param connection one more for each new connection
    void hello(const std::string& name, ProposalId id, std::uint32_t connection);
    /// Sends records in as few datagrams as possible.
    void send(std::span<const WireRecord> records);
    /// Sends bytes as they are.
    void sendBytes(std::span<const std::byte> bytes);

    void connected(PeerAddress peer, const Credential& who, LocalTime now) override;
    void receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now) override;
    void disconnected(PeerAddress peer, LocalTime now) override;
    void refused(const Error& why, LocalTime now) override;

private:
    Role m_role;
    ClientCredentials m_credentials;
    ClientTransport m_transport;
    PeerAddress m_path = 0;
    int m_ended = 0;
    std::optional<Welcome> m_welcome;
    std::optional<Errc> m_helloRefused;
    std::vector<FactRecord> m_facts;
    BundleHeader m_header; ///< of the next datagram
    Duration m_sessionOffset{};
    std::int64_t m_sent = 0;
    std::unique_ptr<TransportPump> m_pump; // last: serves what is above
};

} // namespace carina::lab
