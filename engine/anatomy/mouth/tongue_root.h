#pragma once

#include "engine/anatomy/mouth/tongue_shape.h"

namespace carina
{

/// The muscles between the mandible's inside, the floor of the mouth and the hyoid bone, from which
/// the tongue comes: genioglossus and hyoglossus, as one solid below the tongue's underside.
/// Volumes of the tongue by MRI hold them: 89.9 (11.5) ml in men and 68.9 (7.0) in women (Liegeois
/// et al. 2010), where the tongue that stands in the mouth has 47.1 (7.1) ml (Ding et al. 2018, 20
/// adults of both sexes, cone-beam CT). It is as high as gives tongue and root together these
/// volumes, and less in children, whose tongue is long for its height: of ours.
[[nodiscard]] PartPlan tongueRoot(const BodyPlan& plan, const LarynxFrame& larynx,
                                  const Epiglottis& epiglottis, const Tongue& tongue);

} // namespace carina
