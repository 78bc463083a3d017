#pragma once

#include "engine/lungs/lung_dynamics.h"

#include <array>

namespace carina
{

/// What a lung and its side of the chest look like at one moment.
struct LungShape {
    Volume gas;     ///< in the lung
    Volume healthy; ///< in the lung at rest in health
    Volume room;    ///< that the wall of its side makes for gas, were the mediastinum in its place
    double collapse =
        0.0; ///< share of the side's gas that is in the pleura: 0 where the lung fills it
    Length diaphragmDescent; ///< of the dome, below where it rests in health

    friend bool operator==(const LungShape&, const LungShape&) = default;
};

/// What the mechanics give to whoever draws the chest.
struct ChestShape {
    std::array<LungShape, 2> lungs; ///< right, left
    Length mediastinalShift;        ///< towards the patient's left
    double diaphragmShare = 0.0;    ///< of a change of volume, made by the diaphragm
    double ribShare = 0.0;          ///< and by the ribs

    friend bool operator==(const ChestShape&, const ChestShape&) = default;
};

/// The dome goes down by 16.6 mm for each litre that both sides hold more than at rest in health (a
/// side counts as if the other did alike), and by 60 mm at the most (Thorax 1994;49:885, supine,
/// the same at any height and weight). The diaphragm makes 65 % of a man's and 55 % of a woman's
/// change of volume: 60 % of both, and women use more rib cage. The mediastinum moves aside over an
/// area of 200 cm2 in an adult, in proportion to the two-thirds power of lung size.
[[nodiscard]] ChestShape chestShape(const PatientBuild& build, const RespiratorySystem& system,
                                    const ChestContent& content, const ChestMoment& moment);

inline constexpr Length kDescentPerLitre = millimetres(16.6);
inline constexpr Length kGreatestDescent = millimetres(60.0);

} // namespace carina
