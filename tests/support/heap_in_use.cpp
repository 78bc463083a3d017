#include "tests/support/heap_in_use.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <malloc.h>

namespace
{

std::atomic<std::int64_t> bytesInUse{0};

void* taken(void* block)
{
    bytesInUse.fetch_add(static_cast<std::int64_t>(malloc_usable_size(block)),
                         std::memory_order_relaxed);
    return block;
}

void given(void* block)
{
    bytesInUse.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(block)),
                         std::memory_order_relaxed);
}

} // namespace

// glibc's own functions under the names by which it lets others wrap them.
extern "C" {

void* __libc_malloc(std::size_t size);                          // NOLINT
void* __libc_calloc(std::size_t count, std::size_t size);       // NOLINT
void* __libc_realloc(void* block, std::size_t size);            // NOLINT
void* __libc_memalign(std::size_t alignment, std::size_t size); // NOLINT
void __libc_free(void* block);                                  // NOLINT

void* malloc(std::size_t size) { return taken(__libc_malloc(size)); }

void* calloc(std::size_t count, std::size_t size) { return taken(__libc_calloc(count, size)); }

void* realloc(void* block, std::size_t size)
{
    const auto before = static_cast<std::int64_t>(malloc_usable_size(block));
    void* moved = __libc_realloc(block, size);
    if (moved != nullptr || size == 0) // else the block is as it was
        bytesInUse.fetch_sub(before, std::memory_order_relaxed);
    return taken(moved);
}

void* memalign(std::size_t alignment, std::size_t size)
{
    return taken(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size)
{
    return taken(__libc_memalign(alignment, size));
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size)
{
    void* made = __libc_memalign(alignment, size);
    if (made == nullptr)
        return ENOMEM;
    *block = taken(made);
    return 0;
}

void free(void* block)
{
    given(block);
    __libc_free(block);
}

} // extern "C"

namespace carina::test
{

std::int64_t heapInUse() { return bytesInUse.load(std::memory_order_relaxed); }

} // namespace carina::test
