#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/units.h"

#include <optional>

namespace carina
{

/// The centre line of a straight part of a tube.
struct TubeLine {
    Vec3 point = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ(); ///< unit
};

/// The line through the centroids of a tube's cross-sections. Sections are taken perpendicular to
/// the line, at 24 positions from `from` to `to` beyond `start`; of several outlines in a section
/// the one nearest to the line is used. Iterates from the guess until the line is stable.
/// @returns std::nullopt if fewer than half of the positions have a section.
[[nodiscard]] std::optional<TubeLine> lineThrough(const TriangleMesh& tube, const Vec3& start,
                                                  const TubeLine& guess, Length from, Length to);

/// Dimensions measured on the surfaces of an airway, built-in or real.
struct AirwayMeasures {
    Length trachea; ///< along its line, from the carina to the lower border of the cricoid
                    ///< cartilage, or to its upper end if no part is named so
    Length coronal; ///< lateral diameter of the outside, median of the sections over the middle
                    ///< half
    Length sagittal;
    Angle rightBronchus; ///< from the extended line of the trachea
    Angle leftBronchus;
    Length teethToCarina; ///< along the path of the landmarks
    Length cordsToCarina; ///< the same, from the glottis
};

/// @returns std::nullopt without landmarks, or without trachea and main bronchi whose lines can be
///          found.
[[nodiscard]] std::optional<AirwayMeasures> measureAirway(const Anatomy& anatomy);

} // namespace carina
