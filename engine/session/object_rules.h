#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

namespace carina
{

/// Whether an object may be shared at a station: as many to lift out as a station may have, and of
/// others one more than its owner has ever shared, under a name by which it can be told. What was
/// handed over or taken away counts for whoever shared it first, so that nobody makes room for more
/// by giving away; the host shares what it likes. A group of organs has the name of one.
/// @returns NotPermitted; NameUnclear; OutOfRange for an unknown group. Nothing for an object that
///          is there already.
[[nodiscard]] Result<void> checkShared(const SessionState& state, StationId station,
                                       const fact::ObjectShared& shared);

/// Whether an object may pass to another participant, or be put back: the new owner is known,
/// neither an observer nor a trainee elsewhere, and has room for it; and the ownership that ends is
/// the present one, so that of several at once the first holds, and the others see that it did. An
/// instructor who takes an object, or has asked for it, always has room; of what trainees give
/// unasked, for kMostGiven.
/// @param author who hands it over, whether or not they may (mayPassOn)
/// @returns OutOfRange for an unknown object or participant, and for one who is absent and is to
///          hold what was lifted out; NotPermitted; OwnerChanged.
[[nodiscard]] Result<void> checkHandOver(const SessionState& state, ParticipantId author,
                                         const fact::ObjectHandedOver& handed);

/// Whether an object may be asked for: it is known, and somebody owns it.
/// @returns OutOfRange; OwnerChanged for one that was put back.
[[nodiscard]] Result<void> checkWish(const SessionState& state, const fact::ObjectWanted& wanted);

/// Whether a trainee may do this with an object: put back what is theirs, hand it over to an
/// instructor or to who asked for it, and lift out for themselves what is in its place at their
/// station. With a tube comes the work at a station, and which tube is drawn: nobody gets one
/// unasked.
/// @pre checkHandOver
[[nodiscard]] bool mayPassOn(const SessionState& state, const Participant& trainee,
                             const fact::ObjectHandedOver& handed);

} // namespace carina
