#include "apps/lab/tracking/prediction_score.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace carina::lab
{
namespace
{

constexpr std::size_t kLineSamples = 6;
constexpr int kPowers = 8; // of two, up and down

/// The recorded pose at t, which is after samples[from].
std::optional<RigidTransform> recordedAt(std::span<const PoseSample> samples, std::size_t from,
                                         SessionTime t)
{
    const auto after = std::ranges::lower_bound(samples.subspan(from), t, {}, &PoseSample::time);
    if (after == samples.end())
        return std::nullopt;
    const PoseSample& before = *std::prev(after);
    const Duration gap = after->time - before.time;
    if (gap > MotionFilter::kLongestGap)
        return std::nullopt;
    return interpolate(before.X_FO, after->X_FO, toSeconds(t - before.time) / toSeconds(gap));
}

/// Extrapolates the line of least squares through `values` at `times`, seconds from the last.
Vec3 onLine(std::span<const double> times, std::span<const Vec3> values, double ahead)
{
    double meanTime = 0.0;
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < times.size(); ++i) {
        meanTime += times[i] / double(times.size());
        mean += values[i] / double(times.size());
    }
    double spread = 0.0;
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < times.size(); ++i) {
        spread += (times[i] - meanTime) * (times[i] - meanTime);
        moment += (times[i] - meanTime) * (values[i] - mean);
    }
    return mean + (ahead - meanTime) / spread * moment;
}

RigidTransform lineAhead(std::span<const PoseSample> last, double ahead)
{
    std::vector<double> times;
    std::vector<Vec3> places;
    std::vector<Vec3> turns; // from the newest
    const PoseSample& newest = last.back();
    for (const PoseSample& sample : last) {
        times.push_back(toSeconds(sample.time - newest.time));
        places.push_back(sample.X_FO.translation());
        turns.push_back(
            rotationVector(sample.X_FO.rotation() * newest.X_FO.rotation().conjugate()));
    }
    return {rotationFromVector(onLine(times, turns, ahead)) * newest.X_FO.rotation(),
            onLine(times, places, ahead)};
}

RigidTransform ahead(std::span<const PoseSample> seen, const MotionFilter& filter, Duration time,
                     Predictor predictor)
{
    if (predictor == Predictor::Filter && filter.motion())
        return filter.predicted(seen.back().time + time);
    if (predictor == Predictor::Line && seen.size() >= kLineSamples)
        return lineAhead(seen.last(kLineSamples), toSeconds(time));
    return seen.back().X_FO;
}

} // namespace

PredictionError predictionError(std::span<const PoseSample> samples, std::size_t first,
                                Duration time, Predictor predictor,
                                const MotionFilter::Noise& noise)
{
    MotionFilter filter{noise};
    PredictionError sum;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        filter.add(samples[i]);
        if (i < first)
            continue;
        const auto truth = recordedAt(samples, i + 1, samples[i].time + time);
        if (!truth)
            continue;
        const RigidTransform pose = ahead(samples.first(i + 1), filter, time, predictor);
        const double turn = angleBetween(truth->rotation(), pose.rotation()).si;
        sum.position += (truth->translation() - pose.translation()).squaredNorm();
        sum.rotation += turn * turn;
        ++sum.poses;
    }
    const double poses = std::max(1.0, double(sum.poses));
    return {std::sqrt(sum.position / poses), std::sqrt(sum.rotation / poses), sum.poses};
}

MotionFilter::Noise bestNoise(std::span<const PoseSample> samples, Duration time)
{
    const MotionFilter::Noise usual = MotionFilter::handsAndHeads();
    MotionFilter::Noise best = usual;
    PredictionError least{std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::infinity()};
    for (int power = -kPowers; power <= kPowers; ++power) {
        MotionFilter::Noise noise = usual;
        noise.rotation.jerk *= std::exp2(power);
        noise.position.jerk *= std::exp2(power);
        const PredictionError error = predictionError(samples, 0, time, Predictor::Filter, noise);
        if (error.rotation < least.rotation)
            best.rotation = noise.rotation;
        if (error.position < least.position)
            best.position = noise.position;
        least = {std::min(least.position, error.position),
                 std::min(least.rotation, error.rotation)};
    }
    return best;
}

} // namespace carina::lab
