#pragma once

#include "engine/io/site_file.h"
#include "engine/registration/dwell_detector.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// How each thing that a technician achieves changes a site. What rests on what was changed is
/// taken away: touched points on the tracker and the stylus, a landmark's touch on its place, the
/// registration on all of them.

[[nodiscard]] Site withTracker(Site site, std::string tracker);

[[nodiscard]] Site withStylus(Site site, StylusTip stylus);

/// Landmarks that keep their place keep their touch.
[[nodiscard]] Site withLandmarks(Site site, LandmarkCatalogue catalogue);

/// The landmark was touched; a touch from before is replaced.
[[nodiscard]] Site withTouch(Site site, const std::string& landmark, const DwellPoint& point_T);

/// The anatomy fitted to the touched landmarks. @param X_TJ the chin probe, the mouth closed
/// @returns TooFewLandmarks without a catalogue; what fitManikin returns.
[[nodiscard]] Result<Site> withFit(Site site, const std::optional<RigidTransform>& X_TJ);

/// The touch of a landmark; null where it was not touched.
[[nodiscard]] const TouchedPoint* touchOf(const Site& site, const std::string& landmark);

} // namespace carina
