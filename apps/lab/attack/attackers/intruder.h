#pragma once

#include "engine/net/secure/client_transport.h"
#include "engine/session/session_state.h"
#include "engine/sync/facts/fact_acknowledgement.h"
#include "evaluation/network/transport_pump.h"

#include <functional>
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
    DeriveKey derive;                           ///< quick: the key is known already
    QHostAddress from{QHostAddress::LocalHost}; ///< its own, of this computer
};

/// A client that keeps to none of the rules: one encrypted path to a host, over which it sends what
/// it likes. Runs in the event loop of its thread.
class Intruder : public TransportListener
{
public:
    /// What it says it has of the log already.
    enum class Has : std::uint8_t { Nothing, WhatItHeard };

    explicit Intruder(const WayIn& way);

    /// Whether there is an encrypted path; after one that the host ended, another is opened.
    [[nodiscard]] bool isIn() const { return m_path != 0; }
    /// Paths that the host ended.
    [[nodiscard]] int ended() const { return m_ended; }
    /// As whom the host admitted it last; nothing before.
    [[nodiscard]] const std::optional<Welcome>& welcome() const { return m_welcome; }
    /// Whether it was admitted, and neither left nor was put out since.
    [[nodiscard]] bool takesPart() const { return m_takesPart; }
    /// The station that the host admitted it to; kNoStation before it was told.
    [[nodiscard]] StationId station() const;
    /// Why the host refused its last Hello, if it did.
    [[nodiscard]] const std::optional<Errc>& helloRefused() const { return m_helloRefused; }
    /// The log as far as it was heard.
    [[nodiscard]] const std::vector<FactRecord>& facts() const { return m_facts; }
    /// What follows from it.
    [[nodiscard]] const SessionState& state() const { return m_state; }
    /// Facts that the host sent, each as often as it was.
    [[nodiscard]] std::int64_t factsHeard() const { return m_factsHeard; }
    /// Datagrams sent over the path.
    [[nodiscard]] std::int64_t sent() const { return m_sent; }
    /// Session time by the newest datagram of the host.
    [[nodiscard]] SessionTime sessionNow() const;
    /// Session time at which the host sent that datagram; in onRecord, the one of the record.
    [[nodiscard]] SessionTime hostSent() const { return m_hostSent; }

    /// Calls this with each record of the host.
    void onRecord(std::function<void(const WireRecord&)> heard) { m_heard = std::move(heard); }

    /// Sends a Hello with this join. @param connection one more for each new connection
    void hello(const std::string& name, ProposalId id, std::uint32_t connection,
               Has has = Has::Nothing);
    /// Acknowledges the facts that arrived, and shows now and then that it is there; to be called
    /// in each turn.
    void acknowledge();
    /// Says Goodbye.
    void leave();
    /// Sends records in as few datagrams as possible.
    void send(std::span<const WireRecord> records);
    /// Sends bytes as they are.
    void sendBytes(std::span<const std::byte> bytes);

    void connected(PeerAddress peer, const Credential& who, LocalTime now) override;
    void receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now) override;
    void disconnected(PeerAddress peer, LocalTime now) override;
    void refused(const Error& why, LocalTime now) override;

private:
    void take(const FactRecord& fact);

    Role m_role;
    ClientCredentials m_credentials;
    ClientTransport m_transport;
    PeerAddress m_path = 0;
    int m_ended = 0;
    std::optional<Welcome> m_welcome;
    bool m_takesPart = false;
    std::uint32_t m_admitted = 0; ///< the connection of the last Welcome
    std::optional<Errc> m_helloRefused;
    std::function<void(const WireRecord&)> m_heard = [](const WireRecord&) {};
    std::vector<FactRecord> m_facts;
    SessionState m_state;
    SessionKey m_session{};                ///< in which it was last
    FactNumber m_inOrder;                  ///< the last fact in order since the last Hello
    FactAcknowledgement m_acknowledgement; ///< as a program's
    LocalTime m_nextSign{};                ///< when it is to show again that it is there
    std::int64_t m_factsHeard = 0;
    BundleHeader m_header; ///< of the next datagram
    Duration m_sessionOffset{};
    SessionTime m_hostSent{};
    std::int64_t m_sent = 0;
    std::unique_ptr<TransportPump> m_pump; // last: serves what is above
};

} // namespace carina::lab
