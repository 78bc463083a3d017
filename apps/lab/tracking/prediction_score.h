#pragma once

#include "engine/tracking/motion_filter.h"

#include <span>

namespace carina::lab
{

/// How far predicted poses are from those that were recorded at their time: root mean squares.
struct PredictionError {
    double position = 0.0; ///< metres
    double rotation = 0.0; ///< radians
    std::size_t poses = 0; ///< that were predicted
};

/// What predicts from the samples up to the newest one.
enum class Predictor {
    Hold,   ///< the newest pose
    Line,   ///< a straight line through the last six samples, by least squares
    Filter, ///< MotionFilter, with the acceleration that it estimates
};

/// Predicts from each of the samples from `first` on, which see all samples before them, and
/// compares with the recorded pose of that time, interpolated between its two neighbours. A time
/// after the last sample is left out, and one within a gap of more than MotionFilter::kLongestGap.
/// @param samples tracked poses in ascending order of time
[[nodiscard]] PredictionError predictionError(std::span<const PoseSample> samples,
                                              std::size_t first, Duration ahead,
                                              Predictor predictor,
                                              const MotionFilter::Noise& noise);

/// The noise for which a filter predicts these samples best: the jerk of
/// MotionFilter::handsAndHeads() multiplied by that power of two from 2^-8 to 2^8 which gives the
/// least error, for rotation and position each on its own. The noise of measurement stays: once a
/// filter has settled, only the ratio of the two counts.
[[nodiscard]] MotionFilter::Noise bestNoise(std::span<const PoseSample> samples, Duration ahead);

} // namespace carina::lab
