#pragma once

#include "engine/core/result.h"

#include <initializer_list>

namespace carina
{

/// Whether a number of a fact is within its range.
/// @param value in `unit`, as are `lowest` and `highest`
/// @returns OutOfRange naming the value and its range; NotFinite for NaN or infinity.
[[nodiscard]] Result<void> checkNumber(const char* what, double value, double lowest,
                                       double highest, const char* unit);

/// What checkNumber is asked.
struct CheckedNumber {
    const char* what;
    double value;
    double lowest;
    double highest;
    const char* unit;
};

/// @returns the error of the first that is out of its range.
[[nodiscard]] Result<void> checkNumbers(std::initializer_list<CheckedNumber> numbers);

} // namespace carina
