#pragma once

#include "engine/tracking/tracker.h"

#include <array>
#include <optional>
#include <string_view>

namespace carina
{

/// The words of the roles in files, in the order of ToolRole.
inline constexpr std::array kToolRoleWords{"head",  "jaw",  "tube",         "stylus", "manikin",
                                           "chest", "hand", "laryngoscope", "other"};
static_assert(kToolRoleWords.size() == std::size_t(ToolRole::Other) + 1);

[[nodiscard]] constexpr const char* toolRoleWord(ToolRole role)
{
    return kToolRoleWords[static_cast<std::size_t>(role)];
}

/// The role of a word in a file; nothing for another word.
[[nodiscard]] std::optional<ToolRole> toolRoleOfWord(std::string_view word);

/// The role that a tool's name tells: "Tube" and "ETT" are a tube, "HMD" and "Head" a headset, and
/// so on, in small letters or capitals; Other for any other name.
[[nodiscard]] ToolRole toolRoleOfName(std::string_view name);

} // namespace carina
