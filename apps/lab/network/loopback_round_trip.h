#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"

namespace carina::lab
{

/// What the computer itself needs for a message between two of its programs, before anything of
/// ours is done with it: live figures cannot be better.
struct LoopbackRoundTrip {
    Duration median{};
    Duration p95{};
};

/// Measures the time from sending a datagram on loopback until its answer by another thread, which
/// sleeps in between, as programs do: 400 times, in a second.
/// @returns AddressInUse, Cancelled where an answer does not come
[[nodiscard]] Result<LoopbackRoundTrip> loopbackRoundTrip();

} // namespace carina::lab
