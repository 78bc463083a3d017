#pragma once

#include "models/station/headset_view.h"
#include "models/station/station_view.h"

#include <QString>

namespace carina
{

/// What a person at a station has to know now, as translated lines; empty when all is well. One
/// line of what goes on, in order of weight: what the host refused, no host, session not running,
/// headset (where there is one) or tube out of the tracker's view. And one whenever the patient was
/// moved away from its place.
[[nodiscard]] QString stationNotice(const SessionNode& node, const StationMoment& moment,
                                    ViewOutput output);

} // namespace carina
