#pragma once

#include "models/station/station_view.h"

#include <QString>

#include <optional>

namespace carina
{

/// What is written beside an object that a person at a station shares: the name of its owner beside
/// a head, and whose tube it is beside a tube; nothing beside the others.
[[nodiscard]] QString nameBeside(const PersonPose& person, ParticipantId worker);

/// That a view is the one through the eyes of a participant, and whether it can be drawn.
[[nodiscard]] QString throughEyesText(const SessionState& state, const StationMoment& moment,
                                      ParticipantId participant);

} // namespace carina
