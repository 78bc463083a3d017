#pragma once

#include "engine/io/anatomy_set/imported_set.h"

namespace carina
{

/// Whether a set that somebody else made may be drawn: what an import always makes, and what the
/// rest of the engine counts on.
///
/// Every level of every part has a vertex, and a finite normal for each; everything lies within
/// 10 m of the carina; and the way of the tube goes on with each of its at most 4096 points, by
/// 10 cm or less and without a corner sharper than a right angle.
///
/// @returns FileMalformed with the rule that is broken.
[[nodiscard]] Result<void> checkSet(const ImportedSet& set);

} // namespace carina
