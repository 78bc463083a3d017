#pragma once

#include "engine/anatomy/larynx/epiglottis_shape.h"
#include "engine/anatomy/larynx/larynx_frame.h"

#include <vector>

namespace carina
{

/// What lines the larynx, as it is seen from above: the mucosa with the aryepiglottic folds, their
/// cuneiform and corniculate tubercles, the interarytenoid notch, and the vestibular and vocal
/// folds. The folds and tubercles stand a little above the mucosa, so that each is seen in its own
/// colour.
[[nodiscard]] std::vector<PartPlan> laryngealMucosa(const BodyPlan& plan, const LarynxFrame& frame,
                                                    const Epiglottis& epiglottis);

/// The fleshy body of the larynx with its cavity filled: below zero inside, near its surface about
/// the distance. Millimetres of LarynxFrame.
[[nodiscard]] double laryngealBody(const Vec3& p, const Epiglottis& epiglottis);

} // namespace carina
