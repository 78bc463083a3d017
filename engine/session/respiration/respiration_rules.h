#pragma once

#include "engine/core/result.h"
#include "engine/session/respiration/respiration_facts.h"

namespace carina
{

/// The ranges of settings; controls offer them, the host enforces them.
inline constexpr Length kSmallestPatient = millimetres(400.0);
inline constexpr Length kTallestPatient = millimetres(2300.0);
inline constexpr double kLightestPatient = 1.0; ///< kg
inline constexpr double kHeaviestPatient = 300.0;
inline constexpr double kYoungestPatient = 0.0; ///< years
inline constexpr double kOldestPatient = 120.0;
inline constexpr Pressure kHighestPeep = cmH2O(25.0);
inline constexpr Pressure kHighestDrivingPressure = cmH2O(60.0);
inline constexpr Pressure kLowestPressureLimit = cmH2O(5.0);
inline constexpr Pressure kHighestPressureLimit = cmH2O(100.0);
inline constexpr double kLongestPause = 0.8; ///< of inspiration
inline constexpr VolumeFlow kLargestTrigger = litresPerSecond(0.5);
inline constexpr double kStrongestEffort = 2.0; ///< of a quiet breath's
inline constexpr Length kNarrowestTube = millimetres(2.0);
inline constexpr Length kWidestTube = millimetres(12.0);

/// Whether the values of a fact about respiration are possible for any patient. Values that pass
/// may be given to a RespiratoryFold.
/// @returns OutOfRange or NotFinite, with the value and its range.
[[nodiscard]] Result<void> checkRespiration(const fact::PatientBuildSet& fact);
[[nodiscard]] Result<void> checkRespiration(const fact::LungConditionsSet& fact);
[[nodiscard]] Result<void> checkRespiration(const fact::VentilatorSet& fact);
[[nodiscard]] Result<void> checkRespiration(const fact::TubePlaced& fact);
[[nodiscard]] Result<void> checkRespiration(const fact::BodyPositionSet& fact);
[[nodiscard]] Result<void> checkRespiration(const fact::BreathingStopped& fact);
[[nodiscard]] Result<void> checkRespiration(const fact::BagSqueezed& fact);
[[nodiscard]] Result<void> checkRespiration(const fact::ManikinBreathed& fact);
[[nodiscard]] Result<void> checkRespiration(const fact::RespirationCheckpoint& fact);

/// Whether there is a tube of this inner diameter; 0: there is none, or its size is not known.
/// @returns OutOfRange or NotFinite, with the diameter and its range.
[[nodiscard]] Result<void> checkTubeSize(Length innerDiameter);

/// Whether the tidal volume is possible for a patient of this build (largestTidalVolume).
/// @returns OutOfRange or NotFinite, with the volume and the patient's range.
[[nodiscard]] Result<void> checkTidalVolume(const PatientBuild& build, Volume tidalVolume);

} // namespace carina
