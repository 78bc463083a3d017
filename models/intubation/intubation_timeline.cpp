#include "models/intubation/intubation_timeline.h"

#include "models/physiology/drug_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// From this confidence on something is told without one. Of ours.
constexpr double kToldAsSure = 0.8;

/// "12.1 cm".
QString centimetresText(Length length)
{
    return IntubationTimeline::tr("%1 cm").arg(inMillimetres(length) / 10.0, 0, 'f', 1);
}

QString bronchusText(TubeSeat seat)
{
    switch (seat) {
    case TubeSeat::RightMain:
        return IntubationTimeline::tr("In the right main bronchus");
    case TubeSeat::LeftMain:
        return IntubationTimeline::tr("In the left main bronchus");
    case TubeSeat::None:
    case TubeSeat::Trachea:
    case TubeSeat::Oesophagus:
        break;
    }
    return IntubationTimeline::tr("Past the carina");
}

/// With where it goes: who looks up late sees no more than the last lines.
QString breathText(TubeSeat seat)
{
    switch (seat) {
    case TubeSeat::Oesophagus:
        return IntubationTimeline::tr("▲ First breath goes into the oesophagus");
    case TubeSeat::RightMain:
        return IntubationTimeline::tr("▲ First breath goes into the right lung alone");
    case TubeSeat::LeftMain:
        return IntubationTimeline::tr("▲ First breath goes into the left lung alone");
    case TubeSeat::None:
    case TubeSeat::Trachea:
        break;
    }
    return IntubationTimeline::tr("First breath through the tube");
}

/// With the best view of the attempt, which is known at its end.
QString bladeOutText(double mostOfGlottis)
{
    const long percent = std::lround(100.0 * mostOfGlottis);
    return percent == 0
               ? IntubationTimeline::tr("Blade out")
               : IntubationTimeline::tr("Blade out: up to %1\u00a0% of the glottis was seen")
                     .arg(percent);
}

QString happenedText(const IntubationEvent& event)
{
    switch (event.step) {
    case IntubationStep::BladeIn:
        return IntubationTimeline::tr("Blade in the mouth: an attempt begins");
    case IntubationStep::BladeOut:
        return bladeOutText(event.glotticOpening);
    case IntubationStep::GlottisSeen:
        return IntubationTimeline::tr("Glottis seen");
    case IntubationStep::TubePastTeeth:
        return IntubationTimeline::tr("Tube past the teeth");
    case IntubationStep::TubeOut:
        return IntubationTimeline::tr("Tube out of the mouth");
    case IntubationStep::ThroughCords:
        return IntubationTimeline::tr("Through the cords");
    case IntubationStep::BackAboveCords:
        return IntubationTimeline::tr("Back above the cords");
    case IntubationStep::InOesophagus:
        return IntubationTimeline::tr("▲ In the oesophagus");
    case IntubationStep::OutOfOesophagus:
        return IntubationTimeline::tr("Out of the oesophagus");
    case IntubationStep::PastCarina:
        return IntubationTimeline::tr("▲ %1").arg(bronchusText(event.seat));
    case IntubationStep::BackAboveCarina:
        return IntubationTimeline::tr("Back above the carina");
    case IntubationStep::CuffInflated:
        return IntubationTimeline::tr("Cuff inflated");
    case IntubationStep::CuffDeflated:
        return IntubationTimeline::tr("Cuff emptied");
    case IntubationStep::StyletOut:
        return IntubationTimeline::tr("Stylet drawn");
    case IntubationStep::FirstBreath:
        return breathText(event.seat);
    case IntubationStep::ShapesApart:
        return IntubationTimeline::tr("▲ Real and virtual tube part by %1 mm: no depth from here")
            .arg(inMillimetres(event.besides), 0, 'f', 0);
    case IntubationStep::ShapesTogether:
        return IntubationTimeline::tr("Real and virtual tube together again");
    case IntubationStep::PassedShut:
        return IntubationTimeline::tr("▲ The real tube passed cords that are shut");
    case IntubationStep::AtRest:
        return IntubationTimeline::tr("Tube at rest");
    }
    return {};
}

/// Of a tip that came to a place behind the cords. At the cords a depth would be none that anybody
/// reads at the teeth: a tube that was not touched is rigid, and goes from teeth to cords straight
/// and not along the way (9 instead of 11 cm in the adult); one that is first seen in its place has
/// the depth at which it lies.
bool hasDepth(IntubationStep step)
{
    switch (step) {
    case IntubationStep::PastCarina:
    case IntubationStep::BackAboveCarina:
    case IntubationStep::CuffInflated:
    case IntubationStep::StyletOut:
    case IntubationStep::FirstBreath:
    case IntubationStep::AtRest:
        return true;
    case IntubationStep::BladeIn:
    case IntubationStep::BladeOut:
    case IntubationStep::GlottisSeen:
    case IntubationStep::TubePastTeeth:
    case IntubationStep::TubeOut:
    case IntubationStep::ThroughCords:
    case IntubationStep::BackAboveCords:
    case IntubationStep::InOesophagus:
    case IntubationStep::OutOfOesophagus:
    case IntubationStep::CuffDeflated:
    case IntubationStep::ShapesApart:
    case IntubationStep::ShapesTogether:
    case IntubationStep::PassedShut:
        break;
    }
    return false;
}

