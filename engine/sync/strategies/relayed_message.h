#pragma once

#include "engine/core/ids.h"
#include "engine/core/result.h"
#include "engine/sync/wire/event_cpo.h"

#include <span>
#include <variant>
#include <vector>

namespace carina
{

/// Request for an immediate answer.
struct DelayProbe {
    Duration sentAt{}; ///< on the asker's clock
};
/// The answer to a DelayProbe.
struct DelayAnswer {
    Duration sentAt{}; ///< that of the probe
};

/// Message of the strategies that have no session clock: from one participant to another, or to all
/// others, forwarded by the host at once and unchanged.
struct RelayedMessage {
    ParticipantId from;
    ParticipantId to;
    std::variant<EventCpo, DelayProbe, DelayAnswer> content;
};

/// Addresses all participants but the sender.
inline constexpr ParticipantId kAllOthers{0xFFFF};

/// @pre numbers within their ranges (engine/sync/wire/cpo_codec.h)
[[nodiscard]] std::vector<std::byte> encodeRelayed(const RelayedMessage& message);
/// @returns PacketMalformed, naming the rule that was broken.
[[nodiscard]] Result<RelayedMessage> decodeRelayed(std::span<const std::byte> bytes);

} // namespace carina
