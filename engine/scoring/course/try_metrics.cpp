#include "engine/scoring/course/try_metrics.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

/// Goes through the events of a try once.
class CourseReader
{
public:
    CourseReader(SessionTime begun, const Pauses& pauses)
    {
        m_course.begun = begun;
        m_course.pauses = pauses;
    }

    void read(const IntubationEvent& event)
    {
        readBlade(event);
        readTube(event);
        readPlace(event);
    }
    [[nodiscard]] TryMetrics endedAt(SessionTime ended);

private:
    void readBlade(const IntubationEvent& event);
    void readTube(const IntubationEvent& event);
    void readPlace(const IntubationEvent& event);
    void countBlade(SessionTime until);

    TryMetrics m_course;
    std::optional<SessionTime> m_bladeIn;
    TubeSeat m_seat = TubeSeat::None;
    TubeSeat m_lastPlace = TubeSeat::None; ///< the last seat that was one
    double m_seatConfidence = 1.0;
    bool m_areApart = false;
};

void CourseReader::readBlade(const IntubationEvent& event)
{
    switch (event.step) {
    case IntubationStep::BladeIn:
        m_course.hadBlade = true;
        m_course.attempts.push_back(event.at);
        m_bladeIn = event.at;
        break;
    case IntubationStep::BladeOut:
        countBlade(event.at);
        m_bladeIn.reset();
        break;
    case IntubationStep::GlottisSeen:
        if (!m_course.view)
            m_course.view = event.at;
        break;
    default:
        break;
    }
    if (m_course.view) // any step tells the most that was seen by then
        m_course.glotticOpening =
            std::max(m_course.glotticOpening.value_or(0.0), event.glotticOpening);
}

void CourseReader::countBlade(SessionTime until)
{
    if (m_bladeIn)
        m_course.bladeTime += m_course.pauses.between(*m_bladeIn, until);
}

void CourseReader::readTube(const IntubationEvent& event)
{
    std::vector<OesophagealStay>& stays = m_course.oesophagus;
    const bool isStaying = !stays.empty() && !stays.back().out;
    switch (event.step) {
    case IntubationStep::TubePastTeeth:
        if (m_course.attempts.empty())
            m_course.attempts.push_back(event.at);
        break;
    case IntubationStep::ThroughCords:
        m_course.throughCords = event.at;
        break;
    case IntubationStep::BackAboveCords:
        m_course.throughCords.reset();
        m_course.firstBreath.reset();
        break;
    case IntubationStep::InOesophagus:
        if (!isStaying)
            stays.push_back({.in = event.at});
        break;
    case IntubationStep::OutOfOesophagus:
        if (isStaying && event.at > stays.back().in)
            stays.back().out = event.at;
        else if (isStaying) // the monitor has concluded otherwise
            stays.pop_back();
        break;
    case IntubationStep::FirstBreath:
        if (isThroughCords(event.seat))
            m_course.firstBreath = event.at;
        break;
    case IntubationStep::CuffInflated:
        m_course.cuffInflated = event.at;
        break;
    case IntubationStep::CuffDeflated:
    case IntubationStep::TubeOut: // with it
        m_course.cuffInflated.reset();
        break;
    case IntubationStep::PassedShut:
        m_course.passedShut = event.at;
        break;
    default:
        break;
    }
}

void CourseReader::readPlace(const IntubationEvent& event)
{
    if (event.step == IntubationStep::ShapesApart)
        m_areApart = true;
    if (event.step == IntubationStep::ShapesTogether || event.step == IntubationStep::TubeOut)
        m_areApart = false;
    if (event.seat != m_seat) {
        m_seat = event.seat;
        m_course.confidence = event.confidence;
    }
    if (m_seat != TubeSeat::None)
        m_lastPlace = m_seat;
    if (isSureOfSeat(event.step))
        m_seatConfidence = event.confidence;
    m_course.depth.reset();
    if (isThroughCords(m_seat) && !m_areApart)
        m_course.depth = {event.at, event.depthAtTeeth, event.tipAboveCarina, m_seatConfidence};
}

TryMetrics CourseReader::endedAt(SessionTime ended)
{
    m_course.ended = ended;
    countBlade(ended);
    switch (m_seat) {
    case TubeSeat::Trachea:
        m_course.outcome = TryOutcome::Trachea;
        break;
    case TubeSeat::RightMain:
        m_course.outcome = TryOutcome::RightMain;
        break;
    case TubeSeat::LeftMain:
        m_course.outcome = TryOutcome::LeftMain;
        break;
    case TubeSeat::Oesophagus:
        m_course.outcome = TryOutcome::OesophagusUnrecognised;
        break;
    case TubeSeat::None:
        m_course.outcome = m_lastPlace == TubeSeat::Oesophagus && !m_course.oesophagus.empty()
                               ? TryOutcome::OesophagusRecognised
                               : TryOutcome::Abandoned;
        break;
    }
    return std::move(m_course);
}

} // namespace

bool beginsTry(IntubationStep step)
{
    return step == IntubationStep::BladeIn || step == IntubationStep::TubePastTeeth;
}

TryMetrics courseOf(std::span<const IntubationEvent> events, SessionTime ended,
                    const Pauses& pauses)
{
    CARINA_EXPECTS(!events.empty());
    CourseReader reader{events.front().at, pauses};
    for (const IntubationEvent& event : events)
        reader.read(event);
    return reader.endedAt(ended);
}

} // namespace carina
