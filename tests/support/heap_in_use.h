#pragma once

#include <cstdint>

namespace carina::test
{

/// The bytes that this process has allocated from the heap and not freed, in all threads. Exact at
/// any time: unlike mallinfo2() it does not count what glibc keeps for later. A program that links
/// heap_in_use.cpp has its malloc and free wrapped.
[[nodiscard]] std::int64_t heapInUse();

} // namespace carina::test
