#pragma once

#include "engine/tracking/pose_sample.h"

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace carina
{

/// The recent poses of one object O in one frame F. A device or network thread pushes, any thread
/// asks; one mutex inside keeps each call whole.
///
/// Asked for a time it answers with the sample of that time (Exact), the pose between two samples
/// (Interpolated: straight line and great circle), or the newest pose carried on by its velocity
/// (Predicted):
///
///     p(t0 + dt) = p(t0) + v_FO dt          q(t0 + dt) = exp(w_FO dt) q(t0)
///
/// The velocity is the sample's own where the source gave one, else the difference to the tracked
/// sample before it if that is no more than longestGap older, else none: the pose is held.
class PoseHistory
{
public:
    struct Limits {
        std::size_t capacity = 512;                           ///< samples kept
        Duration longestGap = std::chrono::milliseconds{150}; ///< bridged by interpolation
        Duration horizon = std::chrono::milliseconds{150};    ///< predicted beyond the newest
    };

    PoseHistory() = default;
    explicit PoseHistory(const Limits& limits) : m_limits{limits} {}

    /// Takes a sample in. One older than the newest is sorted into its place; one with the time of
    /// another replaces it. When full, the oldest makes room.
    /// @returns false where it was refused: not finite, a time more than a hundred years from the
    ///          clock's zero, or older than everything kept when full.
    bool push(const PoseSample& sample);

    /// The pose at time t; nothing for a time before the oldest sample kept.
    ///
    /// Validity is Lost when a sample next to t is lost, the samples around t are further apart
    /// than longestGap, or t is further beyond the newest than horizon (both limits still count as
    /// good). The pose is then that of the sample before t, or carried to the horizon, and has no
    /// motion. Between two samples the motion is their difference, and validity and error are
    /// those of the worse.
    /// Exact is the sample as it came, with the velocity that would carry it on.
    [[nodiscard]] std::optional<PoseSample> at(SessionTime t) const;

    /// The newest sample as it came.
    [[nodiscard]] std::optional<PoseSample> newest() const;

    /// All samples kept, oldest first.
    [[nodiscard]] std::vector<PoseSample> samples() const;

    void clear();

private:
    [[nodiscard]] std::optional<Motion> motionOf(std::size_t index) const;
    [[nodiscard]] PoseSample carriedOn(std::size_t index, SessionTime t) const;

    Limits m_limits;
    mutable std::mutex m_mutex;
    std::deque<PoseSample> m_samples; // ascending in time
};

} // namespace carina
