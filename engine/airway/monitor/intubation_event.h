#pragma once

#include "engine/core/session_time.h"
#include "engine/core/units.h"
#include "engine/lungs/mechanics/tube_place.h"

#include <array>
#include <cstdint>

namespace carina
{

/// What the monitor of an intubation notes.
enum class IntubationStep : std::uint8_t {
    BladeIn,        ///< the blade passes the teeth: an attempt begins
    BladeOut,       ///< and has left the mouth
    GlottisSeen,    ///< at least a grade of 2 for the first time in this attempt
    TubePastTeeth,  ///< the tube's tip passes the teeth inwards
    TubeOut,        ///< and has left the mouth
    ThroughCords,   ///< the tip is through the vocal cords
    BackAboveCords, ///< and above them again
    InOesophagus,   ///< the tip is in the oesophagus
    OutOfOesophagus,
    PastCarina, ///< the tip is in a main bronchus: the seat says which
    BackAboveCarina,
    CuffInflated, ///< as people say by their controls: no sensor feels it
    CuffDeflated,
    StyletOut,
    FirstBreath, ///< the first breath delivered through the tube
    ShapesApart, ///< measured and constrained tube part: the depth is no longer claimed
    ShapesTogether,
    PassedShut, ///< the real tube passed where the virtual airway is shut
    AtRest,     ///< the tip, in trachea or bronchus, rests at another depth than was noted last
};
inline constexpr IntubationStep kLastIntubationStep = IntubationStep::AtRest;

/// Whether it is about the laryngoscope, and not about the tube.
[[nodiscard]] constexpr bool isOfBlade(IntubationStep step)
{
    return step == IntubationStep::BladeIn || step == IntubationStep::BladeOut
           || step == IntubationStep::GlottisSeen;
}

/// Whether people tell it by their controls, be a tube tracked or not.
[[nodiscard]] constexpr bool isOfControls(IntubationStep step)
{
    return step == IntubationStep::CuffInflated || step == IntubationStep::CuffDeflated
           || step == IntubationStep::StyletOut;
}

/// Whether its confidence is that in the seat of the tube, and not in what the step itself tells.
[[nodiscard]] constexpr bool isSureOfSeat(IntubationStep step)
{
    return !isOfBlade(step) && step != IntubationStep::ShapesApart
           && step != IntubationStep::ShapesTogether && step != IntubationStep::PassedShut;
}

/// Whether it is of the way that the tip takes beyond the teeth.
[[nodiscard]] constexpr bool isOfWay(IntubationStep step)
{
    switch (step) {
    case IntubationStep::ThroughCords:
    case IntubationStep::BackAboveCords:
    case IntubationStep::InOesophagus:
    case IntubationStep::OutOfOesophagus:
    case IntubationStep::PastCarina:
    case IntubationStep::BackAboveCarina:
        return true;
    default:
        return false;
    }
}

/// One entry of an intubation's course, with what it rests on. Poses are those of one station.
struct IntubationEvent {
    IntubationStep step = IntubationStep::BladeIn;
    SessionTime at{};               ///< when it happened; it is noted a little later
    TubeSeat seat = TubeSeat::None; ///< of the tip from then on
    double confidence = 1.0;        ///< 0 to 1
    Length depthAtTeeth{};          ///< of the tip, along the tube; 0 outside
    Length tipAboveCarina{};     ///< along the airway, negative beyond; of meaning in the trachea
    Length besides{};            ///< distance of the two shapes of the tube at its tip
    double glotticOpening = 0.0; ///< the largest share of the glottis seen in the attempt, 0 to 1

    friend bool operator==(const IntubationEvent&, const IntubationEvent&) = default;
};

} // namespace carina
