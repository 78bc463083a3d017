#include "apps/program/heap.h"

#include <jemalloc/jemalloc.h>
#include <string>
#include <sys/types.h>

namespace carina::program
{
namespace
{

unsigned arenas()
{
    unsigned count = 0;
    std::size_t size = sizeof count;
    return mallctl("arenas.narenas", &count, &size, nullptr, 0) == 0 ? count : 0;
}

/// What is not there yet takes what is set for those to come.
void set(const std::string& name, ssize_t value)
{
    static_cast<void>(mallctl(name.c_str(), nullptr, nullptr, &value, sizeof value));
}

/// Of the pages that are free, and of those that the system may take, both.
void setDecay(const std::string& of, Duration time)
{
    set(of + ".dirty_decay_ms",
        std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
    set(of + ".muzzy_decay_ms", 0);
}

} // namespace

void keepFreePagesFor(Duration time)
{
    setDecay("arenas", time);
    for (unsigned i = 0; i < arenas(); ++i)
        setDecay("arena." + std::to_string(i), time);
}

} // namespace carina::program
