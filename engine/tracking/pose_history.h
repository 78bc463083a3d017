#pragma once

#include "engine/tracking/one_euro_filter.h"
#include "engine/tracking/pose_sample.h"

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace carina
{

/// What is made of the samples of a tracker before they are shown.
struct PoseTreatment {
    bool predicts = true; ///< poses beyond the newest sample are predicted; otherwise it is held
    bool smooths = false; ///< samples pass a OneEuroFilter

    friend bool operator==(const PoseTreatment&, const PoseTreatment&) = default;
};

/// How a device D stands to the frame F in which its poses are wanted, and its stamps to the clock.
struct DevicePlace {
    RigidTransform X_FD{};
    Duration late{}; ///< it stamps the same moment so much later
};

/// The recent poses of one object O in one frame F. All functions are thread-safe: a device or
/// network thread pushes, any thread reads; each call locks one internal mutex.
///
/// For a time t, at() returns the sample of that time (Exact), the pose between two samples
/// (Interpolated: linear and slerp), or the newest pose moved on by its velocity and acceleration
/// (Predicted: movedOn), with the deviation to expect where the motion has one.
///
/// The velocity is that of the sample where its source gave one; otherwise the difference quotient
/// to the previous tracked sample, if that is at most longestGap older; otherwise there is none and
/// the pose stays constant.
///
/// A person may have the poses smoothed or not predicted (PoseTreatment).
class PoseHistory
{
public:
    struct Limits {
        std::size_t capacity = 512;                           ///< number of samples stored
        Duration longestGap = std::chrono::milliseconds{150}; ///< longest gap that is interpolated
        Duration horizon = std::chrono::milliseconds{150};    ///< longest prediction
    };

    PoseHistory() = default;
    explicit PoseHistory(const Limits& limits) : m_limits{limits} {}

    /// Adds a sample, in order of time; it replaces a sample of the same time. When the history is
    /// full, the oldest sample is removed.
    /// @returns false where the sample was rejected: not finite, a time more than 100 years from
    ///          the clock's zero, or older than all samples of a full history.
    bool push(const PoseSample& measured);

    /// The pose at time t; nothing for a time before the oldest sample stored.
    ///
    /// Validity is Lost when a sample next to t is lost, when the samples around t are more than
    /// longestGap apart, or when t is more than horizon beyond the newest. The pose is then that of
    /// the sample before t, or the newest predicted up to the horizon, and has no motion. Between
    /// two samples the motion is their difference quotient, and validity and error are those of the
    /// worse sample. An Exact pose is the sample itself, with the velocity described above.
    [[nodiscard]] std::optional<PoseSample> at(SessionTime t) const;

    /// What is pushed from now on are poses X_DO of a device D, with its stamps; stored is X_FO.
    void placeDevice(const DevicePlace& place);
    /// X_FD of the device; nothing where it was not placed, and measures in F itself.
    [[nodiscard]] std::optional<RigidTransform> deviceFrame() const;

    /// How poses are treated from now on.
    void treat(const PoseTreatment& treatment);

    /// The newest sample, as it was added; nothing while there is none.
    [[nodiscard]] std::optional<PoseSample> newest() const;

    /// All samples stored, oldest first.
    [[nodiscard]] std::vector<PoseSample> samples() const;

    void clear();

private:
    [[nodiscard]] std::optional<Motion> motionOf(std::size_t index) const;
    [[nodiscard]] PoseSample carriedOn(std::size_t index, SessionTime t) const;

    Limits m_limits;
    std::optional<DevicePlace> m_place; ///< nothing: the device measures in F
    PoseTreatment m_treatment;
    OneEuroFilter m_smoothing;
    mutable std::mutex m_mutex;
    std::deque<PoseSample> m_samples; // ascending in time
};

} // namespace carina
