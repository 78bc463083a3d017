#pragma once

#include "engine/lungs/lung_condition.h"

#include <array>
#include <optional>
#include <string_view>

namespace carina::lab
{

/// A condition as it is named in command lines and results, and the sides it is shown on.
struct NamedCondition {
    std::string_view name;
    ConditionKind kind;
    bool bothSides = true; ///< it can ail both lungs at once
    bool oneSide = false;  ///< one lung alone is worth looking at
};

inline constexpr std::array kNamedConditions{
    NamedCondition{"normal", ConditionKind::Normal},
    NamedCondition{"ards", ConditionKind::Ards},
    NamedCondition{"copd", ConditionKind::Copd},
    NamedCondition{"asthma", ConditionKind::Asthma},
    NamedCondition{"simple_pneumothorax", ConditionKind::SimplePneumothorax, false, true},
    NamedCondition{"tension_pneumothorax", ConditionKind::TensionPneumothorax, false, true},
    NamedCondition{"atelectasis", ConditionKind::Atelectasis, false, true},
    NamedCondition{"mainstem_intubation", ConditionKind::MainstemIntubation, false, true},
    NamedCondition{"obstruction", ConditionKind::Obstruction, true, true},
    NamedCondition{"stiff_chest", ConditionKind::StiffChest},
};

/// "both", "right" or "left".
[[nodiscard]] std::string_view sideName(ConditionSide side);

[[nodiscard]] std::string_view conditionName(ConditionKind kind);

[[nodiscard]] std::optional<ConditionKind> conditionNamed(std::string_view name);
[[nodiscard]] std::optional<ConditionSide> sideNamed(std::string_view name);

} // namespace carina::lab
