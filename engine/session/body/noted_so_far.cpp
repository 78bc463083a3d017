#include "engine/session/body/noted_so_far.h"

#include <algorithm>

namespace carina
{
namespace
{

/// Of an attempt that may have ended.
void readView(NotedSoFar& noted, const IntubationEvent& event)
{
    if (event.step == IntubationStep::BladeIn) {
        noted.wasGlottisSeen = false;
        noted.glottis = 0.0;
    }
    noted.wasGlottisSeen |= event.step == IntubationStep::GlottisSeen;
    noted.glottis = std::max(noted.glottis, event.glotticOpening);
}

void readTube(NotedSoFar& noted, const IntubationEvent& event)
{
    if (event.step == IntubationStep::TubeOut) {
        noted.hasPassedShut = false;
        noted.breath.reset();
    }
    noted.hasPassedShut |= event.step == IntubationStep::PassedShut;
    if (event.step == IntubationStep::FirstBreath)
        noted.breath = event.seat;
    if (!isOfBlade(event.step))
        noted.tip = {event.at, event.depthAtTeeth, event.tipAboveCarina, event.besides};
}

} // namespace

NotedSoFar notedSoFar(const TubeTimeline& tube)
{
    NotedSoFar noted;
    for (const NotedStep& note : tube.notes()) {
        readView(noted, note.event);
        readTube(noted, note.event);
    }
    constexpr SessionTime kAll = SessionTime::max();
    const NotedTube present = tube.notedAt(kAll);
    const auto last = tube.lastOfSeatAt(kAll);
    noted.isBladeIn = tube.bladeInMouthAt(kAll);
    noted.isTubeIn = present.isInMouth;
    noted.seat = present.seat;
    noted.confidence = last ? last->confidence : 1.0;
    noted.areShapesApart = tube.areShapesApartAt(kAll);
    return noted;
}

} // namespace carina
