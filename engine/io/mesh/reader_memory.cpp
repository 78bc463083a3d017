#include "engine/io/mesh/reader_memory.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace carina
{
namespace
{

constexpr unsigned kFewestShares = 4;
constexpr unsigned kMostShares = 16;
constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30U;

std::uint64_t wholeBytes()
{
    static const std::uint64_t kBytes = [] {
        const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
        return std::min(kMostBytes, pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 2);
    }();
    return kBytes;
}

struct Shares {
    std::mutex mutex;
    std::condition_variable changed;
    unsigned free = ReaderMemory::shares();
    unsigned wholeWanted = 0;
};

Shares& allShares()
{
    static Shares shares;
    return shares;
}

} // namespace

unsigned ReaderMemory::shares()
{
    return std::clamp(std::thread::hardware_concurrency(), kFewestShares, kMostShares);
}

std::uint64_t ReaderMemory::bytesOf(unsigned count) { return wholeBytes() / shares() * count; }

bool ReaderMemory::take(unsigned count, std::chrono::milliseconds patience)
{
    Shares& all = allShares();
    std::unique_lock lock{all.mutex};
    const bool whole = count == shares();
    if (whole)
        ++all.wholeWanted;
    const bool taken = all.changed.wait_for(
        lock, patience, [&] { return all.free >= count && (whole || all.wholeWanted == 0); });
    if (whole)
        --all.wholeWanted;
    if (taken)
        all.free -= count;
    all.changed.notify_all();
    return taken;
}

void ReaderMemory::giveBack(unsigned count)
{
    Shares& all = allShares();
    const std::lock_guard lock{all.mutex};
    all.free += count;
    all.changed.notify_all();
}

bool ReaderMemory::isWantedWhole()
{
    Shares& all = allShares();
    const std::lock_guard lock{all.mutex};
    return all.wholeWanted > 0;
}

} // namespace carina
