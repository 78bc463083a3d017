#pragma once

#include "engine/anatomy/larynx/epiglottis_shape.h"
#include "engine/anatomy/larynx/larynx_frame.h"

namespace carina
{

/// The hyoid bone with its greater and lesser horns. The body lies in the root of the tongue, in
/// front of the vallecula and as far before the epiglottis in either posture, but lower with the
/// mouth held open; the greater horns run back beside the pharynx.
///
/// In the man of the frame the body is 22 mm wide, and it is 36 mm from its front to the tips of
/// the greater horns: 19.3 +- 2.0 and 36.3 +- 3.3 mm in men (Monteiro and Jaseemudheen, CT of 68).
/// The horns stand as far apart as the pharynx between them is wide: 41.8 +- 5.1 mm in that source.
[[nodiscard]] PartPlan hyoid(const BodyPlan& plan, const LarynxFrame& frame,
                             const Epiglottis& epiglottis);

} // namespace carina
