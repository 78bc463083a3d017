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

/// Whether two names look alike, by the skeletons of Unicode Technical Standard 39 ("Unicode
/// Security Mechanisms") of the names without blanks: as they are (capital I and small l), or
/// without differences of case. Names that differ in case alone look alike, too.
[[nodiscard]] bool lookAlike(std::string_view utf8, std::string_view otherUtf8);

} // namespace carina
