#pragma once

#include "engine/registration/error/target_error.h"

#include <optional>

namespace carina
{

/// The predicted errors of a set of landmarks before they are touched.
struct LayoutReport {
    std::vector<TargetError> targets; ///< in the order of the targets
    std::size_t worst = 0;            ///< the target with the largest RMS error
    bool withinLimit = true;          ///< whether the worst RMS error is at most the limit
};

/// Predicts the TRE at targets (positions in A, metres) before any landmark is touched. A layout
/// that is nearly collinear, or far from a target, has a large error there; TargetError also gives
/// the direction in which it is largest.
///
/// @param limit largest acceptable RMS error
/// @returns the errors of fitCovariance; OutOfRange where there is no target; NotFinite or
///          OutOfRange for an invalid target.
[[nodiscard]] Result<LayoutReport> checkLayout(std::span<const LandmarkError> landmarks,
                                               std::span<const Vec3> targets, Length limit,
                                               Weighting weighting = Weighting::Alike);

/// The additional landmark that reduces the error most.
struct NextLandmark {
    std::size_t candidate = 0; ///< its index among the candidates
    Length worstRms;           ///< RMS error at the worst target with this landmark added
};

/// The candidate which, added to the landmarks, makes the error at the worst target smallest.
///
/// @returns the errors of checkLayout; nothing where no candidate reduces that error.
[[nodiscard]] Result<std::optional<NextLandmark>>
nextLandmark(std::span<const LandmarkError> landmarks, std::span<const LandmarkError> candidates,
             std::span<const Vec3> targets, Weighting weighting = Weighting::Alike);

} // namespace carina
