#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Thyroid and cricoid cartilage, both arytenoid cartilages, both vocal cords and the epiglottis.
/// The cricoid sits on the trachea's upper end; the cords lie at their height above the carina,
/// parted as for breathing, on both sides of the trachea's axis produced. In a laryngoscope's
/// posture the epiglottis is raised; at rest it leans over the way into the larynx.
[[nodiscard]] std::vector<PartPlan> larynx(const BodyPlan& plan);

} // namespace carina
