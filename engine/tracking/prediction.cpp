#include "engine/tracking/prediction.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr Duration kLongestMeasuredGap = std::chrono::milliseconds{150};

} // namespace

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

std::optional<RigidTransform> measuredAt(std::span<const PoseSample> samples, std::size_t from,
                                         SessionTime t)
{
    const auto after = std::ranges::lower_bound(samples.subspan(from), t, {}, &PoseSample::time);
    if (after == samples.end() || after == samples.begin())
        return std::nullopt;
    const PoseSample& before = *std::prev(after);
    const Duration gap = after->time - before.time;
    if (gap > kLongestMeasuredGap || after->validity == Validity::Lost
        || before.validity == Validity::Lost)
        return std::nullopt;
    return interpolate(before.X_FO, after->X_FO, toSeconds(t - before.time) / toSeconds(gap));
}

PredictionEffect predictionEffect(std::span<const PoseSample> samples, Duration ahead)
{
    PredictionEffect effect;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const PoseSample& sample = samples[i];
        if (sample.validity == Validity::Lost || !sample.motion)
            continue;
        const auto truth = measuredAt(samples, i + 1, sample.time + ahead);
        if (!truth)
            continue;
        Motion motion = *sample.motion;
        effect.held.add(sample.X_FO, *truth);
        effect.predicted.add(movedOn(sample.X_FO, motion, toSeconds(ahead)), *truth);
    }
    return {effect.held.root(), effect.predicted.root()};
}

} // namespace carina
