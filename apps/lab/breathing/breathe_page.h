#pragma once

#include "apps/lab/command/command.h"

namespace carina::lab
{

// Options of `breathe`, and the keys of what its two ways print.

namespace breathe_option
{
inline constexpr Option kRate{
    "rate-per-min", "R",
    "breaths per minute, 4 to 60; as many as the patient breathes at rest unless given"};
inline constexpr Option kTidalVolume{
    "tidal-volume-ml", "V", "volume of a breath, 10 to 2000; that of a quiet breath unless given"};
inline constexpr Option kSeconds{"seconds", "S", "how long to breathe, 0.1 to 3600"};
inline constexpr Option kLevel{
    "level", "N", "the one level of detail to draw, 0 being the finest; every level unless given"};
inline constexpr Option kEveryCondition{"every-condition", "", "draws every condition"};
} // namespace breathe_option

namespace breathe_key
{
inline constexpr Key kSchema{"schema", "carina.breathe/1"};
inline constexpr Key kAnatomy{"anatomy", "name of the anatomy that was drawn"};
inline constexpr Key kPosition{"position", "position of the patient"};
inline constexpr Key kRate{"rate_per_min", "as asked for, or of quiet breathing"};
inline constexpr Key kTidalVolume{"tidal_volume_ml", "as asked for, or of a quiet breath"};
inline constexpr Key kSeconds{"seconds", "as asked for"};
inline constexpr Key kFramesPerSecond{"frames_per_second", "drawn for each of these seconds"};
inline constexpr Key kLargestError{
    "max_volume_error_ml", "largest error of either lung and of both together, in any level"};
inline constexpr Key kFunctionalResidualCapacity{
    "frc_ml", "volume of both lungs at rest in the finest level"};
inline constexpr Key kLevels{"levels",
                             "one object per level of detail, about both lungs together:"};
inline constexpr Key kLevel{"level", "its number", 1};
inline constexpr Key kFrames{"frames", "that were drawn", 1};
inline constexpr Key kDrawnTidalVolume{"tidal_volume_drawn_ml",
                                       "largest minus smallest volume drawn in all the seconds; "
                                       "larger than a tidal volume until breathing is steady",
                                       1};
inline constexpr Key kErrorOfLevel{"max_volume_error_ml", "largest error of both lungs together",
                                   1};
inline constexpr Key kLungs{"lungs", "\"right\" and \"left\", each an object:"};
inline constexpr Key kErrorOfLung{"max_volume_error_ml", "largest error in any level", 1};
inline constexpr Key kRestVolume{"rest_volume_ml", "at rest, in the finest level drawn", 1};
inline constexpr Key kLevelsOfLung{"levels", "one object per level of detail:", 1};
inline constexpr Key kLevelOfLung{"level", "its number", 2};
inline constexpr Key kVertices{"vertices", "of the lung's surface", 2};
inline constexpr Key kTriangles{"triangles", "of the lung's surface", 2};
inline constexpr Key kRestVolumeInLevel{"rest_volume_ml", "at rest", 2};
inline constexpr Key kErrorOfLungInLevel{"max_volume_error_ml", "largest error", 2};
} // namespace breathe_key

namespace breathe_sweep_key
{
inline constexpr Key kSchema{"schema", "carina.breathe.conditions/1"};
inline constexpr Key kAnatomy{"anatomy", "name of the anatomy that was drawn"};
inline constexpr Key kPosition{"position", "position of the patient"};
inline constexpr Key kTrials{"trials",
                             "number of combinations of condition and breathing that were drawn"};
inline constexpr Key kFrames{"frames", "that were drawn, in all levels"};
inline constexpr Key kLargestError{
    "max_volume_error_ml", "largest error of either lung and of both together, of all frames"};
inline constexpr Key kLevels{"levels", "one object per level of detail:"};
inline constexpr Key kLevel{"level", "its number", 1};
inline constexpr Key kErrorOfLevel{"max_volume_error_ml", "largest error in it", 1};
inline constexpr Key kConditions{"conditions", "one object per condition and side:"};
inline constexpr Key kCondition{"condition", "its name", 1};
inline constexpr Key kSide{"side", "both, right or left", 1};
inline constexpr Key kErrorOfCondition{"max_volume_error_ml", "largest error with it", 1};
} // namespace breathe_sweep_key

} // namespace carina::lab
