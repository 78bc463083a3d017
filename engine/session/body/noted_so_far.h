#pragma once

#include "engine/airway/monitor/intubation_monitor.h"
#include "engine/session/body/tube_timeline.h"

namespace carina
{

/// What is known of the intubation of a patient by all that was noted, also where that is still to
/// take effect; nobody notes about a patient but who is at work there.
[[nodiscard]] NotedSoFar notedSoFar(const TubeTimeline& tube);

} // namespace carina
