#pragma once

#include "apps/lab/command/words.h"

namespace carina::lab
{

/// Measures one run after the other, and tells on stderr which it is at.
///
/// @returns what tableRequests does. A run that fails is a row with the reason.
[[nodiscard]] Result<QJsonObject> driftTable(const Words& words);

/// The keys of a run that a row of the table has.
[[nodiscard]] std::vector<Key> keysOfRow();

} // namespace carina::lab
