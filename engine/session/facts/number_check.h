#pragma once

#include "engine/core/result.h"

namespace carina
{

/// Whether a number of a fact is within its range.
/// @param value in `unit`, as are `lowest` and `highest`
/// @returns OutOfRange naming the value and its range; NotFinite for NaN or infinity.
[[nodiscard]] Result<void> checkNumber(const char* what, double value, double lowest,
                                       double highest, const char* unit);

} // namespace carina
