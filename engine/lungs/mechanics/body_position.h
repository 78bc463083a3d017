#pragma once

#include "engine/lungs/mechanics/respiratory_system.h"

#include <array>
#include <cstdint>

namespace carina
{

/// How a patient lies or sits: the positions of which the resting volume of the lungs was measured.
enum class BodyPosition : std::uint8_t {
    Supine,
    Sitting,
    Prone,
    RightLateral, ///< on the right side
    LeftLateral,
};

/// In the order in which people are offered them, which is that of the enumerators.
inline constexpr std::array kBodyPositions{BodyPosition::Supine, BodyPosition::Sitting,
                                           BodyPosition::Prone, BodyPosition::RightLateral,
                                           BodyPosition::LeftLateral};

/// Turns a patient from the back into a position: what a system that `onBack`, in health, was made
/// into by tube and condition, gets the pressures that bring the healthy one to the volumes
/// measured.
///
/// - They act on the wall; the lung follows along its own curve, which a position does not change.
///   In health it then rests, sitting, with 806 ml more than on the back, prone with 350 ml more,
///   in proportion to the resting volume; on a side the upper lung with 25 % more and the lower one
///   as on the back.
/// - On a side the mediastinum rests in the middle: its weight is what the pleural pressures of
///   both sides differ by. The muscles pull more on the lower side, so that its lung takes the
///   larger part of a quiet breath.
/// - The inside of the lungs sinks towards what is below; how far is ours.
///
/// Sources: docs/mechanics.md.
void place(RespiratorySystem& system, BodyPosition position, const RespiratorySystem& onBack);

} // namespace carina
