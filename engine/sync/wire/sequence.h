#pragma once

#include <concepts>
#include <type_traits>

namespace carina
{

/// Whether a number that counts up and wraps has passed another: less than half its range ahead.
template <std::unsigned_integral Number> [[nodiscard]] constexpr bool isAfter(Number a, Number b)
{
    return static_cast<std::make_signed_t<Number>>(static_cast<Number>(a - b)) > 0;
}

} // namespace carina
