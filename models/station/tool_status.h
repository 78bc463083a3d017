#pragma once

#include "engine/tracking/tracker.h"
#include "models/tracker/known_volume.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace carina
{

/// What a tool is for, as shown: "Stylus"; empty for one of another use.
[[nodiscard]] QString toolRoleName(ToolRole role);

/// For how long ToolStatus::predicted_mm is predicted: about from the exposure to the light.
inline constexpr Duration kPredictedAhead = std::chrono::milliseconds{40};

/// The visibility of one tool of a tracker.
struct ToolStatus {
    ToolRole role = ToolRole::Other;
    QString name{};         ///< as shown: "Stylus"
    bool isVisible = false; ///< tracked, with recent samples
    QString text{};         ///< its state, and of a visible one sample rate and quality
    /// "visible", "partly out of view", "out of view", "never seen", or where the device tells it
    /// why: "other infrared light disturbs", "device silent"
    QString state{};
    double rate_Hz = 0.0;          ///< samples a second, the lost ones included; 0 while none come
    std::optional<double> age_s{}; ///< of the newest sample in which it was seen
    /// How well its markers fit, RMS; while it is visible and its tracker tells it
    std::optional<double> error_mm{};
    /// The error of its pose at its origin (RMS), predicted from its markers; while it is visible,
    /// and of a tool that is partly hidden where its tracker tells which of them it sees
    std::optional<double> expected_mm{};
    std::optional<double> expected_deg{}; ///< the same, of its rotation
    /// How far the pose predicted by kPredictedAhead was off in the last seconds (RMS), and the
    /// pose held for as long; while it is visible and its motion is known.
    std::optional<double> predicted_mm{};
    std::optional<double> held_mm{};
    std::optional<double> deviation_mm{}; ///< that the motion lets expect of such a pose (RMS)
    std::optional<Vec3> p_T{};            ///< of its origin, where the first device saw it last
};

/// A tracker as its person sees it.
struct TrackerSight {
    QString trouble{}; ///< what keeps it from tracking, as a sentence; empty where nothing does
    std::vector<ToolStatus> tools{};
    KnownVolume usualVolume = KnownVolume::None; ///< of such a tracker
    bool isPlaced = true; ///< its site is registered, so that tools are tracked
};

/// How poses are treated, and what is called with another treatment that a person chooses; nothing
/// where there is nothing to choose.
struct TreatmentChoice {
    PoseTreatment now{};
    std::function<void(const PoseTreatment&)> choose{};
};

/// Has the poses of all tools of a tracker treated so from now on.
void treatPoses(const Tracker& tracker, const PoseTreatment& treatment);

/// The status of a tracker's tools at a time on its clock.
[[nodiscard]] std::vector<ToolStatus> toolStatus(const Tracker& tracker, SessionTime now);

} // namespace carina
