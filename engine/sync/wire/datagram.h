#pragma once

#include "engine/core/errc.h"
#include "engine/core/external_time.h"
#include "engine/sync/facts/fact_record.h"
#include "engine/sync/strategies/strategy_choice.h"
#include "engine/sync/wire/event_cpo.h"
#include "engine/sync/wire/shown_pose.h"
#include "engine/sync/wire/stream_cpo.h"

#include <array>
#include <compare>
#include <string>
#include <variant>

namespace carina
{

/// Version of this layout; a peer with another version is refused.
inline constexpr std::uint8_t kProtocolVersion = 20;
/// Bytes. With DTLS (29 bytes) a UDP payload has at most 1200 bytes, which fits the MTU of any
/// usual path without fragmentation.
inline constexpr std::size_t kLargestDatagram = 1160;

/// Identifies a session: 128 random bits; all zero for "none yet".
using SessionKey = std::array<std::byte, 16>;

/// What a datagram returns to the peer for measuring the path: the sending time, on the peer's
/// clock, of the newest datagram received from it, and the time since its arrival.
struct ClockEcho {
    Duration sentAt{};
    Duration hold{}; ///< at most kLongestHold

    friend bool operator==(const ClockEcho&, const ClockEcho&) = default;
};
/// 2^32 - 1 nanoseconds, 4.3 s.
inline constexpr Duration kLongestHold{0xFFFF'FFFFLL};

/// The header of every datagram, before its records.
struct BundleHeader {
    bool fromHost = false;
    bool answerNow = false; ///< the peer is to answer at once, for the clock estimate
    /// Chosen by the client: random at first, one more for each new connection.
    std::uint32_t connection = 0;
    /// Sequence number in one direction of a connection; wraps.
    std::uint32_t sequence = 0;
    ParticipantId sender = kNobody;
    Duration sentAt{}; ///< on the sender's clock: session time at the host, local time elsewhere
    std::optional<ClockEcho> echo;

    friend bool operator==(const BundleHeader&, const BundleHeader&) = default;
};

/// All facts up to this number have arrived, in order.
struct FactAck {
    FactNumber last;
};
/// This action, or a later one on the object, has arrived.
struct EventAck {
    ObjectId object;
    std::uint16_t epoch = 0;
    std::uint32_t action = 0;
};
/// Heartbeat of the owner: this action, which the peer has acknowledged, is still in force.
struct EventBeat {
    ObjectId object;
    std::uint16_t epoch = 0;
    std::uint32_t action = 0;
};
/// A message of the session's strategy, between a participant and the host; its bytes are the
/// strategy's own (engine/sync/strategies).
struct StrategyMessage {
    StrategyKind strategy = StrategyKind::None; ///< a program that runs another drops it
    std::vector<std::byte> bytes;               ///< 1 to kLargestStrategyMessage
};
inline constexpr std::size_t kLargestStrategyMessage = 128;
/// The host tells a participant the local lag with which its actions begin everywhere at once,
/// judged by the recent delays.
struct LagNeeded {
    Duration lag{}; ///< at most kLongestHold
};
/// The host refuses to enter this proposal into the log.
struct ProposalRefused {
    ProposalId proposal;
    Errc reason = Errc::NotPermitted;
};
/// A client asks to be admitted, for the first time or again.
struct Hello {
    SessionKey session{}; ///< the session known to the client
    FactNumber lastFact;  ///< the last it holds of it
    ProposalRecord join;  ///< the fact that the client joins, for the session to judge
    /// The name of the station that its user wants: at most kLongestStationName bytes; empty: any.
    std::string station{};
};
inline constexpr std::size_t kLongestStationName = 64;
/// The host admits the client.
struct Welcome {
    SessionKey session{};
    ParticipantId participant;
    std::uint16_t epoch = 0; ///< of the participant's streams
    FactNumber lastFact;     ///< of the host's log
};
/// The host refuses to admit the client, or ends its connection.
struct HelloRefused {
    Errc reason = Errc::NotPermitted;
    std::string detail{}; ///< for its user: UTF-8, at most kLongestDetail bytes
};
inline constexpr std::size_t kLongestDetail = 200;
/// The host has no such connection; the client must send Hello.
struct ConnectionUnknown {
};
/// The sender ends the connection.
struct Goodbye {
};

/// The sender's clock, as in BundleHeader::sentAt, is off by this much from one that NTP or PTP
/// disciplines.
struct ExternalTimeRecord {
    ExternalTime time; ///< its error is above 0 and at most kLargestExternalError
};
inline constexpr Duration kLargestExternalError = std::chrono::seconds{16};

using WireRecord =
    std::variant<StreamGroup, EventCpo, FactRecord, ProposalRecord, FactAck, ProposalRefused, Hello,
                 Welcome, HelloRefused, ConnectionUnknown, Goodbye, EventAck, EventBeat,
                 StrategyMessage, LagNeeded, ShownPose, ExternalTimeRecord>;

/// One datagram, decoded.
struct Datagram {
    BundleHeader header;
    std::vector<WireRecord> records;
};

} // namespace carina
