#pragma once

#include "engine/geometry/vec.h"

#include <span>

namespace carina
{

/// Half of the width of a volume at a distance from the tracker, metres.
struct VolumeSection {
    double depth = 0.0; ///< along -z of T
    double halfX = 0.0; ///< along x of T, which is upright at a Polaris
    double halfY = 0.0;
};

/// The volume in which a tracker measures: between its sections, from the nearest to the farthest,
/// the width changes evenly.
struct MeasurementVolume {
    std::span<const VolumeSection> sections; ///< at least two, ascending in depth
    bool isRound = false;                    ///< with halfX as radius, else rectangular

    /// How far a point is inside: the distance to the nearest face of the part in whose depth it
    /// is, metres; below 0 outside.
    [[nodiscard]] double insideBy(const Vec3& p_T) const;
};

/// The pyramid of a Polaris Spectra or Vega: from 950 to 2400 mm, up to 1566 mm wide and 1312 mm
/// high, as NDI states it.
[[nodiscard]] MeasurementVolume polarisPyramid();
/// The extended one, up to 3000 mm, 1856 mm wide and 1470 mm high.
[[nodiscard]] MeasurementVolume polarisExtendedPyramid();
/// The cone of WorkingVolume, in which the simulated tracker sees.
[[nodiscard]] MeasurementVolume simulatedCone();

} // namespace carina
