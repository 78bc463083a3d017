#pragma once

#include "engine/io/site/site.h"
#include "engine/registration/fit/surface_refinement.h"
#include "engine/registration/watch/re_registration.h"
#include "models/registration/stylus_watch.h"

#include <optional>
#include <string>

namespace carina
{

/// Functions that return a site after a fit.

/// Inputs of a fit or re-registration besides the touches.
struct FitInputs {
    std::string tool;                     ///< the stylus that touched the landmarks
    std::optional<RigidTransform> X_TJ{}; ///< the chin probe with the mouth closed
    std::optional<RigidTransform> X_TB{}; ///< the body probe
    std::optional<TrackedTool> stylus{};  ///< as the tracker knows it
    std::string at;                       ///< ISO 8601
};

/// The inputs from the tools that the tracker sees now.
[[nodiscard]] FitInputs fitInputs(const StylusWatch& watch, std::string at);

/// The anatomy fitted to the touched landmarks that are not stale. The error of a touch is
/// estimated from its residuals and from earlier registrations by the same person at this site,
/// unless a touch is in both. Its own estimate is kept for later ones: in place of the person's
/// earlier one that shares touches with it, and not at all where that is another person's, whose
/// estimate stays as it is. No estimate is below the error with which the tracker saw the tip of
/// the stylus when it touched (TouchedPoint::seenError); of touches for which that was not noted,
/// as in files of before, below the one that is predicted of the stylus now (predictedError).
/// @returns TooFewLandmarks without a catalogue; the errors of fitManikin.
[[nodiscard]] Result<Site> withFit(Site site, const FitInputs& inputs);

/// The registration refined with points that a tool touched while sliding over a surface.
/// @pre it is registered.
[[nodiscard]] Site withSwab(Site site, const std::string& tool, const std::string& surface,
                            std::size_t points, const SurfaceRefinement& refinement);

/// The re-registered manikin, with all touches transformed to its new pose.
/// @pre it is registered and being re-registered.
[[nodiscard]] Site withRelay(Site site, const ReRegistration& relay, const FitInputs& inputs);

} // namespace carina
