#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

namespace carina
{

/// Whether what a lesson shows is possible: a plane with a normal of length 1, within
/// kFarthestSection of the origin of A, and looks of parts in their order, each part once.
/// @returns OutOfRange; NotFinite.
[[nodiscard]] Result<void> checkLesson(const Lesson& lesson);

inline constexpr double kFarthestSection = 10.0; ///< metres

/// Whether a lesson can be shown to its target: everybody, or a participant who is known and no
/// instructor; and whether there is one to end.
/// @pre the station is known
/// @returns OutOfRange; NotPermitted with the name of an instructor. Nothing for other facts.
[[nodiscard]] Result<void> checkLessons(const SessionState& state, StationId station,
                                        const FactBody& body);

/// What is shown to a participant at the station where they are; nullptr where nothing is, and for
/// whoever shows it. @pre the state outlives what is returned.
[[nodiscard]] const ShownLesson* lessonFor(const SessionState& state, ParticipantId participant);

} // namespace carina
