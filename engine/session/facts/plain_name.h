#pragma once

#include "engine/core/result.h"

#include <string>
#include <string_view>

namespace carina
{

/// Characters of a participant's name.
inline constexpr int kLongestName = 64;

/// Whether a participant can be told by this name: a visible character at both ends, and no
/// character that cannot be seen or that changes the order of others (Unicode categories Cc, Cf,
/// Cs, Co, Cn, Zl, Zp).
/// @returns NameUnclear otherwise, and for more than kLongestName characters.
[[nodiscard]] Result<void> checkName(std::string_view utf8);

/// Two names look alike where these are equal: the skeleton of Unicode Technical Standard 39
/// ("Unicode Security Mechanisms") of the name without differences of case and of blanks.
[[nodiscard]] std::string lookOf(std::string_view utf8);

} // namespace carina
