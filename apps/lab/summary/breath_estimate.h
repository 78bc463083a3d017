#pragma once

#include "engine/core/session_time.h"
#include "engine/core/units.h"

#include <optional>
#include <span>

namespace carina::lab
{

/// A lung volume that was measured at a time.
struct VolumeSample {
    LocalTime time{};
    double volume_ml = 0.0;
};

/// Breathing as seen from outside: from volumes alone, knowing nothing of what was asked for.
struct BreathEstimate {
    Frequency rate;     ///< from the first to the last upward crossing of the middle volume
    Volume tidalVolume; ///< largest less smallest volume over these breaths
    int breaths = 0;    ///< whole breaths between those crossings
};

/// Estimates rate and tidal volume from samples in order of time.
/// @returns nothing where fewer than one whole breath was seen, or nothing moved.
[[nodiscard]] std::optional<BreathEstimate>
estimateBreathing(std::span<const VolumeSample> samples);

} // namespace carina::lab
