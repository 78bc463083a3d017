#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

namespace carina
{

/// Whether an object may pass to another participant, or be put back. Compare and set: of several
/// at once the first holds, and the others see that it did.
/// @returns OutOfRange for an unknown object or participant, and for one who is absent and is to
///          hold what was lifted out; NotPermitted with the name of one who may not own it, or who
///          holds as much as they may; OwnerChanged.
[[nodiscard]] Result<void> checkHandOver(const SessionState& state,
                                         const fact::ObjectHandedOver& handed);

/// Whether an object may be asked for: it is known, and somebody owns it.
/// @returns OutOfRange; OwnerChanged for one that was put back.
[[nodiscard]] Result<void> checkWish(const SessionState& state, const fact::ObjectWanted& wanted);

/// Whether a trainee may do this with an object at their station: hand over what is their own, put
/// it back, and lift out for themselves what is in its place.
[[nodiscard]] bool mayPassOn(const SessionState& state, const Participant& trainee,
                             const fact::ObjectHandedOver& handed);

/// Whether an object may be shared at a station, by numbers: as many as the role of its owner may
/// have, and as many to lift out as a station may have. A group of organs has the name of one.
/// @returns NotPermitted; OutOfRange for an unknown group.
[[nodiscard]] Result<void> checkShared(const SessionState& state, StationId station,
                                       const fact::ObjectShared& shared);

} // namespace carina
