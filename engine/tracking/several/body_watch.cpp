#include "engine/tracking/several/body_watch.h"

#include <algorithm>
#include <set>
#include <utility>

namespace carina
{
namespace
{

/// Both saw the body in a slot where each has a sample in it in which the body is seen.
constexpr Duration kSlot = std::chrono::milliseconds{100};
/// A device that is so far behind the other one delivers nothing.
constexpr Duration kBehind = std::chrono::milliseconds{500};

std::set<std::int64_t> slotsOf(const BodySamples& samples)
{
    std::set<std::int64_t> slots;
    for (const PoseSample& sample : samples)
        if (sample.validity != Validity::Lost)
            slots.insert(sample.time.time_since_epoch() / kSlot);
    return slots;
}

bool isSeenIn(const BodySamples& samples)
{
    return std::ranges::any_of(
        samples, [](const PoseSample& sample) { return sample.validity != Validity::Lost; });
}

} // namespace

Result<BodyWatch> BodyWatch::begin(BodyWatcher first, BodyWatcher second)
{
    auto one = beginOne(std::move(first));
    if (!one)
        return tl::unexpected(one.error());
    auto other = beginOne(std::move(second));
    if (!other)
        return tl::unexpected(other.error());
    return BodyWatch{*std::move(one), *std::move(other)};
}

Result<BodyWatch::Watched> BodyWatch::beginOne(BodyWatcher watcher)
{
    const auto tools = watcher.tracker->tools();
    const auto tool = std::ranges::find(tools, watcher.tool, &TrackedTool::name);
    if (tool == tools.end()) {
        std::string names;
        for (const TrackedTool& each : tools)
            names += (names.empty() ? "\"" : ", \"") + each.name + '"';
        return fail(Errc::WrongOption, watcher.name + " has no tool \"" + watcher.tool
                                           + "\"; it has " + (names.empty() ? "none" : names));
    }
    if (const auto started = watcher.tracker->start(); !started)
        return tl::unexpected(started.error());
    return Watched{std::move(watcher), tool->history};
}

void BodyWatch::look()
{
    lookAt(m_first);
    lookAt(m_second);
}

void BodyWatch::lookAt(Watched& watched)
{
    auto added = watched.history->since(watched.cursor);
    watched.cursor = added.cursor;
    for (PoseSample& sample : added.samples)
        if (watched.samples.empty() || sample.time > watched.samples.back().time)
            watched.samples.push_back(std::move(sample));
}

Duration BodyWatch::together() const
{
    const auto one = slotsOf(first());
    const auto other = slotsOf(second());
    return std::ranges::count_if(one, [&](std::int64_t slot) { return other.contains(slot); })
           * kSlot;
}

BodyWatch::Sight BodyWatch::sightOf(const Watched& watched) const
{
    Sight sight{.trouble = watched.watcher.tracker->trouble()};
    if (watched.samples.empty())
        return sight;
    SessionTime newest = watched.samples.back().time;
    for (const Watched* each : {&m_first, &m_second})
        if (!each->samples.empty())
            newest = std::max(newest, each->samples.back().time);
    sight.isSeen = watched.samples.back().validity != Validity::Lost
                   && newest - watched.samples.back().time <= kBehind;
    return sight;
}

Result<WatchedBody> BodyWatch::end()
{
    auto one = endOne(m_first);
    auto other = endOne(m_second);
    if (!one)
        return tl::unexpected(one.error());
    return other.map([&](BodySamples samples) {
        return WatchedBody{*std::move(one), std::move(samples)};
    });
}

Result<BodySamples> BodyWatch::endOne(Watched& watched)
{
    watched.watcher.tracker->stop();
    lookAt(watched);
    if (isSeenIn(watched.samples))
        return watched.samples;
    const std::string trouble = watched.watcher.tracker->trouble();
    return fail(Errc::TrackerFailed, watched.watcher.name + ": \"" + watched.watcher.tool
                                         + "\" was not seen"
                                         + (trouble.empty() ? "" : ": " + trouble));
}

} // namespace carina
