#pragma once

#include <concepts>
#include <type_traits>

namespace carina
{

/// Whether a wrapping sequence number a is after b: ahead by less than half of its range.
template <std::unsigned_integral Number> [[nodiscard]] constexpr bool isAfter(Number a, Number b)
{
    return static_cast<std::make_signed_t<Number>>(static_cast<Number>(a - b)) > 0;
}

} // namespace carina
