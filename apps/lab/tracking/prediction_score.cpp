#include "apps/lab/tracking/prediction_score.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/one_euro_filter.h"

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
constexpr std::size_t kSettlingSamples = 60;
constexpr double kLeastScale = 1e-3; // of the noise: a motion may be predicted exactly

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

/// All deviations of a filter times a factor, which changes what it expects and not what it
/// predicts.
AccelerationFilter::Noise scaled(const AccelerationFilter::Noise& noise, double by)
{
    const double factor = std::max(kLeastScale, by);
    return {.measurement = factor * noise.measurement,
            .jerk = factor * noise.jerk,
            .rate = factor * noise.rate,
            .acceleration = factor * noise.acceleration};
}

} // namespace

PredictionScore predictionScore(std::span<const PoseSample> samples, std::size_t first,
                                Duration time, Predictor predictor,
                                const MotionFilter::Noise& noise, bool smooths)
{
    MotionFilter filter{noise};
    OneEuroFilter smoothing;
    PredictionScore score;
    std::vector<PoseSample> seen;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        seen.push_back(smooths ? smoothing.smoothed(samples[i]) : samples[i]);
        filter.add(samples[i]);
        if (i < first)
            continue;
        const auto truth = measuredAt(samples, i + 1, samples[i].time + time);
        if (!truth)
            continue;
        score.error.add(ahead(seen, filter, time, predictor), *truth);
        if (const auto motion = filter.motion()) {
            const double seconds = toSeconds(time);
            score.expectedPosition +=
                std::pow(ErrorGrowth::rmsAfter(seconds, motion->growth->position), 2);
            score.expectedRotation +=
                std::pow(ErrorGrowth::rmsAfter(seconds, motion->growth->rotation), 2);
        }
    }
    const double poses = std::max(1.0, double(score.error.poses));
    score.error = score.error.root();
    score.expectedPosition = std::sqrt(score.expectedPosition / poses);
    score.expectedRotation = std::sqrt(score.expectedRotation / poses);
    return score;
}

MotionFilter::Noise bestNoise(std::span<const PoseSample> samples, Duration time)
{
    const MotionFilter::Noise usual = MotionFilter::handsAndHeads();
    MotionFilter::Noise best = usual;
    // What a filter expects before it has settled would outweigh all that follows.
    const std::size_t first = std::min(kSettlingSamples, samples.size() / 4);
    PredictionScore leastPosition;
    PredictionScore leastRotation;
    leastPosition.error.position = leastRotation.error.rotation =
        std::numeric_limits<double>::infinity();
    for (int power = -kPowers; power <= kPowers; ++power) {
        MotionFilter::Noise noise = usual;
        noise.rotation.jerk *= std::exp2(power);
        noise.position.jerk *= std::exp2(power);
        const PredictionScore score =
            predictionScore(samples, first, time, Predictor::Filter, noise);
        if (score.error.rotation < leastRotation.error.rotation) {
            best.rotation = noise.rotation;
            leastRotation = score;
        }
        if (score.error.position < leastPosition.error.position) {
            best.position = noise.position;
            leastPosition = score;
        }
    }
    return {scaled(best.rotation, leastRotation.error.rotation / leastRotation.expectedRotation),
            scaled(best.position, leastPosition.error.position / leastPosition.expectedPosition)};
}

} // namespace carina::lab
