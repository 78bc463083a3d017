#pragma once

#include "engine/lungs/mechanics/respiratory_system.h"

#include <array>
#include <cstdint>

namespace carina
{

/// How a patient lies or sits: the positions for which measured resting lung volumes are published.
enum class BodyPosition : std::uint8_t {
    Supine,
    Sitting,
    Prone,
    RightLateral, ///< on the right side
    LeftLateral,
};

/// In the order in which controls list them, which is that of the enumerators.
inline constexpr std::array kBodyPositions{BodyPosition::Supine, BodyPosition::Sitting,
                                           BodyPosition::Prone, BodyPosition::RightLateral,
                                           BodyPosition::LeftLateral};

/// Puts a patient into a position. `onBack` is the healthy system in supine position, with tube and
/// relaxation where they apply; `system` is made from it by a condition. `system` gets the
/// pressures on the chest wall that bring `onBack` to the measured volumes of this position.
///
/// - The pressures act on the wall; the lung follows its own pressure-volume curve, which a
///   position does not change. At rest in health the lungs then hold, in an adult, 806 ml more
///   sitting and 350 ml more prone than supine, in proportion to the resting volume; on a side the
///   upper lung holds 25 % more and the lower one the same as supine.
/// - On a side the mediastinum rests in the middle: its weight is set to the difference of the
///   pleural pressures. The muscles pull more on the lower side, so that its lung takes the larger
///   part of a quiet breath.
/// - The inside of the lungs moves towards the front, relative to supine (sag); how far is our
///   choice.
///
/// Sources: docs/mechanics.md.
void place(RespiratorySystem& system, BodyPosition position, const RespiratorySystem& onBack);

} // namespace carina
