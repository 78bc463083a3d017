#include "engine/io/files/parallel.h"

#include <QThread>

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

namespace carina
{

bool inParallel(std::size_t count,
                const std::function<std::function<void(std::size_t)>()>& makeWork,
                const std::function<bool(std::size_t)>& goOn, std::size_t mostThreads)
{
    constexpr unsigned long kMillisecondsBetweenReports = 20;
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    std::atomic<bool> stopped{false};
    if (!goOn(0))
        return false;
    std::vector<std::unique_ptr<QThread>> threads;
    const auto cores = static_cast<std::size_t>(std::max(1, QThread::idealThreadCount()));
    for (std::size_t i = 0; i < std::min({cores, count, mostThreads}); ++i) {
        threads.emplace_back(QThread::create([&] {
            const auto work = makeWork();
            for (std::size_t k = next++; k < count && !stopped; k = next++) {
                work(k);
                ++done;
            }
        }));
        threads.back()->start();
    }
    for (const auto& thread : threads)
        while (!thread->wait(kMillisecondsBetweenReports))
            stopped = stopped || !goOn(done);
    return !stopped;
}

} // namespace carina
