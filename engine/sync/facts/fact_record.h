#pragma once

#include "engine/core/ids.h"
#include "engine/core/session_time.h"

#include <cstddef>
#include <vector>

namespace carina
{

/// A fact as it is sent and stored. Order, author and times are plain fields; the content is opaque
/// here, encoded by engine/session/facts/fact_codec.
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

/// A proposed fact as it is sent.
struct ProposalRecord {
    ProposalId id;
    ParticipantId author;
    StationId station;
    std::vector<std::byte> body;

    friend bool operator==(const ProposalRecord&, const ProposalRecord&) = default;
};

/// Bytes; a fact with its header fits into one datagram.
inline constexpr std::size_t kLargestFactBody = 1024;

} // namespace carina
