#pragma once

#include "engine/anatomy/laryngoscopy/blade.h"
#include "engine/registration/calibration/blade_calibration.h"

namespace carina
{

/// A blade as it was touched: a curved one lifts the epiglottis by the ligament, a straight one
/// itself, and its camera is where those of known blades are, a third of the way from the tip.
[[nodiscard]] Blade touchedBlade(const BladeShape& shape);

} // namespace carina
