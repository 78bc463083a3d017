#pragma once

#include <cstddef>
#include <string_view>

namespace carina
{

/// Whether a text is a hash of a set: 64 hexadecimal digits in lower case. Check it before a
/// received text becomes part of a file name.
[[nodiscard]] constexpr bool isSetHash(std::string_view text)
{
    constexpr std::size_t kDigits = 64;
    return text.size() == kDigits
           && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

} // namespace carina
