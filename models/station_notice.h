#pragma once

#include "models/headset_view.h"
#include "models/station_view.h"

#include <QString>

namespace carina
{

/// The one thing a person at a station has to know now, as a translated line; empty when all is
/// well. In order of weight: what the host refused, no host, session not running, a patient that
/// was moved away from its place, headset (where there is one) or tube out of the tracker's view.
[[nodiscard]] QString stationNotice(const SessionNode& node, const StationMoment& moment,
                                    ViewOutput output);

} // namespace carina
