#pragma once

#include "engine/registration/error/target_error.h"

#include <optional>

namespace carina
{

/// What landmarks that are not yet touched will be good for.
struct LayoutReport {
    std::vector<TargetError> targets; ///< in their order
    std::size_t worst = 0;            ///< the target with the largest RMS error
    bool withinLimit = true;          ///< of the worst
};

/// Predicts the error at targets (places in A) before digitising. A layout that is nearly on one
/// line, or far from a target, shows as a large error there and the direction in which it is worst.
///
/// @param limit of the RMS error
/// @returns what fitCovariance returns; OutOfRange where there is no target.
[[nodiscard]] Result<LayoutReport> checkLayout(std::span<const LandmarkError> landmarks,
                                               std::span<const Vec3> targets, Length limit,
                                               Weighting weighting = Weighting::Alike);

/// The landmark that is worth touching too.
struct NextLandmark {
    std::size_t candidate = 0; ///< its place among the candidates
    Length worstRms;           ///< error at the worst target with it
};

/// Where one more landmark helps most: the candidate with which the error at the worst target is
/// least.
///
/// @returns what fitCovariance and checkLayout return; nothing where no candidate makes it less.
[[nodiscard]] Result<std::optional<NextLandmark>>
nextLandmark(std::span<const LandmarkError> landmarks, std::span<const LandmarkError> candidates,
             std::span<const Vec3> targets, Weighting weighting = Weighting::Alike);

} // namespace carina
