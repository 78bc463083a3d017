#pragma once

#include "engine/geometry/fit/rigid_fit.h"
#include "engine/io/site/stale_marks.h"
#include "models/registration/stylus_watch.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// Functions that return a site after one change. Results that depend on the changed item are kept,
/// but marked as stale with the cause: touched points depend on tracker, stylus and landmark
/// positions, the registration on the touched points, its verification on the registration.

[[nodiscard]] Site withTracker(Site site, std::string tracker);

/// Replaces the tool's earlier calibration.
[[nodiscard]] Site withStylus(Site site, StylusTip stylus);

/// Replaces the earlier calibration of a tube or laryngoscope.
[[nodiscard]] Site withTool(Site site, SiteTool tool);

/// Sets the check of a tool that is calibrated. A tool that is found as it was is no longer stale
/// by a stylus that was calibrated after it: the check was made with that.
[[nodiscard]] Site withToolCheck(Site site, ToolRole role, SiteToolCheck check);

/// Sets the axis of a tool whose tip is known.
[[nodiscard]] Site withStylusAxis(Site site, const std::string& tool, StylusAxis axis);

/// Replaces the landmarks. A touch stays fresh if its landmark keeps its position.
[[nodiscard]] Site withLandmarks(Site site, LandmarkCatalogue catalogue);

/// Whether the manikin was re-registered after its landmarks were touched. The motion between is
/// not in these touches, so the covariance of a new fit would not include its error.
[[nodiscard]] bool isLaidAnew(const Site& site);

/// Adds a touch of a landmark, or replaces its earlier one.
[[nodiscard]] Site withTouch(Site site, const std::string& landmark, const StylusTouch& touch);

/// Reassigns the fresh touches to other landmarks.
/// @param touchOf as in OrderFinding, for touchedPairs()
[[nodiscard]] Site withOrder(Site site, const std::vector<std::size_t>& touchOf);

/// Adds a touch made after the manikin was moved, or replaces the landmark's earlier one.
/// @pre it is being re-registered.
[[nodiscard]] Site withRelayTouch(Site site, const std::string& landmark, const StylusTouch& touch);

/// Adds a check point of the verification, or replaces the one of the same name; resets the
/// verdict.
/// @pre it is registered.
[[nodiscard]] Site withVerified(Site site, VerifiedPoint point);

[[nodiscard]] Site withVerdict(Site site, Verdict verdict, std::string at);

/// The touch of a landmark; null if it was not touched.
[[nodiscard]] const TouchedPoint* touchOf(const Site& site, const std::string& landmark);

/// The touches that are not stale, in the catalogue's order. @pre the site outlives them.
[[nodiscard]] std::vector<const TouchedPoint*> freshTouches(const Site& site);

/// The fresh touches with their landmarks. The points are in the tracker frame T: p_MQ holds p_TQ.
[[nodiscard]] std::vector<LandmarkPair> touchedPairs(const Site& site);

} // namespace carina
