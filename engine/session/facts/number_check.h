#pragma once

#include "engine/core/result.h"

namespace carina
{

/// Whether a number of a fact lies in its range. Number and range are in the unit shown.
/// @returns OutOfRange naming the value and its range; NotFinite for a NaN or an infinity.
[[nodiscard]] Result<void> checkNumber(const char* what, double value, double lowest,
                                       double highest, const char* unit);

} // namespace carina
