#pragma once

#include "engine/tracking/markers/probe.h"

#include <cstdint>

namespace carina
{

/// What a probe is to be: markers all round a ball, each facing outward, as for a head that a
/// tracker may see from any side.
struct ProbeGoal {
    int markers = 20;
    Length radius = millimetres(100.0);
    Angle largestAngle = degrees(90.0); ///< at which a marker is still seen
    std::size_t seen = 6;               ///< markers that are to be seen
    double share = 0.95;                ///< in at least this share of the directions
    Length spacing = millimetres(15.0); ///< between two markers, at least
    MarkerNoise noise{};                ///< for which the error is to be small
    Vec3 p_OQ = Vec3::Zero();           ///< where, metres
    std::uint32_t seed = 1;
    int steps = 300; ///< of the search
};

/// Searches a layout that meets the goal with the least error. It begins with even places, moves
/// one marker after the other by a random angle that becomes smaller, and keeps a move that lessens
///
///     rotation / 0.03 degrees + position / 0.1 mm + 100 (missing share) + 10 (missing spacing)
///
/// as RMS over directions all round. The same goal gives the same layout.
///
/// @returns OutOfRange for fewer than four markers or more than an NDI tool has, a radius or
///          spacing that is not above zero, or more markers to be seen than there are.
[[nodiscard]] Result<Probe> designProbe(const ProbeGoal& goal);

/// The distance of the two markers that are nearest to each other.
[[nodiscard]] Length closestMarkers(const Probe& probe);

} // namespace carina
