#pragma once

#include "engine/tracking/pose_history.h"

#include <span>

namespace carina::lab
{

/// How far predicted poses are from those that were recorded at their time, and how far they were
/// expected to be: root mean squares.
struct PredictionScore {
    PredictionError error;
    double expectedPosition = 0.0; ///< metres
    double expectedRotation = 0.0; ///< radians
};

/// What predicts from the samples up to the newest one.
enum class Predictor {
    Line,    ///< a straight line through the last six samples, by least squares
    History, ///< what the programs draw: PoseHistory::shownAt
};

/// Predicts from each of the samples from `first` on, after all samples before it, and compares
/// with the recorded pose of that time, interpolated between its two neighbours. A time after the
/// last sample is left out, and one within a gap.
/// @param samples tracked poses in ascending order of time
/// @param treatment of the history
[[nodiscard]] PredictionScore predictionScore(std::span<const PoseSample> samples,
                                              std::size_t first, Duration ahead,
                                              Predictor predictor,
                                              const PoseTreatment& treatment = {});

} // namespace carina::lab
