#include "engine/session/body/tube_timeline.h"

#include "engine/anatomy/patient/patient_dimensions.h"

#include <algorithm>

namespace carina
{
namespace
{

/// A cuff is tried, and a stylet drawn, outside of it, too.
bool isInMouthAfter(const IntubationEvent& event, bool before)
{
    if (event.step == IntubationStep::TubeOut)
        return false;
    return before || event.step == IntubationStep::TubePastTeeth || event.seat != TubeSeat::None;
}

} // namespace

void TubeTimeline::setOverride(SessionTime from, const SetTube& tube)
{
    m_override.set(from, {tube, m_noted.at(from).isInMouth});
    if (!tube.isSet() && !m_noted.at(from).isInMouth) // it is out, with what blocked it
        m_obstruction.set(from, 0.0);
}

void TubeTimeline::note(SessionTime from, const IntubationEvent& event, Length innerDiameter)
{
    keep(from, event);
    switch (event.step) {
    case IntubationStep::BladeIn:
    case IntubationStep::BladeOut:
        m_blade.set(from, event.step == IntubationStep::BladeIn);
        return;
    case IntubationStep::GlottisSeen:
        return;
    case IntubationStep::TubeOut:
        m_stylet.set(from, true);
        m_cuff.set(from, false);
        if (m_override.at(from).seatOfNoted())
            m_override.set(from, {});
        if (!m_override.at(from).tube.isSet())
            m_obstruction.set(from, 0.0);
        break;
    default:
        break;
    }
    const NotedTube before = m_noted.at(from);
    if (isOfControls(event.step) && !before.isWatched)
        return; // no sensor has seen a tube
    m_noted.set(
        from, NotedTube{true, isInMouthAfter(event, before.isInMouth), event.seat, innerDiameter});
}

/// A tube that is moved to and fro for long would push out the steps of its try by its rests.
void TubeTimeline::keep(SessionTime from, const IntubationEvent& event)
{
    const NotedStep entry{from, event, lastNote() + 1};
    const bool restsAgain = event.step == IntubationStep::AtRest && !m_notes.empty()
                            && m_notes.back().event.step == IntubationStep::AtRest;
    if (restsAgain)
        m_notes.pop_back();
    else if (m_notes.size() == kMostNotes)
        m_notes.erase(m_notes.begin());
    m_notes.push_back(entry);
}

std::span<const NotedStep> TubeTimeline::notesAfter(std::uint64_t number) const
{
    return {std::ranges::upper_bound(m_notes, number, {}, &NotedStep::number), m_notes.end()};
}

void TubeTimeline::forgetBefore(SessionTime t)
{
    const auto told = m_override.changes();
    if (told.size() > kMostNotes)
        m_override.forgetBefore(std::min(t, told[told.size() - kMostNotes].from));
    m_noted.forgetBefore(t);
    m_blade.forgetBefore(t);
    m_cuff.forgetBefore(t);
    m_obstruction.forgetBefore(t);
    m_stylet.forgetBefore(t);
}

TubePlace TubeTimeline::placeAt(SessionTime t, const PatientBuild& build) const
{
    const ToldTube told = m_override.at(t);
    const double leak = m_cuff.at(t) ? 0.0 : kEmptyCuffLeak;
    if (told.tube.isSet())
        return {told.tube.seat, told.tube.innerDiameter, told.isOfNoted ? leak : 0.0,
                m_obstruction.at(t)};
    const NotedTube noted = m_noted.at(t);
    if (!noted.isWatched)
        return {};
    const Length diameter =
        noted.innerDiameter.si > 0.0 ? noted.innerDiameter : usualTube(build.ageInYears, build.sex);
    return {noted.seat, diameter, leak, m_obstruction.at(t)};
}

bool TubeTimeline::areShapesApartAt(SessionTime t) const
{
    const auto tells = [t](const NotedStep& note) {
        const IntubationStep step = note.event.step;
        return note.effect <= t
               && (step == IntubationStep::ShapesApart || step == IntubationStep::ShapesTogether
                   || step == IntubationStep::TubeOut);
    };
    const auto last = std::find_if(m_notes.rbegin(), m_notes.rend(), tells);
    return last != m_notes.rend() && last->event.step == IntubationStep::ShapesApart;
}

std::optional<IntubationEvent> TubeTimeline::lastOfSeatAt(SessionTime t) const
{
    const auto last = std::find_if(m_notes.rbegin(), m_notes.rend(), [t](const NotedStep& note) {
        return note.effect <= t && isSureOfSeat(note.event.step);
    });
    if (last == m_notes.rend() || !m_noted.at(t).isInMouth)
        return std::nullopt;
    return last->event;
}

SessionTime TubeTimeline::changeAfter(SessionTime t) const
{
    return std::min({m_override.changeAfter(t), m_noted.changeAfter(t), m_blade.changeAfter(t),
                     m_cuff.changeAfter(t), m_obstruction.changeAfter(t)});
}

} // namespace carina
