#include "engine/tracking/tool_role.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr char inSmallLetter(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

} // namespace

std::optional<ToolRole> toolRoleOfWord(std::string_view word)
{
    const auto* known = std::ranges::find(kToolRoleWords, word);
    if (known == kToolRoleWords.end())
        return std::nullopt;
    return static_cast<ToolRole>(known - kToolRoleWords.begin());
}

ToolRole toolRoleOfName(std::string_view name)
{
    constexpr std::array<std::pair<std::string_view, ToolRole>, 15> kRoles{
        {{"head", ToolRole::Head},
         {"hmd", ToolRole::Head},
         {"headset", ToolRole::Head},
         {"jaw", ToolRole::Jaw},
         {"chin", ToolRole::Jaw},
         {"tube", ToolRole::Tube},
         {"ett", ToolRole::Tube},
         {"stylus", ToolRole::Stylus},
         {"pointer", ToolRole::Stylus},
         {"manikin", ToolRole::Manikin},
         {"body", ToolRole::Manikin},
         {"chest", ToolRole::Chest},
         {"hand", ToolRole::Hand},
         {"laryngoscope", ToolRole::Laryngoscope},
         {"blade", ToolRole::Laryngoscope}}};
    const auto* known = std::ranges::find_if(kRoles, [&](const auto& entry) {
        return std::ranges::equal(entry.first, name, {}, {}, inSmallLetter);
    });
    return known == kRoles.end() ? ToolRole::Other : known->second;
}

} // namespace carina
