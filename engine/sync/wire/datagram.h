#pragma once

#include "engine/core/errc.h"
#include "engine/sync/facts/fact_record.h"
#include "engine/sync/wire/event_cpo.h"
#include "engine/sync/wire/stream_cpo.h"

#include <array>
#include <compare>
#include <variant>

namespace carina
{

/// Of this layout; a peer with another number is refused.
inline constexpr std::uint8_t kProtocolVersion = 6;
/// Leaves room for DTLS around it (29 bytes), so that no more than 1200 bytes travel in a UDP
/// packet: they fit into any path's MTU, and nothing is ever fragmented.
inline constexpr std::size_t kLargestDatagram = 1160;

/// Tells one session from every other: 128 random bits, all zero for "none yet".
using SessionKey = std::array<std::byte, 16>;

/// What a datagram brings back to the peer so that it can measure the path: the time on its own
/// clock when it sent the newest datagram that arrived here, and how long that has been here.
struct ClockEcho {
    Duration sentAt{};
    Duration hold{}; ///< at most kLongestHold

    friend bool operator==(const ClockEcho&, const ClockEcho&) = default;
};
/// 32 bits of nanoseconds.
inline constexpr Duration kLongestHold{0xFFFF'FFFFLL};

/// Before the records of every datagram.
struct BundleHeader {
    bool fromHost = false;
    bool answerNow = false;       ///< the peer shall answer at once, for the sake of the clock
    std::uint32_t connection = 0; ///< drawn by the client; a number above the last for a new one
    std::uint32_t sequence = 0;   ///< of the datagrams of one direction of a connection; wraps
    ParticipantId sender = kNobody;
    Duration sentAt{}; ///< on the sender's clock: session time at the host, local time elsewhere
    std::optional<ClockEcho> echo;

    friend bool operator==(const BundleHeader&, const BundleHeader&) = default;
};

/// All facts up to this number have arrived, in order.
struct FactAck {
    FactNumber last;
};
/// This action, or a later one on its object, has arrived.
struct EventAck {
    ObjectId object;
    std::uint16_t epoch = 0;
    std::uint32_t action = 0;
};
/// A sign of life of the owner: this action, which the other end has acknowledged, is in force.
struct EventBeat {
    ObjectId object;
    std::uint16_t epoch = 0;
    std::uint32_t action = 0;
};
/// The host does not enter this proposal into the log.
struct ProposalRefused {
    ProposalId proposal;
    Errc reason = Errc::NotPermitted;
};
/// A client wants to come in, or back.
struct Hello {
    SessionKey session{}; ///< the one it knows
    FactNumber lastFact;  ///< the last it holds of it
    ProposalRecord join;  ///< the fact that it comes in, for the session to judge
};
/// The host lets it in.
struct Welcome {
    SessionKey session{};
    ParticipantId participant;
    std::uint16_t epoch = 0; ///< of the participant's streams
    FactNumber lastFact;     ///< of the host's log
};
/// The host does not let it in.
struct HelloRefused {
    Errc reason = Errc::NotPermitted;
};
/// The host knows no such connection; say Hello.
struct ConnectionUnknown {
};
/// The sender goes away for good.
struct Goodbye {
};

using WireRecord =
    std::variant<StreamGroup, EventCpo, FactRecord, ProposalRecord, FactAck, ProposalRefused, Hello,
                 Welcome, HelloRefused, ConnectionUnknown, Goodbye, EventAck, EventBeat>;

/// One datagram, decoded.
struct Datagram {
    BundleHeader header;
    std::vector<WireRecord> records;
};

} // namespace carina
