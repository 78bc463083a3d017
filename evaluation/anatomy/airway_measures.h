#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/units.h"

#include <optional>

namespace carina
{

/// A straight piece of a tube: a line through it.
struct TubeLine {
    Vec3 point = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ(); ///< unit
};

/// The line through the middles of a tube's sections. Sections are taken square to the line, at
/// 24 places from `from` to `to` beyond `start`; of several outlines in one the nearest to the line
/// counts. Begins with the guess and goes on until the line stays.
/// @returns nothing where fewer than half of the places have a section.
[[nodiscard]] std::optional<TubeLine> lineThrough(const TriangleMesh& tube, const Vec3& start,
                                                  const TubeLine& guess, Length from, Length to);

/// What is measured on the surfaces of an airway, built-in or real.
struct AirwayMeasures {
    Length trachea; ///< along its line, from the carina to the lower border of the cricoid
                    ///< cartilage, or to its upper end where no part is named so
    Length coronal; ///< side to side, median of sections over the middle half
    Length sagittal;
    Angle rightBronchus; ///< from the trachea's line produced
    Angle leftBronchus;
    Length teethToCarina; ///< along the landmarks' path
    Length cordsToCarina; ///< likewise, from the glottis
};

/// @returns nothing without landmarks, trachea or main bronchi whose lines can be found.
[[nodiscard]] std::optional<AirwayMeasures> measureAirway(const Anatomy& anatomy);

} // namespace carina
