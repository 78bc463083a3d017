#pragma once

#include "engine/anatomy/anatomy.h"

#include <map>
#include <string>

namespace carina
{

/// Dimensions measured on the surfaces of a patient, in their finest level of detail, each under a
/// name that ends with its unit. What cannot be measured, for want of a part, is left out.
///
/// - trachea_length_mm, right_bronchus_deg, left_bronchus_deg, teeth_to_carina_mm: AirwayMeasures;
///   subcarinal_deg is the sum of both angles
/// - trachea_lumen_coronal_mm, trachea_lumen_sagittal_mm: medians over the middle half of the
///   trachea of what its wall encloses; trachea_lumen_mm2: of its area; trachea_lumen_ml: that
///   area times the length
/// - cords_to_carina_mm: along the trachea, from the middle between commissure and interarytenoid
///   notch; glottis_mm: between these two; vocal_fold_mm: extent of a fold along this line
/// - epiglottis_length_mm: from its lowest to its highest place in the midplane;
///   epiglottis_width_mm: from side to side; epiglottis_thickness_mm: in the midplane, half way up
/// - cricoid_arch_mm, cricoid_lamina_mm: height of the ring in front and behind;
///   cricoid_inner_coronal_mm, cricoid_inner_sagittal_mm: of the opening, half way up the arch
/// - thyroid_notch_to_cricoid_mm, epiglottis_to_cricoid_mm: from the floor of the notch, and from
///   the highest place of the epiglottis, down to the lower border of the cricoid in front
/// - tongue_ml: what the surfaces of the tongue and of the muscles that it comes from enclose;
///   right_lung_percent: share of the lobes
/// - bigonial_mm: greatest width of the lower half of the mandible
/// - manubrium_mm, sternal_body_mm: lengths
[[nodiscard]] std::map<std::string, double> measuredDimensions(const Anatomy& anatomy);

} // namespace carina
