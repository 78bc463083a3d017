#pragma once

#include "engine/lungs/mechanics/respiratory_fold.h"
#include "engine/lungs/mechanics/tube_place.h"
#include "engine/physiology/gas_supply.h"

namespace carina
{

/// Whether what a bag or ventilator delivers reaches the lungs. It does not through a tube in the
/// oesophagus, nor where a tube that is watched (TubeTimeline::placeAt) lies above the cords and no
/// mask is held. Where nobody watches a tube it does: a session whose console alone says how the
/// patient is ventilated needs neither tube nor mask.
[[nodiscard]] bool reachesLungs(const TubePlace& tube, const GasSupply& gas);

/// How the patient is ventilated by these settings through a tube, in place of the one that is set:
///
/// - In a main bronchus: MainstemIntubation of that side with severity 1, unless one is set.
/// - Where nothing reaches the lungs, as without bag and ventilator: the patient breathes alone.
/// - A leak takes its share of the volume that a bag, or a ventilator in volume control, delivers,
///   down to kSmallestTidalVolume; pressure control makes up for it.
/// - Of an obstruction: Obstruction of both lungs, as severe as loses as much pressure in the
///   trachea, which is wider than the tube. A tube that is wholly shut lets nothing through.
[[nodiscard]] RespiratorySettings ventilatedThrough(const RespiratorySettings& settings,
                                                    const TubePlace& tube, const GasSupply& gas);

/// Rate at which bag or ventilator blow into the oesophagus; 0 where they do not.
[[nodiscard]] Frequency stomachBreaths(const RespiratorySettings& settings, const TubePlace& tube);

/// Adds an obstruction of the airway to what a patient has: the worse of two counts. Where a lung
/// has one of its own, it meets each lung. Where the patient has kMostConditions, it takes the
/// place of the mildest.
void obstruct(LungConditions& conditions, double severity);

} // namespace carina
