#pragma once

#include "models/station/frame_log.h"

#include <span>

namespace carina::lab
{

/// Which of a frame's poses: the tube's, or the virtual patient's.
using LoggedPose = std::optional<RigidTransform> LoggedFrame::*;

/// How far two processes of one machine showed an object apart at the same instant.
struct DriftSummary {
    int instants = 0; ///< at which both were drawing it; 0 leaves what follows at 0
    double mean_deg = 0.0, p95_deg = 0.0, largest_deg = 0.0;
    double mean_mm = 0.0, p95_mm = 0.0, largest_mm = 0.0;
    int clockInstants = 0; ///< at which the owner was drawing, seen or not; 0 likewise
    double clockMean_ms = 0.0, clockLargest_ms = 0.0; ///< difference of the session clocks
};

/// Compares what was drawn, on CLOCK_MONOTONIC, which all processes of a machine share, and so
/// without any estimate of the system under test.
///
/// Each frame of `viewer` is held against the pose of `owner` at the session time the viewer drew,
/// interpolated between the owner's frames (state drift). The clocks are held against each other at
/// the local time of each viewer's frame.
[[nodiscard]] DriftSummary driftBetween(std::span<const LoggedFrame> owner,
                                        std::span<const LoggedFrame> viewer,
                                        LoggedPose pose = &LoggedFrame::X_AE);

} // namespace carina::lab
