#pragma once

#include "engine/core/result.h"
#include "engine/session/body/body_facts.h"

namespace carina
{

/// The ranges of settings; controls offer them, the host enforces them.
inline constexpr double kRoomOxygen = 0.21; ///< share of oxygen in room air
inline constexpr double kPureOxygen = 1.0;
/// Farthest that a monitor measures along a tube, and between the two shapes of one; of ours.
inline constexpr Length kLongestTubeWay = metres(1.0);

/// The most of a drug in one dose: beyond what the heaviest patient (kHeaviestPatient) is given at
/// once, so that it only refuses a slip of the keyboard. Of ours.
[[nodiscard]] double mostMilligrams(DrugKind kind);

/// Whether the values of a fact about gas, drugs or tube are possible for any patient. A state that
/// passes may be given to a BodyFold.
/// @returns OutOfRange or NotFinite, with the value and its range.
[[nodiscard]] Result<void> checkPatientBody(const fact::GasSupplySet& fact);
[[nodiscard]] Result<void> checkPatientBody(const fact::DrugGiven& fact);
[[nodiscard]] Result<void> checkPatientBody(const fact::TubeObstructed& fact);
[[nodiscard]] Result<void> checkPatientBody(const fact::IntubationNoted& fact);
[[nodiscard]] Result<void> checkPatientBody(const fact::CapnographCheckpoint& fact);
[[nodiscard]] Result<void> checkPatientBody(const fact::BodyCheckpoint& fact);

} // namespace carina
