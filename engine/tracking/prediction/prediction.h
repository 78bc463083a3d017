#pragma once

#include "engine/tracking/pose_sample.h"

#include <cstddef>

namespace carina
{

/// How long an acceleration is taken to last when a pose is predicted.
inline constexpr Duration kAccelerates = std::chrono::milliseconds{100};

/// Moves a pose on by its motion for some seconds:
///
///     p(dt) = p + v_FO dt + a_FO (dt^2 - r^2) / 2        r = max(0, dt - kAccelerates)
///
/// and the rotation alike, whose vector (in axes of F) is applied to q_FO. The motion is then that
/// of the later time.
[[nodiscard]] RigidTransform movedOn(const RigidTransform& X_FO, Motion& motion, double dt);

/// How far predicted poses were from those that were measured at their time: root mean squares.
struct PredictionError {
    double position = 0.0; ///< metres
    double rotation = 0.0; ///< radians
    std::size_t poses = 0; ///< that were compared

    /// Adds a pose to the sums of squares, which root() turns into root mean squares.
    void add(const RigidTransform& predicted, const RigidTransform& truth);
    [[nodiscard]] PredictionError root() const;
};

/// What prediction by some time achieves: the error of the predicted poses beside that of holding
/// the newest sample.
struct PredictionEffect {
    PredictionError held;
    PredictionError predicted;
};

} // namespace carina
