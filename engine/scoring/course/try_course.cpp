#include "engine/scoring/course/try_course.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{
namespace
{

/// The first breath into a lung, of a tube that is still there.
std::optional<SessionTime> firstBreathIn(std::span<const IntubationEvent> course)
{
    std::optional<SessionTime> breath;
    for (const IntubationEvent& event : course) {
        if (event.step == IntubationStep::FirstBreath && isThroughCords(event.seat))
            breath = event.at;
        if (event.step == IntubationStep::BackAboveCords)
            breath.reset();
    }
    return breath;
}

} // namespace

TryCourse::TryCourse(const Vec3& up_F) : m_up_F{up_F}, m_plane{up_F}, m_hand{up_F} {}

void TryCourse::add(const IntubationEvent& event)
{
    if (!hasBegun() && !beginsTry(event.step))
        return;
    if (m_events.size() < kMostEvents)
        m_events.push_back(event);
    follow(event);
    m_firstBreath = firstBreathIn(courseAsTold(m_events, m_told));
}

void TryCourse::tell(std::optional<TubeSeat> seat, SessionTime since)
{
    ToldSeat said{m_events.size(), since, seat};
    if (!m_told.empty() && m_told.back().after == said.after) { // the last counts
        if (seat && m_told.back().seat)
            said.since = m_told.back().since;
        m_told.pop_back();
    }
    m_told.push_back(said);
    m_firstBreath = firstBreathIn(courseAsTold(m_events, m_told));
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
        m_leftAt = std::max(m_leftAt, event.at);
        measure(m_blade.bladeOut(event.at));
        m_plane.pause();
        m_hand.pause();
        break;
    case IntubationStep::TubePastTeeth:
        m_tubeIsIn = true;
        break;
    case IntubationStep::TubeOut:
        m_tubeIsIn = false;
        m_leftAt = std::max(m_leftAt, event.at);
        break;
    default:
        break;
    }
    if (m_bladeIsIn || m_tubeIsIn)
        m_outSince.reset();
    else if (!m_outSince)
        m_outSince = std::max(m_leftAt, m_events.front().at);
}

void TryCourse::addVitals(SessionTime t, const Vitals& vitals)
{
    if (isWithinLongest(t))
        m_vitals.emplace_back(t, vitals);
}

/// What comes later is not of the try, whenever it ends.
bool TryCourse::isWithinLongest(SessionTime t) const
{
    return hasBegun() && t <= m_pauses.after(m_events.front().at, kLongestTry);
}

bool TryCourse::wasPausedBetween(SessionTime from, SessionTime until) const
{
    return m_pauses.between(from, until) < until - from;
}

void TryCourse::addBlade(const PoseSample& X_FL)
{
    m_blade.add(X_FL);
    measure(m_blade.inMouthUntil(X_FL.time - BladeSamples::kKnownAfter));
}

void TryCourse::measure(const std::vector<PoseSample>& blade)
{
    for (const PoseSample& X_FL : blade) {
        if (m_lastBlade && wasPausedBetween(*m_lastBlade, X_FL.time)) {
            m_plane.pause();
            m_hand.pause();
        }
        m_lastBlade = X_FL.time;
        m_plane.add(X_FL);
        m_hand.add(X_FL);
    }
}

void TryCourse::addHead(const PoseSample& X_FH)
{
    if (isWithinLongest(X_FH.time))
        m_heads.push_back(X_FH);
}

void TryCourse::addForces(SessionTime t, Force incisors, Force tongue)
{
    if (!hasBegun())
        return;
    if (wasPausedBetween(m_lastForces.value_or(t), t)) {
        m_incisors.pause();
        m_tongue.pause();
    }
    m_lastForces = t;
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
    // What was just said may be taken back, or be followed by what is meant.
    const SessionTime said = m_told.empty() ? SessionTime::min() : m_told.back().since;
    if (m_firstBreath) {
        const SessionTime end = m_pauses.after(std::max(*m_firstBreath, said), kVentilatedFor);
        if (now >= end)
            return end;
    }
    if (m_outSince && now >= m_pauses.after(*m_outSince, kOutFor))
        return *m_outSince;
    const SessionTime latest = m_pauses.after(m_events.front().at, kLongestTry);
    return now >= latest ? std::optional{latest} : std::nullopt;
}

TryMetrics TryCourse::metrics(SessionTime ended, std::optional<Length> depthWanted) const
{
    CARINA_EXPECTS(hasBegun());
    const SessionTime end = std::max(ended, m_events.front().at);
    TryCourse whole = *this;
    whole.measure(whole.m_blade.inMouthUntil(ended));
    OxygenMeter oxygen{m_pauses};
    for (const auto& [t, vitals] : m_vitals)
        if (t <= end)
            oxygen.add(t, vitals);
    MotionMeter head{m_up_F};
    SessionTime last = m_heads.empty() ? end : m_heads.front().time;
    for (const PoseSample& X_FH : m_heads) {
        if (X_FH.time > end)
            continue;
        if (wasPausedBetween(std::exchange(last, X_FH.time), X_FH.time))
            head.pause();
        head.add(X_FH);
    }
    for (ToldSeat& said : whole.m_told)
        said.since = std::min(said.since, end); // later: it is said of the end
    std::vector<IntubationEvent> within = courseAsTold(m_events, whole.m_told);
    std::erase_if(within, [end](const IntubationEvent& event) { return event.at > end; });
    TryMetrics metrics = courseOf(within, end, m_pauses);
    metrics.isTold = toldAtEnd(m_events, m_told).has_value();
    if (metrics.isTold)
        metrics.confidence = 1.0;
    metrics.depthWanted = depthWanted;
    metrics.checks = m_checks;
    if (!m_isWatched)
        return metrics;
    metrics.headExtension = m_headExtension;
    metrics.oxygen = oxygen.figures();
    metrics.incisors = m_incisors.figures();
    metrics.tongue = m_tongue.figures();
    metrics.plane = whole.m_plane.figures();
    metrics.hand = whole.m_hand.figures();
    metrics.head = head.figures();
    return metrics;
}

} // namespace carina
