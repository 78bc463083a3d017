#pragma once

#include "engine/anatomy/larynx/epiglottis_shape.h"
#include "engine/anatomy/larynx/larynx_frame.h"

#include <vector>

namespace carina
{

/// The mucosa of the mouth and of the pharynx, as one continuous cavity: from behind the lips
/// between the cheeks and over the floor of the mouth, through the fauces into the pharynx, up
/// behind the soft palate, and down on both sides of the larynx into the piriform fossae and behind
/// it to the entrance of the oesophagus. It is as thick as it must be to be drawn, and lies within
/// the constrictors.
/// Two parts: the lining of the cheeks as far as the last teeth and of the mouth's floor as far as
/// the arches of the fauces, which follow jaw and blade; and that of fauces and pharynx, which
/// follows less. Each goes on for a little outside the other: the pharynx behind the cheeks, the
/// floor of the mouth beside the pharynx.
[[nodiscard]] std::vector<PartPlan> throatLining(const BodyPlan& plan, const LarynxFrame& larynx,
                                                 const Epiglottis& epiglottis);

} // namespace carina
