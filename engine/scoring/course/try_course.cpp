#include "engine/scoring/course/try_course.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{
namespace
{

bool isIntoALung(const IntubationEvent& event)
{
    return event.step == IntubationStep::FirstBreath && event.seat != TubeSeat::None
           && event.seat != TubeSeat::Oesophagus;
}

} // namespace

TryCourse::TryCourse(const Vec3& up_F) : m_plane{up_F}, m_hand{up_F}, m_head{up_F} {}

void TryCourse::add(const IntubationEvent& event)
{
    if (!hasBegun() && !beginsTry(event.step))
        return;
    if (m_events.size() < kMostEvents)
        m_events.push_back(event);
    follow(event);
}

void TryCourse::follow(const IntubationEvent& event)
{
    switch (event.step) {
    case IntubationStep::BladeIn:
        m_bladeIsIn = true;
        m_blade.bladeIn(event.at);
        break;
    case IntubationStep::BladeOut:
        m_bladeIsIn = false;
        measure(m_blade.bladeOut(event.at));
        m_plane.pause();
        m_hand.pause();
        break;
    case IntubationStep::TubePastTeeth:
        m_tubeIsIn = true;
        break;
    case IntubationStep::TubeOut:
        m_tubeIsIn = false;
        break;
    case IntubationStep::FirstBreath:
        if (isIntoALung(event))
            m_firstBreath = event.at;
        break;
    case IntubationStep::BackAboveCords:
        m_firstBreath.reset();
        break;
    default:
        break;
    }
    if (m_bladeIsIn || m_tubeIsIn)
        m_outSince.reset();
    else if (!m_outSince)
        m_outSince = event.at;
}

void TryCourse::addVitals(SessionTime t, const Vitals& vitals)
{
    if (hasBegun())
        m_oxygen.add(t, vitals);
}

void TryCourse::addBlade(const PoseSample& X_FL)
{
    m_blade.add(X_FL);
    measure(m_blade.inMouthUntil(X_FL.time - BladeSamples::kKnownAfter));
}

void TryCourse::measure(const std::vector<PoseSample>& blade)
{
    for (const PoseSample& X_FL : blade) {
        m_plane.add(X_FL);
        m_hand.add(X_FL);
    }
}

void TryCourse::addHead(const PoseSample& X_FH)
{
    if (hasBegun())
        m_head.add(X_FH);
}

void TryCourse::addForces(SessionTime t, Force incisors, Force tongue)
{
    if (!hasBegun())
        return;
    m_incisors.add(t, incisors);
    m_tongue.add(t, tongue);
}

void TryCourse::addHeadExtension(Angle extension)
{
    if (hasBegun() && !m_headExtension)
        m_headExtension = extension;
}

std::optional<SessionTime> TryCourse::endedBy(SessionTime now) const
{
    if (!hasBegun())
        return std::nullopt;
    if (m_firstBreath && now - *m_firstBreath >= kVentilatedFor)
        return *m_firstBreath + kVentilatedFor;
    if (m_outSince && now - *m_outSince >= kOutFor)
        return *m_outSince;
    const SessionTime latest = m_events.front().at + kLongestTry;
    return now >= latest ? std::optional{latest} : std::nullopt;
}

TryMetrics TryCourse::metrics(SessionTime ended, std::optional<Length> depthWanted) const
{
    CARINA_EXPECTS(hasBegun());
    TryCourse whole = *this;
    whole.measure(whole.m_blade.inMouthUntil(ended));
    std::vector<IntubationEvent> within = m_events;
    std::erase_if(within, [&](const IntubationEvent& event) {
        return event.at > std::max(ended, m_events.front().at);
    });
    TryMetrics metrics = courseOf(within, std::max(ended, m_events.front().at));
    metrics.depthWanted = depthWanted;
    metrics.headExtension = m_headExtension;
    metrics.oxygen = m_oxygen.figures();
    metrics.incisors = m_incisors.figures();
    metrics.tongue = m_tongue.figures();
    metrics.plane = whole.m_plane.figures();
    metrics.hand = whole.m_hand.figures();
    metrics.head = m_head.figures();
    metrics.checks = m_checks;
    return metrics;
}

} // namespace carina
