#pragma once

#include <cstddef>
#include <functional>

namespace carina
{

/// Calls `work(i)` once for every i below `count`, on as many threads of Qt as there are cores, and
/// returns when all are done. Each thread makes its own `work`, so that it may hold what belongs to
/// a thread.
///
/// `goOn(done)` is called in the calling thread, first and every now and then, with the number of
/// calls that have ended; when it answers false no further one is begun.
///
/// @returns false when `goOn` stopped it.
[[nodiscard]] bool inParallel(std::size_t count,
                              const std::function<std::function<void(std::size_t)>()>& makeWork,
                              const std::function<bool(std::size_t)>& goOn);

} // namespace carina
