#include "apps/lab/condition_names.h"

#include <algorithm>

namespace carina::lab
{

std::string_view sideName(ConditionSide side)
{
    switch (side) {
    case ConditionSide::Right:
        return "right";
    case ConditionSide::Left:
        return "left";
    case ConditionSide::Both:
        break;
    }
    return "both";
}

std::string_view conditionName(ConditionKind kind)
{
    return std::ranges::find(kNamedConditions, kind, &NamedCondition::kind)->name;
}

std::optional<ConditionKind> conditionNamed(std::string_view name)
{
    const auto* named = std::ranges::find(kNamedConditions, name, &NamedCondition::name);
    return named != kNamedConditions.end() ? std::optional{named->kind} : std::nullopt;
}

std::optional<ConditionSide> sideNamed(std::string_view name)
{
    for (const ConditionSide side :
         {ConditionSide::Both, ConditionSide::Right, ConditionSide::Left})
        if (sideName(side) == name)
            return side;
    return std::nullopt;
}

} // namespace carina::lab
