#pragma once

#include "engine/anatomy/events/airway_event.h"

#include <functional>

namespace carina
{

/// Whether a patient's surfaces have what an event changes.
using ShowsEvent = std::function<bool(AirwayEventKind)>;

/// Events as severe as they are drawn, without those that are not shown.
///
/// A Burn swells tongue, pharynx, epiglottis and the entrance of the larynx: their events are at
/// least a share of its severity; so does Swallowing while the larynx rises (riseInSwallow), of
/// pharynx, epiglottis and entrance. And TongueOedema, PharyngealSwelling, Epiglottitis and
/// FloppyEpiglottis take the same room, the throat's: two of them at their worst fill it, so where
/// their severities are more than 2 together each is less, in proportion. Of ours.
/// @pre areProper(events)
[[nodiscard]] AirwayEvents asDrawn(const AirwayEvents& events, const ShowsEvent& shows);

} // namespace carina
