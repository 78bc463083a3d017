#pragma once

#include "engine/lungs/mechanics/lung_dynamics.h"

#include <array>

namespace carina
{

/// What a lung and its side of the chest look like at one moment.
struct LungShape {
    Volume gas;     ///< in the lung
    Volume healthy; ///< in the lung at rest in health
    Volume room;    ///< that the wall of its side makes for gas, were the mediastinum in its place

    friend bool operator==(const LungShape&, const LungShape&) = default;
};

/// What the mechanics give to whoever draws the chest.
struct ChestShape {
    std::array<LungShape, 2> lungs; ///< right, left
    Length mediastinalShift;        ///< towards the patient's left
    double ribShare = 0.0; ///< of a change of volume, made by the ribs; else by the diaphragm
    double sag = 0.0;      ///< of the inside of both lungs, as LungPose::gravity

    friend bool operator==(const ChestShape&, const ChestShape&) = default;
};

/// The diaphragm makes 65 % of a man's and 55 % of a woman's change of volume: 60 % of both, and
/// women use more rib cage. The mediastinum moves aside over an area of 200 cm2 in an adult, in
/// proportion to the two-thirds power of lung size.
[[nodiscard]] ChestShape chestShape(const PatientBuild& build, const RespiratorySystem& system,
                                    const ChestContent& content, const ChestMoment& moment);

} // namespace carina
