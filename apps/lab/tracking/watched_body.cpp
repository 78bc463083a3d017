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

template <class Tool>
tl::unexpected<Error> noSuchTool(const std::string& where, const std::string& tool,
                                 const std::vector<Tool>& there)
{
    std::string names;
    for (const Tool& each : there)
        names += (names.empty() ? "\"" : ", \"") + each.name + '"';
    return fail(Errc::WrongOption, where + " has no tool \"" + tool + "\"; it has "
                                       + (names.empty() ? "none" : names));
}

/// A device at work, and what it has seen so far.
struct Watch {
    std::unique_ptr<Tracker> tracker;
    TrackedTool tool;
    BodySamples samples{};

    void look()
    {
        for (const PoseSample& sample : tool.history->samples())
            if (samples.empty() || sample.time > samples.back().time)
                samples.push_back(sample);
    }

    [[nodiscard]] bool hasSeen() const
    {
        return std::ranges::any_of(
            samples, [](const PoseSample& sample) { return sample.validity != Validity::Lost; });
    }
};

Result<Watch> begin(const Watcher& watcher)
{
    auto tracker = describedTracker(watcher.described, watchNow);
    if (!tracker)
        return tl::unexpected(tracker.error());
    const auto tools = (*tracker)->tools();
    const auto tool = std::ranges::find(tools, watcher.tool, &TrackedTool::name);
    if (tool == tools.end())
        return noSuchTool(watcher.described.address, watcher.tool, tools);
    if (const auto started = (*tracker)->start(); !started)
        return tl::unexpected(started.error());
    return Watch{*std::move(tracker), *tool};
}

Result<BodySamples> end(Watch& watch, const Watcher& watcher)
{
    watch.tracker->stop();
    watch.look();
    if (watch.hasSeen())
        return std::move(watch.samples);
    const std::string trouble = watch.tracker->trouble();
    return fail(Errc::TrackerFailed, watcher.described.address + ": \"" + watcher.tool
                                         + "\" was not seen"
                                         + (trouble.empty() ? "" : ": " + trouble));
}

} // namespace

Result<WatchedBody> watchBody(const Watcher& first, const Watcher& second, Duration duration)
{
    auto one = begin(first);
    if (!one)
        return tl::unexpected(one.error());
    auto other = begin(second);
    if (!other)
        return tl::unexpected(other.error());
    for (const LocalTime until = monotonicNow() + duration; monotonicNow() < until;) {
        std::this_thread::sleep_for(kBetweenLooks);
        one->look();
        other->look();
    }
    auto seen = end(*one, first);
    if (!seen)
        return tl::unexpected(seen.error());
    return end(*other, second).map([&](BodySamples samples) {
        return WatchedBody{*std::move(seen), std::move(samples)};
    });
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
        return noSuchTool(file, tool, sequence->tools);
    return std::move(found->samples);
}

} // namespace carina::lab
