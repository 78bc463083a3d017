#pragma once

#include <thread>

namespace carina
{

/// Has a thread end by itself: it is asked to stop, and joined by another thread, or at the end of
/// the program. For one that may wait for a device, and whose owner must not wait for it. It may
/// use only what it owns.
void joinLater(std::jthread thread);

} // namespace carina
