#pragma once

#include "engine/lungs/mechanics/respiratory_system.h"

#include <array>
#include <cstdint>

namespace carina
{

enum class ConditionKind : std::uint8_t {
    Normal,
    Ards,
    Copd,
    Asthma,
    SimplePneumothorax,
    TensionPneumothorax,
    Atelectasis,
    MainstemIntubation,
    Obstruction,
    StiffChest,
};

/// In the order in which people are offered them, which is that of the enumerators.
inline constexpr std::array kConditionKinds{
    ConditionKind::Normal,
    ConditionKind::Ards,
    ConditionKind::Copd,
    ConditionKind::Asthma,
    ConditionKind::SimplePneumothorax,
    ConditionKind::TensionPneumothorax,
    ConditionKind::Atelectasis,
    ConditionKind::MainstemIntubation,
    ConditionKind::Obstruction,
    ConditionKind::StiffChest,
};

enum class ConditionSide : std::uint8_t { Both, Right, Left };

/// What ails the lungs of a patient.
struct LungCondition {
    ConditionKind kind = ConditionKind::Normal;
    double severity = 0.0; ///< 0 healthy to 1
    ConditionSide side = ConditionSide::Both;

    friend bool operator==(const LungCondition&, const LungCondition&) = default;
};

/// What a condition makes of a healthy system, tube included. Figures by severity s lie on straight
/// lines between those of Pulse at 0.3, 0.6 and 0.9 where it has them (docs/mechanics.md names each
/// source):
///
/// - Ards: the open share of the lung falls to 0.7, 0.5, 0.4, and with it compliance, volume and
///   capacity; alveolar dead space, tired muscles.
/// - Copd: bronchi narrow to 1.9, 3.8, 5.3 times the resistance; resting volume 1.77, capacity 1.40
///   and residual volume 2.42 times at 0.9; compliance up to 1.4; alveolar dead space. Bronchi are
///   compressed while gas leaves: 3.9, 6.8, 9.7 times the resistance that they have to gas that
///   comes in.
/// - Asthma: resistance of the whole natural airway 1 + 14 s times, all of it in the bronchi.
/// - SimplePneumothorax: gas in the pleura, of a pressure s of the way to that of the room; the
///   lung rests at 1 - 0.75 s of its volume.
/// - TensionPneumothorax: a tear of that size lets gas into the pleura and not back, as long as the
///   condition lasts.
/// - Atelectasis: 0.9 s of the lung is shut off.
/// - MainstemIntubation: the tube is in the bronchus of `side`; a share s of the section of the
///   other is closed, and the blood takes up its gas down to 0.45 of the resting volume.
/// - Obstruction: a share s of the section is closed; of the trachea or tube for both sides, else
///   of a main bronchus. A bronchus conducts as the square of its section; a trachea lets nothing
///   through as the last hundredth of it closes.
/// - StiffChest: the wall's compliance is divided by 1 + 4 s.
///
/// @pre severity within 0..1; MainstemIntubation has one side.
[[nodiscard]] RespiratorySystem afflicted(const RespiratorySystem& healthy,
                                          const LungCondition& condition);

} // namespace carina
