#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

namespace carina
{

/// Whether an object may be shared: one more than its owner has ever shared, under a name by which
/// it can be told. What was handed over or taken away counts for whoever shared it first, so that
/// nobody makes room for more by giving away; the host shares what it likes.
/// @returns NotPermitted; NameUnclear. Nothing for an object that is there already, and for other
///          facts.
[[nodiscard]] Result<void> checkShared(const SessionState& state, const FactBody& body);

/// Whether an object may pass to its new owner: known, neither an observer nor a trainee elsewhere,
/// with room for it; and the ownership that ends is the present one, so that of several at once the
/// first holds, and the others see that it did.
/// @returns OutOfRange; NotPermitted; OwnerChanged.
[[nodiscard]] Result<void> checkHandOver(const SessionState& state,
                                         const fact::ObjectHandedOver& handed);

/// Whether a trainee may hand this over: what is theirs, and to an instructor or to who asked for
/// it. With a tube comes the work at a station, and which tube is drawn: nobody gets one unasked.
/// @pre checkHandOver
[[nodiscard]] bool mayHandOver(const SessionState& state, const Participant& author,
                               const fact::ObjectHandedOver& handed);

} // namespace carina
