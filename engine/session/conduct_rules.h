#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

namespace carina
{

/// Whether a fact is about who takes part, and thus about no station, and possible after the end.
[[nodiscard]] bool isAboutConduct(const FactBody& body);

/// Whether the participant that a fact about conduct names is known.
/// @returns OutOfRange with its number.
[[nodiscard]] Result<void> checkNamed(const SessionState& state, const FactBody& body);

/// Whether a participant takes up one of the places of its role: who is present, and who left and
/// was not removed, for as long as they had been there, at most kPlaceKept.
[[nodiscard]] bool hasPlace(const Participant& participant, SessionTime now);

/// Whether the participant of a ParticipantJoined may come in. @pre its number is settled; 0 is new
/// @returns Banned with who banned it and why; SessionLocked for somebody new.
[[nodiscard]] Result<void> checkEntry(const SessionState& state, const FactBody& body);

/// Nobody may be muted or removed whom the session cannot do without: its host, and the last
/// instructor. @pre checkNamed
/// @returns NotPermitted.
[[nodiscard]] Result<void> checkConduct(const SessionState& state, const FactBody& body);

} // namespace carina
