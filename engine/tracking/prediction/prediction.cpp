#include "engine/tracking/prediction/prediction.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace carina
{

RigidTransform movedOn(const RigidTransform& X_FO, Motion& motion, double dt)
{
    constexpr double kLasts = toSeconds(kAccelerates);
    const double rest = std::max(0.0, dt - kLasts);
    const double gained = (dt * dt - rest * rest) / 2.0;
    const Vec3 turn = dt * motion.w_FO + gained * motion.alpha_FO;
    const Vec3 way = dt * motion.v_FO + gained * motion.a_FO;
    motion.v_FO += std::min(dt, kLasts) * motion.a_FO;
    motion.w_FO += std::min(dt, kLasts) * motion.alpha_FO;
    if (dt >= kLasts)
        motion.a_FO = motion.alpha_FO = Vec3::Zero();
    return {rotationFromVector(turn) * X_FO.rotation(), X_FO.translation() + way};
}

void PredictionError::add(const RigidTransform& predicted, const RigidTransform& truth)
{
    const double turn = angleBetween(truth.rotation(), predicted.rotation()).si;
    position += (truth.translation() - predicted.translation()).squaredNorm();
    rotation += turn * turn;
    ++poses;
}

PredictionError PredictionError::root() const
{
    const double count = std::max(1.0, double(poses));
    return {std::sqrt(position / count), std::sqrt(rotation / count), poses};
}

} // namespace carina
