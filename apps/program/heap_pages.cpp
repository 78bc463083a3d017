#include "apps/program/heap_pages.h"

#include <condition_variable>
#include <malloc.h>
#include <mutex>

namespace carina::program
{

void useOneHeap()
{
    constexpr int kLarge = 128 << 10;
    mallopt(M_MMAP_THRESHOLD, kLarge);
    mallopt(M_ARENA_MAX, 1);
}

void returnFreePages() { malloc_trim(0); }

HeapPages::HeapPages(Duration interval)
    : m_thread{[interval](const std::stop_token& stopping) {
          std::mutex mutex;
          std::condition_variable_any ending;
          std::unique_lock lock{mutex};
          const auto isOver = [&] { return stopping.stop_requested(); };
          while (!ending.wait_for(lock, stopping, interval, isOver))
              returnFreePages();
      }}
{
}

} // namespace carina::program
