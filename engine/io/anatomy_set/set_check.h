#pragma once

#include "engine/io/anatomy_set/imported_set.h"

namespace carina
{

/// Whether a set from another computer meets what every import guarantees and the rest of the
/// engine requires.
///
/// Every level of every part has at least one vertex, and a finite normal for each; everything is
/// within 10 m of the carina; the path of the tube has at most 4096 points, each 10 cm or less from
/// the last, and no corner sharper than a right angle.
///
/// @returns FileMalformed with the rule that is broken.
[[nodiscard]] Result<void> checkSet(const ImportedSet& set);

} // namespace carina
