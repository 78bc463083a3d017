#pragma once

#include "models/station/frame_log.h"

#include <span>

namespace carina::lab
{

/// How far the volumes of the lungs that two processes drew are apart.
struct VolumeDifference {
    int instants = 0; ///< at which both were drawing; 0 leaves the rest at 0
    double mean_ml = 0.0, p95_ml = 0.0, largest_ml = 0.0;
};

/// What is the same when two frames are compared.
enum class Sameness {
    SessionTime, ///< each site's own idea of it: do both draw the same breath?
    Instant, ///< CLOCK_MONOTONIC, which all processes of a machine share: do people see the same?
};

/// Compares the volumes of both lungs together, as measured from the vertices drawn. Each frame of
/// `viewer` is held against `owner` at the same time, on the cubic through the two frames before
/// and the two after; frames further apart than 200 ms are left out. Where an inspiration ends the
/// volume has a corner, and a cubic across it is off by some ml: the largest difference is
/// therefore an upper bound.
[[nodiscard]] VolumeDifference volumesBetween(std::span<const LoggedFrame> owner,
                                              std::span<const LoggedFrame> viewer, Sameness same);

} // namespace carina::lab
