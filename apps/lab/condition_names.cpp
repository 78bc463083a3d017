#include "apps/lab/condition_names.h"

#include <algorithm>

namespace carina::lab
{

std::string_view sideName(ConditionSide side)
{
    return std::ranges::find(kNamedSides, side, &NamedSide::side)->name;
}

std::string_view conditionName(ConditionKind kind)
{
    return std::ranges::find(kNamedConditions, kind, &NamedCondition::kind)->name;
}

} // namespace carina::lab
