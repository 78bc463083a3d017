#include "apps/lab/tracking/prediction_score.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace carina::lab
{
namespace
{

constexpr std::size_t kLineSamples = 6;

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

RigidTransform linePose(std::span<const PoseSample> seen, double ahead)
{
    return seen.size() >= kLineSamples ? lineAhead(seen.last(kLineSamples), ahead)
                                       : seen.back().X_FO;
}

} // namespace

PredictionScore predictionScore(std::span<const PoseSample> samples, std::size_t first,
                                Duration time, Predictor predictor, const PoseTreatment& treatment)
{
    PoseHistory recorded{{.capacity = samples.size()}};
    for (const PoseSample& sample : samples)
        recorded.push(sample);
    PoseHistory history{{.estimates = true}};
    history.treat(treatment);
    PredictionScore score;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        history.push(samples[i]);
        const SessionTime then = samples[i].time + time;
        const auto truth = i < first ? std::nullopt : recorded.at(then);
        if (!truth || truth->how == How::Predicted)
            continue;
        const auto shown = history.shownAt(then);
        score.error.add(predictor == Predictor::Line
                            ? linePose(samples.first(i + 1), toSeconds(time))
                            : shown->X_FO,
                        truth->X_FO);
        if (shown->deviation) {
            score.expectedPosition += std::pow(shown->deviation->position.si, 2);
            score.expectedRotation += std::pow(shown->deviation->rotation.si, 2);
        }
    }
    const double poses = std::max(1.0, double(score.error.poses));
    score.error = score.error.root();
    score.expectedPosition = std::sqrt(score.expectedPosition / poses);
    score.expectedRotation = std::sqrt(score.expectedRotation / poses);
    return score;
}

} // namespace carina::lab
