#pragma once

#include "engine/tracking/motion_filter.h"
#include "engine/tracking/prediction.h"

#include <span>

namespace carina::lab
{

/// How far predicted poses are from those that were recorded at their time, and how far the filter
/// expected them to be: root mean squares.
struct PredictionScore {
    PredictionError error;
    double expectedPosition = 0.0; ///< metres
    double expectedRotation = 0.0; ///< radians
};

/// What predicts from the samples up to the newest one.
enum class Predictor {
    Hold,   ///< the newest pose
    Line,   ///< a straight line through the last six samples, by least squares
    Filter, ///< MotionFilter, with the acceleration that it estimates
};

/// Predicts from each of the samples from `first` on, which see all samples before them, and
/// compares with the recorded pose of that time, interpolated between its two neighbours. A time
/// after the last sample is left out, and one within a gap (measuredAt).
/// @param samples tracked poses in ascending order of time
/// @param smooths held poses and lines are those of samples after a OneEuroFilter
[[nodiscard]] PredictionScore predictionScore(std::span<const PoseSample> samples,
                                              std::size_t first, Duration ahead,
                                              Predictor predictor, const MotionFilter::Noise& noise,
                                              bool smooths = false);

/// The noise for which a filter predicts these samples best: the jerk of
/// MotionFilter::handsAndHeads() multiplied by that power of two from 2^-8 to 2^8 which gives the
/// least error, for rotation and position each on its own. For what is predicted only the ratio of
/// jerk and noise of measurement counts; both are then scaled so that the expected error is the one
/// that was found.
[[nodiscard]] MotionFilter::Noise bestNoise(std::span<const PoseSample> samples, Duration ahead);

} // namespace carina::lab
