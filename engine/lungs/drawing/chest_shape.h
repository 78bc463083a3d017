#pragma once

#include "engine/lungs/mechanics/lung_dynamics.h"

#include <array>

namespace carina
{

/// State of one lung and its side of the chest at one moment, as needed to draw it.
struct LungShape {
    Volume gas;     ///< in the lung
    Volume healthy; ///< gas in this lung at rest in health
    /// The room for gas that chest wall and diaphragm of this side make, with an unshifted
    /// mediastinum.
    Volume room;

    friend bool operator==(const LungShape&, const LungShape&) = default;
};

/// State of the chest at one moment, as needed to draw it (drawnPose).
struct ChestShape {
    std::array<LungShape, 2> lungs; ///< right, left
    Length mediastinalShift;        ///< towards the patient's left
    /// The share of a change of volume that the ribs make; the diaphragm makes the rest.
    double ribShare = 0.0;
    double sag = 0.0; ///< of the inside of both lungs, an amplitude as LungPose::gravity

    friend bool operator==(const ChestShape&, const ChestShape&) = default;
};

/// The state to draw, from the mechanics.
///
/// The diaphragm makes 65 % of the change of volume in men and 55 % in women: 60 % is the mean of
/// both, and women use the rib cage more. Boys and girls up to twelve years have 55 %, which
/// changes linearly to the figure of their sex at eighteen: with 60 % the domes of a child of 12
/// would descend by 22.2 mm/L, which is more than two standard deviations above the 16.6 (2.4) mm/L
/// that fluoroscopy found at every body size (docs/deformation.md). The volume by which the
/// mediastinum gives way becomes a shift over an area of 200 cm2 in an adult, in proportion to the
/// two-thirds power of lung size.
[[nodiscard]] ChestShape chestShape(const PatientBuild& build, const RespiratorySystem& system,
                                    const ChestContent& content, const ChestMoment& moment);

} // namespace carina
