#pragma once

#include "engine/io/site.h"
#include "engine/registration/re_registration.h"
#include "engine/registration/rigid_fit.h"
#include "engine/registration/surface_refinement.h"
#include "models/stylus_watch.h"

#include <optional>
#include <string>

namespace carina
{

/// How each thing that a technician achieves changes a site. What rests on it stays, and is marked
/// as stale with what was changed beneath: touched points rest on tracker, stylus and the places of
/// their landmarks, the registration on the touched points, its verification on the registration.

[[nodiscard]] Site withTracker(Site site, std::string tracker);

/// Takes the place of the tool's calibration from before.
[[nodiscard]] Site withStylus(Site site, StylusTip stylus);

/// The axis of a tool whose tip is known.
[[nodiscard]] Site withStylusAxis(Site site, const std::string& tool, StylusAxis axis);

/// Landmarks that keep their place keep their touch as it is.
[[nodiscard]] Site withLandmarks(Site site, LandmarkCatalogue catalogue);

/// The landmark was touched; a touch from before is replaced.
[[nodiscard]] Site withTouch(Site site, const std::string& landmark, const StylusTouch& touch);

/// The fresh touches given to other landmarks. @param touchOf as OrderFinding has it, of
/// touchedPairs
[[nodiscard]] Site withOrder(Site site, const std::vector<std::size_t>& touchOf);

/// What a fit is made with besides the touches.
struct FitInputs {
    std::string tool;                     ///< whose tip they were touched with
    std::optional<RigidTransform> X_TJ{}; ///< the chin probe, the mouth closed
    std::optional<RigidTransform> X_TB{}; ///< the body probe
    std::string at;                       ///< ISO 8601
};

/// The anatomy fitted to the touched landmarks that are not stale.
/// @returns TooFewLandmarks without a catalogue; what fitManikin returns.
[[nodiscard]] Result<Site> withFit(Site site, const FitInputs& inputs);

/// The registration refined on a surface.
/// @pre it is registered.
[[nodiscard]] Site withSwab(Site site, const std::string& surface, std::size_t points,
                            const SurfaceRefinement& refinement);

/// One more landmark touched since the manikin was moved; a touch from before is replaced.
/// @pre it is being laid anew.
[[nodiscard]] Site withRelayTouch(Site site, const std::string& landmark, const StylusTouch& touch);

/// The manikin laid anew, with all that was touched on it.
/// @pre it is registered and being laid anew.
[[nodiscard]] Site withRelay(Site site, const ReRegistration& relay, std::string at);

/// A point that was touched to check the registration; one of the same name is replaced.
/// @pre it is registered.
[[nodiscard]] Site withVerified(Site site, VerifiedPoint point);

[[nodiscard]] Site withVerdict(Site site, Verdict verdict, std::string at);

/// The touch of a landmark; null where it was not touched.
[[nodiscard]] const TouchedPoint* touchOf(const Site& site, const std::string& landmark);

/// How many landmarks were touched since nothing beneath was changed.
[[nodiscard]] std::size_t freshTouches(const Site& site);

/// Touches that are not stale, with their landmarks, in the catalogue's order. Places in M are left
/// out: p_MQ is in T.
[[nodiscard]] std::vector<LandmarkPair> touchedPairs(const Site& site);

} // namespace carina
