#pragma once

#include "engine/core/result.h"

#include <string>
#include <string_view>

namespace carina
{

/// Characters of a participant's name.
inline constexpr int kLongestName = 64;

/// Marks that one letter of a name may have, one after another: Vietnamese has two, Hebrew, Thai
/// and Tibetan three.
inline constexpr int kMostMarks = 3;

/// Whether a participant can be told by this name: a visible character at both ends, and no
/// character that cannot be seen, that stands for something else or that changes the order of
/// others: Unicode categories Cc, Cf, Cs, Co, Cn, Zl, Zp; the empty Braille pattern and the like,
/// which are drawn as blanks; U+FFFC and U+FFFD. Marks stand behind a letter, at most kMostMarks.
/// @returns NameUnclear otherwise, and for more than kLongestName characters.
[[nodiscard]] Result<void> checkName(std::string_view utf8);

/// How a name looks: its skeletons of Unicode Technical Standard 39 ("Unicode Security
/// Mechanisms"), without blanks, in UTF-8. Two names look alike that have one of them in common.
struct NameLook {
    std::string ofFolded; ///< skeleton of the name in one case
    std::string folded;   ///< its skeleton in one case
};
[[nodiscard]] NameLook lookOf(std::string_view utf8);

/// Whether two names look alike, by their skeletons: as they are (capital I and small l), or
/// without differences of case. Names that differ in case alone look alike, too.
[[nodiscard]] bool lookAlike(std::string_view utf8, std::string_view otherUtf8);

} // namespace carina
