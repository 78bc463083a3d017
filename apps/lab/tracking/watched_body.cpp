#include "apps/lab/tracking/watched_body.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/devices/any_recording.h"
#include "engine/net/devices/described_tracker.h"

#include <algorithm>
#include <thread>

namespace carina::lab
{
namespace
{

constexpr std::chrono::milliseconds kBetweenLooks{50};

std::optional<SessionTime> watchNow() { return SessionTime{monotonicNow().time_since_epoch()}; }

Result<BodyWatcher> watcherOf(const Watcher& watcher)
{
    return describedTracker(watcher.described, watchNow).map([&](std::unique_ptr<Tracker> tracker) {
        return BodyWatcher{std::move(tracker), watcher.described.address, watcher.tool};
    });
}

tl::unexpected<Error> notRecorded(const std::string& file, const std::string& tool,
                                  const std::vector<RecordedTool>& there)
{
    std::string names;
    for (const RecordedTool& each : there)
        names += (names.empty() ? "\"" : ", \"") + each.name + '"';
    return fail(Errc::WrongOption,
                file + " has no tool \"" + tool + "\"; it has " + (names.empty() ? "none" : names));
}

} // namespace

Result<WatchedBody> watchBody(const Watcher& first, const Watcher& second, Duration duration)
{
    auto one = watcherOf(first);
    if (!one)
        return tl::unexpected(one.error());
    auto other = watcherOf(second);
    if (!other)
        return tl::unexpected(other.error());
    auto watch = BodyWatch::begin(*std::move(one), *std::move(other));
    if (!watch)
        return tl::unexpected(watch.error());
    for (const LocalTime until = monotonicNow() + duration; monotonicNow() < until;) {
        std::this_thread::sleep_for(kBetweenLooks);
        watch->look();
    }
    return watch->end();
}

Result<BodySamples> recordedBody(const std::string& file, const std::string& tool)
{
    if (!file.ends_with(".csv"))
        return fail(Errc::WrongOption, file + ": a recording in Carina's own form (.csv) is due");
    auto sequence = readAnyRecording(file);
    if (!sequence)
        return tl::unexpected(sequence.error());
    const auto found = std::ranges::find(sequence->tools, tool, &RecordedTool::name);
    if (found == sequence->tools.end())
        return notRecorded(file, tool, sequence->tools);
    return std::move(found->samples);
}

} // namespace carina::lab
