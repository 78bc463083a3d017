#pragma once

#include "engine/io/site/site.h"
#include "engine/registration/fit/surface_refinement.h"
#include "engine/registration/watch/re_registration.h"
#include "models/registration/stylus_watch.h"

#include <optional>
#include <string>

namespace carina
{

/// How fitting the anatomy to what was touched changes a site.

/// What a fit, or laying a manikin anew, is made with besides the touches.
struct FitInputs {
    std::string tool;                     ///< whose tip they were touched with
    std::optional<RigidTransform> X_TJ{}; ///< the chin probe, the mouth closed
    std::optional<RigidTransform> X_TB{}; ///< the body probe
    std::string at;                       ///< ISO 8601
};

/// As the stylus and the probes are seen now.
[[nodiscard]] FitInputs fitInputs(const StylusWatch& watch, std::string at);

/// The anatomy fitted to the touched landmarks that are not stale.
/// @returns TooFewLandmarks without a catalogue; what fitManikin returns.
[[nodiscard]] Result<Site> withFit(Site site, const FitInputs& inputs);

/// The registration refined on a surface that was swabbed with a tool.
/// @pre it is registered.
[[nodiscard]] Site withSwab(Site site, const std::string& tool, const std::string& surface,
                            std::size_t points, const SurfaceRefinement& refinement);

/// The manikin laid anew, with all that was touched on it.
/// @pre it is registered and being laid anew.
[[nodiscard]] Site withRelay(Site site, const ReRegistration& relay, const FitInputs& inputs);

} // namespace carina
