#pragma once

#include "engine/io/site/site.h"
#include "engine/registration/fit/rigid_fit.h"
#include "models/registration/stylus_watch.h"

#include <optional>
#include <string>
#include <vector>

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

/// Whether the manikin was laid anew since what counts of it was touched: how it was laid anew is
/// not in these touches, so that no fit of them knows its error.
[[nodiscard]] bool isLaidAnew(const Site& site);

/// The landmark was touched; a touch from before is replaced.
[[nodiscard]] Site withTouch(Site site, const std::string& landmark, const StylusTouch& touch);

/// The fresh touches given to other landmarks. @param touchOf as OrderFinding has it, of
/// touchedPairs
[[nodiscard]] Site withOrder(Site site, const std::vector<std::size_t>& touchOf);

/// One more landmark touched since the manikin was moved; a touch from before is replaced.
/// @pre it is being laid anew.
[[nodiscard]] Site withRelayTouch(Site site, const std::string& landmark, const StylusTouch& touch);

/// A point that was touched to check the registration; one of the same name is replaced.
/// @pre it is registered.
[[nodiscard]] Site withVerified(Site site, VerifiedPoint point);

/// Marks what rests on something that was changed. The deepest cause stays: a result from before
/// the tracker was changed is of no use whatever else has changed since.
void makeStale(std::optional<StaleCause>& stale, StaleCause cause);

[[nodiscard]] Site withVerdict(Site site, Verdict verdict, std::string at);

/// The touch of a landmark; null where it was not touched.
[[nodiscard]] const TouchedPoint* touchOf(const Site& site, const std::string& landmark);

/// Touches that are not stale, in the catalogue's order. @pre the site outlives them.
[[nodiscard]] std::vector<const TouchedPoint*> freshTouches(const Site& site);

/// The same with their landmarks. Places in M are left out: p_MQ is in T.
[[nodiscard]] std::vector<LandmarkPair> touchedPairs(const Site& site);

} // namespace carina
