#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Numbers as NDI's commands have them.
namespace carina::ndi
{

/// The last so many digits of a number, capital letters.
[[nodiscard]] std::string inHexadecimal(std::size_t number, std::size_t digits);

/// Nothing where not all of the text is digits, or it is more than 16 bits.
[[nodiscard]] std::optional<std::uint16_t> fromHexadecimal(std::string_view digits);

} // namespace carina::ndi
