#include "engine/scoring/course/told_place.h"

namespace carina
{
namespace
{

/// Above the cords, in the airway or in the oesophagus.
TubeSeat wayOf(TubeSeat seat) { return isInMainBronchus(seat) ? TubeSeat::Trachea : seat; }

} // namespace

std::vector<IntubationEvent> ToldPlace::noted(const IntubationEvent& event)
{
    if (wayOf(event.seat) != wayOf(m_last.seat)) {
        m_passedAt = event.at;
        m_breath.reset();
    }
    m_last = event;
    if (event.step == IntubationStep::FirstBreath) {
        if (m_breath)
            return {}; // of the other place that was told
        m_breath = event;
    }
    if (!m_told)
        return {event};
    if (isOfWay(event.step))
        return {};
    if (event.step != IntubationStep::TubeOut)
        return {asTold(event)};
    std::vector<IntubationEvent> steps = between(*m_told, TubeSeat::None, m_passedAt);
    m_told.reset();
    steps.push_back(event);
    return steps;
}

std::vector<IntubationEvent> ToldPlace::told(std::optional<TubeSeat> seat, SessionTime since)
{
    if (seat == m_told)
        return {};
    const TubeSeat from = m_told.value_or(m_last.seat);
    const TubeSeat to = seat.value_or(m_last.seat);
    m_told = seat;
    std::vector<IntubationEvent> steps =
        between(from, to, m_last.seat == TubeSeat::None ? since : m_passedAt);
    if (!steps.empty() && m_breath)
        steps.push_back(asTold(*m_breath));
    return steps;
}

IntubationEvent ToldPlace::asTold(IntubationEvent event) const
{
    if (!m_told)
        return event;
    event.seat = *m_told;
    event.confidence = 1.0;
    return event;
}

std::vector<IntubationEvent> ToldPlace::between(TubeSeat from, TubeSeat to, SessionTime at) const
{
    std::vector<IntubationEvent> steps;
    const auto step = [&](IntubationStep what, TubeSeat seat) {
        IntubationEvent event = m_last;
        event.step = what;
        event.at = at;
        event.seat = seat;
        event.confidence = m_told ? 1.0 : m_last.confidence;
        steps.push_back(event);
    };
    if (from == to)
        return steps;
    if (from == TubeSeat::Oesophagus)
        step(IntubationStep::OutOfOesophagus, TubeSeat::None);
    if (isInMainBronchus(from))
        step(IntubationStep::BackAboveCarina, TubeSeat::Trachea);
    if (isThroughCords(from) && !isThroughCords(to))
        step(IntubationStep::BackAboveCords, TubeSeat::None);
    if (to == TubeSeat::Oesophagus)
        step(IntubationStep::InOesophagus, TubeSeat::Oesophagus);
    if (isThroughCords(to) && !isThroughCords(from))
        step(IntubationStep::ThroughCords, TubeSeat::Trachea);
    if (isInMainBronchus(to))
        step(IntubationStep::PastCarina, to);
    return steps;
}

} // namespace carina
