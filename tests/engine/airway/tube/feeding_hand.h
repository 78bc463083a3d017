#pragma once

#include "engine/airway/lumen/moved_lumen.h"
#include "engine/registration/calibration/tube_rest.h"

#include <algorithm>
#include <cmath>

namespace carina::test
{

/// Where a tube passes the teeth, and the direction of the mouth there.
struct Mouth {
    Vec3 p_A = Vec3::Zero();
    Vec3 into = Vec3::UnitY();
};

inline Mouth mouthOf(const MovedLumen& lumen)
{
    constexpr double kBehind_m = 0.03;
    const Vec3 p_A = lumen.sectionAt(AirwayWay::Trunk, lumen.teeth).p_A_centre;
    const Vec3 p_A_behind = lumen.sectionAt(AirwayWay::Trunk, lumen.teeth + kBehind_m).p_A_centre;
    return {p_A, (p_A_behind - p_A).normalized()};
}

/// The rotation about x to a direction in the median plane, from z.
inline Quat inMedianPlane(const Vec3& direction)
{
    return Quat{Eigen::AngleAxisd{std::atan2(-direction.y(), direction.z()), Vec3::UnitX()}};
}

/// A hand that feeds a tube along its own curve, so many metres of it behind the teeth, and lifts
/// the connector by 17 degrees as it goes in: in the median plane, so that it never spins, as a
/// shortest rotation would where it is half a turn.
inline RigidTransform fed(const Mouth& mouth, const TubeRest& rest, double inside)
{
    constexpr double kRise = 0.3;
    constexpr double kRisen_m = 0.14;
    const Length there = metres(rest.length.si - std::max(inside, 0.0));
    const Vec3 p_E = centreOfTube(rest, there);
    const Vec3 along_E = (centreOfTube(rest, there + millimetres(1.0)) - p_E).normalized();
    const double rise = kRise * std::clamp(inside / kRisen_m, 0.0, 1.0);
    const Quat q = Quat{Eigen::AngleAxisd{-rise, Vec3::UnitX()}} * inMedianPlane(mouth.into)
                   * inMedianPlane(along_E).conjugate();
    return {q, mouth.p_A + std::min(inside, 0.0) * mouth.into - q * p_E};
}

} // namespace carina::test
