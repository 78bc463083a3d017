#pragma once

#include "engine/geometry/rotation.h"
#include "engine/registration/calibration/blade_calibration.h"
#include "engine/registration/calibration/tube_calibration.h"

#include <cmath>
#include <random>
#include <vector>

namespace carina::test
{

inline const RigidTransform kX_NE{rotationFromVector({0.4, -0.9, 1.3}), {0.02, -0.05, 0.03}};
inline const TubeRest kAdultTube{.length = millimetres(300.0),
                                 .bends = {1.0 / 0.14, 1.0 / 0.14},
                                 .outerDiameter = millimetres(10.2)};

inline const RigidTransform kX_NL{rotationFromVector({-0.2, 0.7, 2.1}), {0.0, -0.12, 0.02}};
inline const BladeShape kCurvedBlade{.heelWidth = millimetres(16.0),
                                     .handle = millimetres(150.0),
                                     .p_L_tip = {0.0, 0.012, -0.13},
                                     .p_L_half = {0.0, -0.012, -0.066}};

/// The tip of a stylus that strays from a place in any direction, by that RMS length.
inline Vec3 strayed(const Vec3& p, Length fle, std::mt19937& random)
{
    std::normal_distribution<double> part{0.0, 1.0};
    const double size = fle.si / std::sqrt(3.0);
    return p + size * Vec3{part(random), part(random), part(random)};
}

inline std::vector<TubeTouch> touchesOf(const TubeRest& tube, Length fle, std::mt19937& random)
{
    std::vector<TubeTouch> touches;
    for (const TubeTouchPlace& place : kTubePlaces)
        touches.push_back({place.part, strayed(kX_NE * placeOnTube(tube, place), fle, random)});
    return touches;
}

inline std::vector<BladeTouch> touchesOf(const BladeShape& blade, Length fle, std::mt19937& random)
{
    std::vector<BladeTouch> touches;
    for (const BladePlace place : kBladePlaces)
        touches.push_back({place, strayed(kX_NL * placeOnBlade(blade, place), fle, random)});
    return touches;
}

} // namespace carina::test
