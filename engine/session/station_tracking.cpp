#include "engine/session/station_tracking.h"

#include "engine/tracking/reframed.h"

#include <algorithm>

namespace carina
{

StationTracking::StationTracking(std::unique_ptr<Tracker> tracker,
                                 const StationRegistration& registration)
    : m_tracker{std::move(tracker)}, m_tools{m_tracker->tools()}, m_registration{registration}
{
}

Result<void> StationTracking::start() { return m_tracker->start(); }

std::optional<PoseSample> StationTracking::at(ToolRole role, SessionTime t) const
{
    const PoseHistory* history = historyOf(role);
    return history ? told(role, history->at(t)) : std::nullopt;
}

std::optional<PoseSample> StationTracking::told(ToolRole role, std::optional<PoseSample> X_TO) const
{
    if (!X_TO)
        return std::nullopt;
    const PoseSample sample_A = reframed(m_registration.X_AT, *X_TO);
    return role == ToolRole::Jaw ? attached(sample_A, m_registration.X_JA) : sample_A;
}

std::optional<PoseSample> StationTracking::newest(ToolRole role) const
{
    const PoseHistory* history = historyOf(role);
    const auto sample = history ? history->newest() : std::nullopt;
    return sample ? at(role, sample->time) : std::nullopt;
}

const PoseHistory* StationTracking::historyOf(ToolRole role) const
{
    const auto tool = std::ranges::find(m_tools, role, &TrackedTool::role);
    return tool != m_tools.end() ? tool->history : nullptr;
}

} // namespace carina
