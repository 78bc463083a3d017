#pragma once

#include "engine/anatomy/patient/body_plan.h"

#include <vector>

namespace carina
{

/// Thyroid and cricoid cartilage, both arytenoid cartilages, both vocal ligaments, the epiglottis,
/// the hyoid bone, and what lines them (laryngealMucosa).
/// The cricoid sits on the trachea's upper end; the cords lie at cordsToCarina above the carina,
/// abducted as for breathing, on both sides of the extended axis of the trachea. In
/// Posture::Laryngoscopy the epiglottis is raised; at rest it leans over the entrance of the
/// larynx.
[[nodiscard]] std::vector<PartPlan> larynx(const BodyPlan& plan);

} // namespace carina
