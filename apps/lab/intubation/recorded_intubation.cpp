#include "apps/lab/intubation/recorded_intubation.h"

#include "engine/core/expects.h"
#include "engine/tracking/record/recorded_tracker.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

const RecordedTool* toolOf(const TrackerSequence& recording, ToolRole role)
{
    const auto found = std::ranges::find_if(recording.tools, [role](const RecordedTool& tool) {
        return tool.role == role && !tool.samples.empty();
    });
    return found == recording.tools.end() ? nullptr : &*found;
}

SessionTime firstOf(const TrackerSequence& recording)
{
    SessionTime first = SessionTime::max();
    for (const RecordedTool& tool : recording.tools)
        if (!tool.samples.empty())
            first = std::min(first, tool.samples.front().time);
    return first;
}

std::optional<RigidTransform> seenAt(const std::optional<PoseSample>& sample)
{
    const bool isSeen = sample && sample->validity != Validity::Lost;
    return isSeen ? std::optional{sample->X_FO} : std::nullopt;
}

PoseSample lostAt(SessionTime t, const RigidTransform& X_FO)
{
    return {.time = t, .X_FO = X_FO, .validity = Validity::Lost};
}

} // namespace

Result<WatchedIntubation> watchRecording(const IntubationSubject& subject,
                                         const TrackerSequence& recording,
                                         const RecordingSetup& setup)
{
    const RecordedTool* tube = toolOf(recording, ToolRole::Tube);
    if (tube == nullptr)
        return fail(Errc::NothingRecognised, "the recording has no tube: no tool with a pose has "
                                             "this role, or is called Tube or ETT");
    WatchedIntubation watched;
    watched.commands = setup.commands;
    const SessionTime first = firstOf(recording);
    const SessionTime begins = setup.begins.value_or(first);
    watched.length = tube->samples.back().time - begins;
    const auto tracker = std::make_shared<RecordedTracker>(recording, ReadSessionClock{});
    const StationTracking station{tracker, setup.registration};
    tracker->advance(kTrialStart + (first - begins)); // when its first sample is due
    const auto connectorAt = [&station](SessionTime t) {
        return seenAt(station.at(ToolRole::Tube, t));
    };
    IntubationWatcher watcher{subject, setup.blade, connectorAt, watched};
    watcher.expect(setup.expected);
    for (const PoseSample& sample : tube->samples) {
        const Duration since = sample.time - begins;
        const SessionTime t = kTrialStart + since;
        tracker->advance(t + kReadBehind);
        const auto X_AE = station.at(ToolRole::Tube, t);
        if (!X_AE)
            continue; // it waits for the probe of the manikin
        watcher.take({.tube = *X_AE,
                      .laryngoscope = station.at(ToolRole::Laryngoscope, t).value_or(lostAt(t, {})),
                      .jaw = station.at(ToolRole::Jaw, t).value_or(lostAt(t, subject.motion->held)),
                      .head = setup.headAt(since)});
    }
    watcher.finish();
    return watched;
}

TrackerSequence recordingOf(const ObservedMotion& seen)
{
    return {{{.name = "Tube", .role = ToolRole::Tube, .samples = seen.tube},
             {.name = "Laryngoscope", .role = ToolRole::Laryngoscope, .samples = seen.laryngoscope},
             {.name = "Jaw", .role = ToolRole::Jaw, .samples = seen.jaw}}};
}

} // namespace carina::lab
