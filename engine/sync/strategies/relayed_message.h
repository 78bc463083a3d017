#pragma once

#include "engine/core/ids.h"
#include "engine/core/result.h"
#include "engine/sync/wire/event_cpo.h"

#include <span>
#include <variant>
#include <vector>

namespace carina
{

/// Asks for an answer at once.
struct DelayProbe {
    Duration sentAt{}; ///< on the asker's clock
};
/// The answer, with the probe's time.
struct DelayAnswer {
    Duration sentAt{};
};

/// What the strategies of before the session clock send each other: from one participant to
/// another, or to all others, over a host that passes it on at once and as it is.
struct RelayedMessage {
    ParticipantId from;
    ParticipantId to;
    std::variant<EventCpo, DelayProbe, DelayAnswer> content;
};

/// Stands for all participants but the sender.
inline constexpr ParticipantId kAllOthers{0xFFFF};

/// @pre numbers within their ranges (engine/sync/wire/cpo_codec.h)
[[nodiscard]] std::vector<std::byte> encodeRelayed(const RelayedMessage& message);
/// @returns PacketMalformed, naming the rule that was broken.
[[nodiscard]] Result<RelayedMessage> decodeRelayed(std::span<const std::byte> bytes);

} // namespace carina
