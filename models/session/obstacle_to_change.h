#pragma once

#include "models/session/session_model.h"

#include <QString>

namespace carina
{

/// One sentence: why the person at this program cannot change the patients of the session; empty if
/// they can.
[[nodiscard]] QString obstacleToChange(const SessionModel& session);

/// One sentence: why the person at this program cannot handle cuff and stylet at a station, where
/// trainees who are there can, and instructors; empty if they can.
[[nodiscard]] QString obstacleToTube(const SessionModel& session, StationId station);

} // namespace carina
