#pragma once

#include "engine/core/byte_buffer.h"
#include "engine/sync/wire/event_cpo.h"
#include "engine/sync/wire/stream_cpo.h"

namespace carina
{

inline constexpr std::size_t kStreamGroupHeaderBytes = 11;
inline constexpr std::size_t kStreamCpoBytes = 37; ///< without a form
inline constexpr std::size_t kStreamShapeBytes = 26;
inline constexpr std::size_t kEventCpoBytes = 93;
/// By how much the length of a quaternion that arrives may differ from 1.
inline constexpr double kUnitTolerance = 1e-9;

/// Whether a form can be encoded with a sample of this time: its ranges are those of StreamShape.
[[nodiscard]] bool isInRange(const StreamShape& shape, SessionTime ofSample);
/// What a sample is encoded to.
[[nodiscard]] std::size_t bytesOf(const StreamCpo& stream);

/// @pre 1 to kStreamsPerGroup streams within kGroupTimeSpan of the first, together no longer than
///      so many without forms; all numbers finite.
void writeStreamGroup(ByteWriter& out, const StreamGroup& group);
/// The result is valid only if in.ok() is true afterwards.
[[nodiscard]] StreamGroup readStreamGroup(ByteReader& in);

/// @pre all numbers finite, quaternion and axis of unit length, scale above 0.
void writeEventCpo(ByteWriter& out, const EventCpo& event);
/// The result is valid only if in.ok() is true afterwards.
[[nodiscard]] EventCpo readEventCpo(ByteReader& in);

} // namespace carina
