#pragma once

#include "engine/lungs/mechanics/respiratory_system.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carina
{

/// Diseases and complications that can be set; afflicted() describes each.
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

/// In the order in which controls list them, which is that of the enumerators.
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

/// Which lung a condition affects.
enum class ConditionSide : std::uint8_t { Both, Right, Left };

/// One disease of a patient's lungs.
struct LungCondition {
    ConditionKind kind = ConditionKind::Normal;
    double severity = 0.0; ///< 0 healthy to 1
    ConditionSide side = ConditionSide::Both;

    friend bool operator==(const LungCondition&, const LungCondition&) = default;
};

/// The diseases of a patient's lungs, in any order; none in health.
using LungConditions = std::vector<LungCondition>;

/// As many as may be set at once.
inline constexpr std::size_t kMostConditions = 6;

/// Whether two conditions are the same disease of a lung that both affect.
[[nodiscard]] bool overlap(const LungCondition& a, const LungCondition& b);

/// Whether a patient can have these at once: at most kMostConditions, none of them Normal, no two
/// that overlap, and a tube in one main bronchus at most.
[[nodiscard]] bool canCoexist(const LungConditions& conditions);

/// Cross section of the trachea that an Obstruction of both lungs narrows, m^2.
inline constexpr double kTracheaSection = 2.0e-4;

/// A healthy system, tube included, with conditions applied. Parameters as functions of the
/// severity s are piecewise linear through the values of Pulse at 0.3, 0.6 and 0.9, where Pulse has
/// them (docs/mechanics.md names each source):
///
/// - Ards: the open share of the lung falls to 0.7, 0.5, 0.4, and with it compliance, resting
///   volume and capacity; the limbs of the curve 1 + s times as far apart; alveolar dead space of
///   0, 0.03, 0.15 L in an adult. Muscles: strength 0.76, 0.52, 0.28 times, the effort of exhausted
///   ones as it leaves that share of the tidal volume; I:E 1.4, 2.2, 3 times.
/// - Copd: bronchial resistance 1.9, 3.8, 5.3 times; resting volume 1.77, capacity 1.40 and
///   the floor of the curve 2.42 times at 0.9; compliance 1, 1.1, 1.4 times; the recoil of the wall
///   1 - 0.5 s times; alveolar dead space of 0.3, 0.6, 0.9 L in an adult. Bronchi are compressed
///   during expiration: their resistance to gas that leaves is 3.9, 6.8, 9.7 times that to gas that
///   enters, and below a closing volume of 1.7 s times the resting volume they narrow besides.
///   Muscles: strength 0.87, 0.76, 0.64 times, the effort of exhausted ones as it leaves that share
///   of the tidal volume, more by what stays behind of a quiet breath; I:E 0.7, 0.44, 0.24 times.
/// - Asthma: resistance of the whole natural airway 1 + 14 s times, the increase in the bronchi;
///   their resistance to gas that leaves 1 + 1.3 s times that to gas that enters; a closing volume
///   of 1.6 s times the resting volume.
/// - SimplePneumothorax: gas in the pleural space, at a pressure s of the way from the pleural to
///   that of the room; the lung rests at 1 - 0.75 s of its volume, and span and bronchi narrow with
///   it.
/// - TensionPneumothorax: a one-way tear lets gas from the airway into the pleural space as long as
///   the condition lasts; none leaves before it ends. It resists by 50 / s^2 cmH2O s/L in an adult
///   (Pulse), and in others by as much more as the wall is less compliant.
/// - Atelectasis: 0.9 s of the lung is closed, of what gas in the pleural space has left open;
///   compliance, resting volume, capacity and bronchial conductance fall with it.
/// - MainstemIntubation: the tube is in the main bronchus of `side`. A share s of the section of
///   the other main bronchus is closed, and the blood absorbs gas behind it down to 0.45 of the
///   resting volume, with a rate constant of s in 3 minutes.
/// - Obstruction: a share s of the section is closed: of the trachea or tube for Both, else of a
///   main bronchus. The conductance of a bronchus goes with the square of its open section; a
///   trachea of which the last hundredth closes blocks both lungs.
/// - StiffChest: the compliance of the wall is divided by 1 + 4 s.
///
/// A condition of one lung changes strength, effort and I:E by half as much.
///
/// Of several conditions COPD makes the lung larger first; then each changes what those before it
/// in the order of the enumerators have left, right before left, so that the result does not depend
/// on the order in which they were set.
///
/// @pre canCoexist(conditions); severities within 0..1; MainstemIntubation has one side.
[[nodiscard]] RespiratorySystem afflicted(const RespiratorySystem& healthy,
                                          LungConditions conditions);

} // namespace carina
