#include "engine/session/station_tracking.h"

#include "engine/tracking/reframed.h"

#include <algorithm>

namespace carina
{

StationTracking::StationTracking(std::shared_ptr<Tracker> tracker,
                                 const StationRegistration& registration)
    : m_tracker{std::move(tracker)}, m_tools{m_tracker->tools()}, m_assumption{registration}
{
}

Result<void> StationTracking::start() { return m_tracker->start(); }

StationTracking::Assumption StationTracking::assumed() const
{
    const std::scoped_lock lock{m_mutex};
    return m_assumption;
}

void StationTracking::takeRegistration(const StationRegistration& registration)
{
    const std::scoped_lock lock{m_mutex};
    m_assumption.registration = registration;
    if (!registration.X_JA) // the manikin cannot go with a probe whose place on it is not known
        m_assumption.chin = ChinMotion::OfJaw;
}

bool StationTracking::hasChinProbe() const
{
    return historyOf(ToolRole::Jaw) && assumed().registration.X_JA;
}

bool StationTracking::hasBodyProbe() const
{
    return historyOf(ToolRole::Manikin) && assumed().registration.X_BA;
}

ChinMotion StationTracking::chinMotion() const { return assumed().chin; }

MotionAssumption StationTracking::motionAssumption() const
{
    if (hasBodyProbe())
        return MotionAssumption::BodyProbe;
    if (chinMotion() == ChinMotion::OfManikin)
        return MotionAssumption::ChinMovesManikin;
    return hasChinProbe() ? MotionAssumption::ChinMovesJaw : MotionAssumption::Static;
}

bool StationTracking::takeChinMotion(ChinMotion motion)
{
    if (!hasChinProbe() || hasBodyProbe())
        return false;
    const auto X_TJ = historyOf(ToolRole::Jaw)->newest();
    const std::scoped_lock lock{m_mutex};
    if (m_assumption.chin == ChinMotion::OfManikin && motion == ChinMotion::OfJaw && X_TJ)
        m_assumption.registration.X_AT = (X_TJ->X_FO * *m_assumption.registration.X_JA).inverse();
    m_assumption.chin = motion;
    return true;
}

std::optional<PoseSample> StationTracking::at(ToolRole role, SessionTime t) const
{
    return inAnatomy(role, [t](const PoseHistory& history) { return history.at(t); });
}

std::optional<PoseSample> StationTracking::shownAt(ToolRole role, SessionTime t) const
{
    return inAnatomy(role, [t](const PoseHistory& history) { return history.shownAt(t); });
}

std::optional<PoseSample> StationTracking::inAnatomy(ToolRole role, const ReadPose& read) const
{
    const PoseHistory* history = historyOf(role);
    const auto X_TO = history ? read(*history) : std::nullopt;
    if (!X_TO)
        return std::nullopt;
    const Assumption assumption = assumed();
    const StationRegistration& registration = assumption.registration;
    PoseSample sample_A;
    if (const auto carries = carrier(assumption)) {
        const auto X_TP = read(*historyOf(carries->probe));
        if (!X_TP)
            return std::nullopt;
        sample_A = reframed(carries->X_PA.inverse(), seenFrom(*X_TP, *X_TO));
    } else {
        sample_A = reframed(registration.X_AT, *X_TO);
    }
    if (role == ToolRole::Tube && registration.X_NE)
        return attached(sample_A, *registration.X_NE);
    if (role == ToolRole::Laryngoscope && registration.X_NL)
        return attached(sample_A, *registration.X_NL);
    if (role != ToolRole::Jaw)
        return sample_A;
    return registration.X_JA ? std::optional{attached(sample_A, *registration.X_JA)} : std::nullopt;
}

std::optional<StationTracking::Carrier> StationTracking::carrier(const Assumption& assumption) const
{
    const StationRegistration& registration = assumption.registration;
    if (registration.X_BA && historyOf(ToolRole::Manikin))
        return Carrier{ToolRole::Manikin, *registration.X_BA};
    if (assumption.chin == ChinMotion::OfManikin)
        return Carrier{ToolRole::Jaw, *registration.X_JA};
    return std::nullopt;
}

std::string StationTracking::toolName(ToolRole role) const
{
    const auto tool = std::ranges::find(m_tools, role, &TrackedTool::role);
    return tool != m_tools.end() ? tool->name : std::string{};
}

bool StationTracking::hasTool(ToolRole role) const
{
    return std::ranges::find(m_tools, role, &TrackedTool::role) != m_tools.end();
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
