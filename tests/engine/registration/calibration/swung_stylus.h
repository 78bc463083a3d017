#pragma once

#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace carina::test
{

inline const Vec3 kTip_S{0.012, -0.005, -0.152};
inline const Vec3 kDivot_T{0.21, -0.13, -1.8};

/// A stylus that stands in its divot at such a turn.
inline RigidTransform standing(const Quat& R_TS, const Vec3& tip_S = kTip_S)
{
    return {R_TS, kDivot_T - R_TS * tip_S};
}

/// A stylus that stands in its divot, leaning by `lean` to all sides in turn, three times around,
/// and turned about itself by a third as much.
inline std::vector<RigidTransform> swung(int count, Angle lean)
{
    std::vector<RigidTransform> X_TS;
    for (int i = 0; i < count; ++i) {
        const double around = 3.0 * 2.0 * std::numbers::pi * i / count;
        X_TS.push_back(
            standing(rotationFromVector({0.4, 0.2, -0.3})
                     * rotationFromVector({lean.si * std::cos(around), lean.si * std::sin(around),
                                           lean.si / 3.0 * std::sin(1.7 * around)})));
    }
    return X_TS;
}

inline RigidTransform shifted(const RigidTransform& X_TS, const Vec3& by)
{
    return {X_TS.rotation(), X_TS.translation() + by};
}

/// Moves every pose by noise of that three-dimensional RMS, the same in all directions.
inline std::vector<RigidTransform> noisy(std::vector<RigidTransform> X_TS, Length rms,
                                         std::mt19937& random)
{
    std::normal_distribution<double> part{0.0, rms.si / std::sqrt(3.0)};
    for (RigidTransform& pose : X_TS)
        pose = shifted(pose, {part(random), part(random), part(random)});
    return X_TS;
}

inline Vec3 anySide(std::mt19937& random)
{
    std::normal_distribution<double> part;
    return Vec3{part(random), part(random), part(random)}.normalized();
}

/// Moves a share of the poses, any of them, to any side by between `least` and `most`.
inline void strike(std::vector<RigidTransform>& X_TS, double share, Length least, Length most,
                   std::mt19937& random)
{
    std::uniform_real_distribution<double> far{least.si, most.si};
    std::vector<std::size_t> order(X_TS.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    order.resize(std::size_t(std::lround(share * double(X_TS.size()))));
    for (const std::size_t i : order)
        X_TS[i] = shifted(X_TS[i], far(random) * anySide(random));
}

} // namespace carina::test
