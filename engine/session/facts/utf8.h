#pragma once

#include <string_view>

namespace carina
{

/// Whether the bytes are well-formed UTF-8 (RFC 3629): no overlong form, no surrogate, nothing
/// above U+10FFFF, no truncated character.
[[nodiscard]] bool isUtf8(std::string_view bytes);

} // namespace carina
