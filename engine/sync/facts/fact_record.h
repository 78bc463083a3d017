#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"

#include <cstddef>
#include <vector>

namespace carina
{

/// A fact as it travels and is stored: what orders and dates it in the open, its meaning as bytes
/// that engine/session writes and reads (engine/session/facts/fact_codec).
struct FactRecord {
    FactNumber number;
    ProposalId proposal;
    ParticipantId author;
    StationId station;
    SessionTime committed{};
    SessionTime effect{};
    std::vector<std::byte> body; ///< at most kLargestFactBody

    friend bool operator==(const FactRecord&, const FactRecord&) = default;
};

/// A fact that somebody would like to enter the log, as it travels.
struct ProposalRecord {
    ProposalId id;
    ParticipantId author;
    StationId station;
    std::vector<std::byte> body;

    friend bool operator==(const ProposalRecord&, const ProposalRecord&) = default;
};

/// A fact fits into one datagram with its envelope.
inline constexpr std::size_t kLargestFactBody = 1024;

} // namespace carina
