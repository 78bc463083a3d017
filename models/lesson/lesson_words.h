#pragma once

#include "models/station/station_view.h"

#include <QString>

namespace carina
{

/// What a lesson shows, as a list: "section, highlights, names, view".
/// @param pointer whether something is pointed at as well
[[nodiscard]] QString lessonText(const Lesson& lesson, bool pointer);

/// "● The instructor shows: section, names", for whom something is shown; else empty.
/// @param followsView whether this program draws from where the instructor looks
[[nodiscard]] QString lessonNotice(const StationMoment& moment, bool followsView);

} // namespace carina
