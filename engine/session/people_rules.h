#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

namespace carina
{

/// Whether a fact about the people of a station can be: who is to be at work is there and no
/// observer, and the work is still with who had it; who gets a place is known.
/// @returns OutOfRange for somebody who is not there; NotPermitted with the name of an observer;
///          OwnerChanged with the station's name. Nothing for other facts.
[[nodiscard]] Result<void> checkPeople(const SessionState& state, StationId station,
                                       const FactBody& body);

/// Whether a trainee may do this with the work of a station: take up what nobody does there, and
/// pass on what they do themselves, to anybody there. @pre checkPeople
[[nodiscard]] bool mayPassOnWork(const SessionState& state, const Participant& author,
                                 StationId station, const fact::WorkTaken& taken);

} // namespace carina
