#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace carina
{

/// Calls `work(i)` once for every i below `count`, on as many threads of Qt as there are cores, but
/// at most `mostThreads`, and returns when all are done. Each thread calls `makeWork` for a `work`
/// of its own, which may hold objects that belong to the thread.
///
/// `goOn(done)` is called in the calling thread, at first and repeatedly, with the number of calls
/// that have ended; when it returns false no further call is begun.
///
/// @returns false when `goOn` stopped it.
[[nodiscard]] bool inParallel(std::size_t count,
                              const std::function<std::function<void(std::size_t)>()>& makeWork,
                              const std::function<bool(std::size_t)>& goOn,
                              std::size_t mostThreads = SIZE_MAX);

} // namespace carina
