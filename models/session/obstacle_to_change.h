#pragma once

#include "models/session/session_model.h"

#include <QString>

namespace carina
{

/// One sentence: why the person at this program cannot change the patients of the session; empty if
/// they can.
[[nodiscard]] QString obstacleToChange(const SessionModel& session);

} // namespace carina
