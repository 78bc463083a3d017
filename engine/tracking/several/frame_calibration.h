#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/tracking/pose_history.h"

#include <span>
#include <vector>

namespace carina
{

/// One body at one moment, seen by two devices with the frames T and D: the first sees the probe O
/// on it, the second the probe P. Both may be the same probe.
struct BodySeenTwice {
    RigidTransform X_TO;
    RigidTransform X_DP;
};

/// How a second device stands to the first.
struct FrameCalibration {
    DevicePlace place{};   ///< X_TD, and how much later the second stamps
    RigidTransform X_OP{}; ///< of the probes on the body
    Length rms;            ///< of | X_TO p_OP - X_TD p_DP |, the places of P
    Angle turn;            ///< likewise of the rotations, RMS
    std::size_t pairs = 0; ///< that were used
    std::size_t outliers = 0;
};

/// The moments of the first device at which both saw the body, with the pose of the second at the
/// same moment between two of its samples.
/// @param late how much later the second stamps the same moment
[[nodiscard]] std::vector<BodySeenTwice>
seenTwice(std::span<const PoseSample> first, std::span<const PoseSample> second, Duration late);

/// The X_TD and X_OP for which, over all pairs, X_TO X_OP and X_TD X_DP agree best:
///
///     sum_i | p_TO + R_TO p_OP - R_TD p_DP - p_TD |^2 / s_p^2 + angle(R_TO R_OP, R_TD R_DP)^2 /
///     s_r^2
///
/// with s_p and s_r from the residuals. It begins with the closed form of Shah (2013, "Solving the
/// Robot-World/Hand-Eye Calibration Problem Using the Kronecker Product") and goes on by
/// Gauss-Newton. Pairs that are six times as far off as the median are left out.
///
/// @returns TooFewPoses below kFewestSeenTwice; NotFinite; NotEnoughMotion where the body was
/// turned
///          about one axis only, or too little, so that places on it cannot be told from frames.
[[nodiscard]] Result<FrameCalibration> calibrateFrames(std::span<const BodySeenTwice> pairs);

/// The same from what both saw of a body that was turned to and fro, with the shift of their stamps
/// (timeShift).
/// @returns also the errors of timeShift.
[[nodiscard]] Result<FrameCalibration> calibrateFrames(std::span<const PoseSample> first,
                                                       std::span<const PoseSample> second);

/// Whether a calibration may be used: above kWorstFit and kWorstTurn something other than the
/// trackers' errors is in the residuals, such as tools on two bodies.
[[nodiscard]] bool isAcceptable(const FrameCalibration& found);

inline constexpr Length kWorstFit = millimetres(5.0);
inline constexpr Angle kWorstTurn = degrees(2.0);
inline constexpr std::size_t kFewestSeenTwice = 50;
/// How much the body is to be turned about at least two axes, RMS about the mean.
inline constexpr Angle kLeastTurnTwice = degrees(8.0);

} // namespace carina
