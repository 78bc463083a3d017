#pragma once

#include <chrono>
#include <thread>

namespace carina
{

/// Has a thread end by itself: it is asked to stop, and joined by another thread. For one that may
/// wait for a device, and whose owner must not wait for it. At its end the program waits for all of
/// them together, but not longer than kLongestAtTheEnd: a driver that lets none go must not keep
/// it. The thread may use only what it owns.
void joinLater(std::jthread thread);

inline constexpr std::chrono::seconds kLongestAtTheEnd{2};

} // namespace carina
