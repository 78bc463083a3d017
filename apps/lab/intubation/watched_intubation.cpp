#include "apps/lab/intubation/watched_intubation.h"

#include <algorithm>

namespace carina::lab
{

std::optional<IntubationStep> toldBy(MotionAct act)
{
    switch (act) {
    case MotionAct::CuffInflated:
        return IntubationStep::CuffInflated;
    case MotionAct::CuffDeflated:
        return IntubationStep::CuffDeflated;
    case MotionAct::StyletOut:
        return IntubationStep::StyletOut;
    case MotionAct::BreathsBegin:
        return IntubationStep::FirstBreath;
    case MotionAct::BreathsEnd:
        break;
    }
    return std::nullopt;
}

std::vector<IntubationEvent> WatchedIntubation::byTime() const
{
    std::vector<IntubationEvent> events;
    for (const NotedStep& step : noted)
        events.push_back(step.event);
    std::ranges::stable_sort(events, {}, &IntubationEvent::at);
    return events;
}

void IntubationWatcher::take(const SeenTools& tools)
{
    tellUntil(tools.tube.time);
    for (const IntubationEvent& event : m_monitor.take(m_airway.take(tools)))
        note(tools.tube.time, event);
    if (const auto rest = m_rest.take(m_monitor))
        note(tools.tube.time, *rest);
    measure(tools);
}

void IntubationWatcher::finish()
{
    tellUntil(SessionTime::max());
    m_watched.course = m_monitor.course();
}

/// What people say by their controls until then.
void IntubationWatcher::tellUntil(SessionTime t)
{
    const std::vector<MotionCommand>& commands = m_watched.commands;
    for (; m_told < commands.size(); ++m_told) {
        const SessionTime at = kTrialStart + commands[m_told].at;
        if (at > t)
            return;
        if (const auto step = toldBy(commands[m_told].act))
            note(at, m_monitor.told(*step, at));
    }
}

void IntubationWatcher::note(SessionTime now, const IntubationEvent& event)
{
    m_rest.note(event);
    m_watched.noted.push_back({now, event});
    m_watched.measured.add(event);
}

void IntubationWatcher::measure(const SeenTools& tools)
{
    m_watched.measured.addBlade(tools.laryngoscope);
    m_watched.measured.addHeadExtension(tools.head.extension);
    if (tools.laryngoscope.validity == Validity::Lost)
        return;
    const BladeEffort& effort = m_airway.effort();
    m_watched.measured.addForces(tools.laryngoscope.time, effort.teeth, effort.contact.tongue);
}

} // namespace carina::lab
