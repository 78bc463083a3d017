#pragma once

#include "engine/core/result.h"
#include "engine/tracking/pose_sample.h"

#include <span>

namespace carina
{

/// How the clocks of two trackers that saw one motion lie to each other.
struct TimeShift {
    Duration late{};          ///< the second stamps the same moment so much later
    double correlation = 0.0; ///< of the two speeds at this shift, -1 to 1
};

/// The shift at which two recordings of one rigid body agree best, from the cross-correlation of
/// its angular speed: that is the same for all points of the body, in any frame, so that neither
/// the trackers' frames nor the probes' places on the body need to be known. Between shifts of
/// kShiftStep the maximum is that of a parabola.
///
/// @param first, second poses in ascending order of time; lost samples are left out
/// @param most the largest shift to either side
/// @returns TooFewPoses where they overlap by less than four times `most` at some shift;
///          NotEnoughMotion where the body turns too evenly or too little, and where the speeds do
///          not correlate by kLeastCorrelation or do so best at the largest shift.
[[nodiscard]] Result<TimeShift> timeShift(std::span<const PoseSample> first,
                                          std::span<const PoseSample> second,
                                          Duration most = std::chrono::milliseconds{500});

inline constexpr Duration kShiftStep = std::chrono::milliseconds{5};
inline constexpr double kLeastCorrelation = 0.7;

} // namespace carina
