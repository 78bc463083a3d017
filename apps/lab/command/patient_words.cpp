#include "apps/lab/command/patient_words.h"

#include <algorithm>

namespace carina::lab
{

std::string_view conditionName(ConditionKind kind)
{
    return std::ranges::find(kNamedConditions, kind, &NamedCondition::kind)->name;
}

std::string_view sideName(ConditionSide side)
{
    return std::ranges::find(kNamedSides, side, &NamedSide::side)->name;
}

std::string_view ventilatorName(VentilationMode mode)
{
    return std::ranges::find(kNamedVentilators, mode, &NamedVentilator::mode)->name;
}

std::string_view positionName(BodyPosition position)
{
    switch (position) {
    case BodyPosition::Supine:
        break;
    case BodyPosition::Sitting:
        return "sitting";
    case BodyPosition::Prone:
        return "prone";
    case BodyPosition::RightLateral:
        return "right_lateral";
    case BodyPosition::LeftLateral:
        return "left_lateral";
    }
    return "supine";
}

} // namespace carina::lab
