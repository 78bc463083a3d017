#pragma once

#include "engine/lungs/mechanics/body_position.h"
#include "engine/lungs/mechanics/lung_condition.h"
#include "engine/lungs/mechanics/ventilation.h"

#include <array>
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

/// A side as it is named there.
struct NamedSide {
    std::string_view name;
    ConditionSide side;
};

inline constexpr std::array kNamedSides{NamedSide{"both", ConditionSide::Both},
                                        NamedSide{"right", ConditionSide::Right},
                                        NamedSide{"left", ConditionSide::Left}};

/// What makes the breaths, as it is named there; "none" where the patient does.
struct NamedVentilator {
    std::string_view name;
    VentilationMode mode;
};

inline constexpr std::array kNamedVentilators{
    NamedVentilator{"none", VentilationMode::Spontaneous},
    NamedVentilator{"volume", VentilationMode::VolumeControl},
    NamedVentilator{"pressure", VentilationMode::PressureControl}};

[[nodiscard]] std::string_view conditionName(ConditionKind kind);
[[nodiscard]] std::string_view sideName(ConditionSide side);
[[nodiscard]] std::string_view ventilatorName(VentilationMode mode);
/// "supine", "sitting", "prone", "right_lateral" or "left_lateral".
[[nodiscard]] std::string_view positionName(BodyPosition position);

} // namespace carina::lab
