#pragma once

#include "engine/anatomy/larynx/epiglottis_shape.h"
#include "engine/anatomy/larynx/larynx_frame.h"

namespace carina
{

/// The floor of the vallecula with the foot of its median and with its lateral glosso-epiglottic
/// folds (Gray 1918): from the front of the epiglottis forward below the base of the tongue, and to
/// both sides below the lining of the pharynx. It is fixed to the epiglottis and goes with it. At
/// rest it lies just below the tongue; where a blade takes the tongue away, it closes what would be
/// an opening between the epiglottis, the pharynx and the tongue.
[[nodiscard]] PartPlan vallecula(const LarynxFrame& frame, const Epiglottis& epiglottis);

} // namespace carina
