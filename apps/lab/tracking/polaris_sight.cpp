#include "apps/lab/tracking/polaris_sight.h"

#include "apps/lab/command/patient_options.h"
#include "apps/lab/command/scripted_station.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/tracking/record/recorded_tracker.h"

#include <algorithm>
#include <memory>

namespace carina::lab
{
namespace
{

constexpr Duration kStale = std::chrono::milliseconds{200}; // a recorded pose; then none is stated
// A period of the simulated tracker, and a little: so far it looks ahead.
constexpr Duration kNextSample = std::chrono::milliseconds{17};

std::optional<SessionTime> noClock() { return std::nullopt; }

PolarisPose stated(const PoseSample& sample)
{
    return {sample.X_FO.rotation(), 1e3 * sample.X_FO.translation(), 1e3 * sample.error};
}

/// What a pose is computed from.
Probe probeOf(const PolarisTool& tool)
{
    Probe probe{.largestAngle = degrees(tool.largestAngle_deg),
                .fewest = tool.fewestMarkers,
                .largestMisfit = millimetres(tool.largestError_mm)};
    for (const PolarisTool::Marker& marker : tool.markers)
        probe.markers.push_back({1e-3 * marker.p_mm, marker.normal});
    return probe;
}

/// The true poses of the tools.
Result<TrueToolPose> scriptedHands(const Words& words)
{
    const auto parameters = patientOption(words, BuiltinPatient::TwelveYears);
    if (!parameters)
        return tl::unexpected(parameters.error());
    return scriptedStation(*parameters).map([](ScriptedStation&& scripted) {
        return std::move(scripted.station.truth);
    });
}

} // namespace

std::vector<NamedTool> scriptedTools()
{
    return {{"head", ToolRole::Head},
            {"jaw", ToolRole::Jaw},
            {"tube", ToolRole::Tube},
            {"stylus", ToolRole::Stylus}};
}

/// At the time of an exposure the pose is between two samples: the hands are scripted, so that the
/// tracker can be asked for the next one.
Result<SeenPose> scriptedSight(const Words& words, const PolarisTools& tools)
{
    auto hands = scriptedHands(words);
    if (!hands)
        return tl::unexpected(hands.error());
    SimulatedTrackerSettings settings;
    settings.latency = Duration::zero();
    for (const DescribedTool& tool : tools.described)
        settings.probes[tool.role] = probeOf(tools.known.at(tool.name));
    // Shared by the copies of the function, however many are made.
    const auto tracker =
        std::make_shared<SimulatedTracker>(std::move(settings), *std::move(hands), noClock);
    const std::vector<TrackedTool> tracked = tracker->tools();
    std::vector<const PoseHistory*> seen;
    for (const auto& [name, role] : scriptedTools())
        seen.push_back(std::ranges::find(tracked, role, &TrackedTool::role)->history);
    return [tracker, seen = std::move(seen)](std::size_t tool,
                                             LocalTime t) -> std::optional<PolarisPose> {
        const SessionTime exposed{t.time_since_epoch()};
        tracker->advance(exposed);
        tracker->advance(exposed + kNextSample);
        const auto sample = seen[tool]->at(exposed);
        if (!sample || sample->validity == Validity::Lost)
            return std::nullopt;
        return stated(*sample);
    };
}

SeenPose recordedSight(const TrackerSequence& sequence)
{
    // Shared by the copies of the function, however many are made.
    const auto played = std::make_shared<RecordedTracker>(sequence, noClock, Playing::Looped);
    return [played, tools = played->tools()](std::size_t tool,
                                             LocalTime t) -> std::optional<PolarisPose> {
        const SessionTime now{t.time_since_epoch()};
        static_cast<void>(played->advance(now));
        const auto newest = tools[tool].history->newest();
        if (!newest || newest->validity == Validity::Lost || now - newest->time > kStale)
            return std::nullopt;
        return stated(*newest);
    };
}

} // namespace carina::lab