/// Whether what is said of it may be wrong where the confidence in the place of the tube is low:
/// what people set has happened, and so has a breath, or a tube's coming to rest, wherever it is.
bool tellsPlace(const IntubationEvent& event)
{
    const bool isBreath = event.step == IntubationStep::FirstBreath;
    const bool isElsewhere = event.seat != TubeSeat::None && event.seat != TubeSeat::Trachea;
    return !isOfControls(event.step) && event.step != IntubationStep::AtRest
           && (!isBreath || isElsewhere);
}

/// The first breath goes where the console says that the tube is.
IntubationEvent asSet(IntubationEvent event, const SetTube& set)
{
    if (event.step != IntubationStep::FirstBreath || !set.isSet())
        return event;
    event.seat = set.seat;
    event.confidence = 1.0;
    return event;
}

/// What was noted, set and given, in the order in which it happened; the last kMostNotes of it.
std::vector<TimelineEntry> entriesOf(const RespirationTimeline& patient)
{
    const TubeTimeline& tube = patient.tube();
    std::vector<TimelineEntry> all;
    for (const GivenDose& given : patient.dosesWithin(SessionTime::min(), SessionTime::max()))
        all.push_back(
            {given.from,
             IntubationTimeline::tr("Given: %1", "drug and its dose").arg(doseText(given.dose))});
    for (const NotedStep& note : tube.notes()) {
        IntubationEvent event = asSet(note.event, tube.overrideAt(note.effect));
        if (tube.areShapesApartAt(note.effect)) // it is frozen
            event.depthAtTeeth = {};
        all.push_back({event.at, intubationText(event)});
    }
    for (const auto& change : tube.overrides())
        all.push_back({change.from, IntubationTimeline::tr("Console: tube %1", "where")
                                        .arg(setTubeText(change.value.tube))});
    std::ranges::stable_sort(all, {}, &TimelineEntry::at);
    if (all.size() > TubeTimeline::kMostNotes)
        all.erase(all.begin(), all.end() - std::ptrdiff_t(TubeTimeline::kMostNotes));
    return all;
}

} // namespace

QString asSureAs(const QString& what, double confidence)
{
    if (confidence >= kToldAsSure)
        return what;
    const QString words =
        confidence < kLeastTold
            ? IntubationTimeline::tr("%1? (%2\u00a0% sure)", "what happened; a confidence")
            : IntubationTimeline::tr("%1 (%2\u00a0% sure)", "what happened; a confidence");
    return words.arg(what).arg(std::lround(100.0 * confidence));
}

QString intubationText(const IntubationEvent& event)
{
    QString text = happenedText(event);
    if (hasDepth(event.step) && event.depthAtTeeth > Length{})
        text = IntubationTimeline::tr("%1, %2 at the teeth", "what happened; a length")
                   .arg(text, centimetresText(event.depthAtTeeth));
    return tellsPlace(event) ? asSureAs(text, event.confidence) : text;
}

IntubationTimeline::IntubationTimeline(SessionModel& session, StationId station, QObject* parent)
    : QAbstractListModel{parent}, m_session{session}, m_station{station}
{
    connect(&session, &SessionModel::changed, this, &IntubationTimeline::refresh);
    refresh();
}

void IntubationTimeline::setStation(StationId station)
{
    m_station = station;
    refresh();
}

int IntubationTimeline::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_lines.size());
}

QVariant IntubationTimeline::data(const QModelIndex& index, int role) const
{
    const bool isThere = index.isValid() && index.row() < rowCount();
    return isThere && role == Qt::DisplayRole ? QVariant{m_lines[std::size_t(index.row())].text}
                                              : QVariant{};
}

int IntubationTimeline::rowAt(SessionTime moment) const
{
    const auto later = std::ranges::upper_bound(m_lines, moment, {}, &TimelineEntry::at);
    const auto row = later - m_lines.begin() - 1;
    return m_lines.empty() ? -1 : std::max(int(row), 0);
}

void IntubationTimeline::refresh()
{
    const auto state = m_session.node().state();
    const auto station = state->stations().find(m_station);
    std::vector<TimelineEntry> lines;
    if (station != state->stations().end())
        lines = entriesOf(station->second.respiration);
    for (TimelineEntry& each : lines)
        each.text = tr("%1  %2", "running time; what happened")
                        .arg(timeText(state->runningTime(each.at)), each.text);
    if (lines == m_lines)
        return;
    beginResetModel();
    m_lines = std::move(lines);
    endResetModel();
}

} // namespace carina
