#pragma once

#include "engine/tracking/pose_sample.h"

#include <deque>
#include <mutex>
#include <optional>

namespace carina
{

/// The recent poses of one object in one frame. A device or network thread pushes, any thread asks.
///
/// Asked for a time it answers with the sample of that time (Exact), the pose between two samples
/// (Interpolated: straight line and great circle), or the newest pose carried on by its velocity
/// (Predicted). The velocity is the sample's own where the source gave one, else the difference of
/// the two newest tracked samples.
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
    /// another replaces it; one that is not finite is refused.
    /// @returns false where it was refused (not finite, or older than everything kept when full).
    bool push(const PoseSample& sample);

    /// The pose at time t; nothing before the first sample ever came. Validity is Lost when the
    /// samples around t are lost, further apart than longestGap, or t is beyond the horizon: the
    /// pose is then the last one tracked (or carried to the horizon), and says so.
    [[nodiscard]] std::optional<PoseSample> at(SessionTime t) const;

    /// The newest sample as it came.
    [[nodiscard]] std::optional<PoseSample> newest() const;

    /// All samples kept, oldest first.
    [[nodiscard]] std::vector<PoseSample> samples() const;

    void clear();

private:
    Limits m_limits;
    mutable std::mutex m_mutex;
    std::deque<PoseSample> m_samples; // ascending in time
};

} // namespace carina
