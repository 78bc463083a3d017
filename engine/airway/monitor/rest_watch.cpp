#include "engine/airway/monitor/rest_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// Along the tube, or above the carina: a neck that is flexed moves the tip by the second alone.
Length apart(const TipReading& a, const TipReading& b)
{
    return metres(std::max(std::abs((a.depthAtTeeth - b.depthAtTeeth).si),
                           std::abs((a.aboveCarina - b.aboveCarina).si)));
}

/// Of a mean over one sample less.
void add(Length& mean, Length sample, int samples)
{
    mean = mean + (1.0 / samples) * (sample - mean);
}

} // namespace

std::optional<IntubationEvent> RestWatch::take(const IntubationMonitor& monitor)
{
    const IntubationCourse& course = monitor.course();
    if (!isThroughCords(course.seat) || course.shapes.isIn) {
        m_place.reset();
        return std::nullopt;
    }
    const TipReading& tip = course.tip;
    const SessionTime before = std::exchange(m_seen, tip.at);
    if (tip.at == before)
        return std::nullopt; // it was not seen
    if (!m_place || tip.at - before > Crossing::kUnseen || apart(*m_place, tip) > kStill) {
        m_place = tip;
        m_samples = 0;
    }
    ++m_samples;
    add(m_mean.depthAtTeeth, tip.depthAtTeeth, m_samples);
    add(m_mean.aboveCarina, tip.aboveCarina, m_samples);
    if (tip.at - m_place->at < kRest || apart(m_noted, m_mean) <= kElsewhere)
        return std::nullopt;
    IntubationEvent event = monitor.told(IntubationStep::AtRest, tip.at);
    event.depthAtTeeth = m_mean.depthAtTeeth;
    event.tipAboveCarina = m_mean.aboveCarina;
    note(event);
    return event;
}

void RestWatch::note(const IntubationEvent& event)
{
    m_noted = {event.at, event.depthAtTeeth, event.tipAboveCarina, event.besides};
}

} // namespace carina
