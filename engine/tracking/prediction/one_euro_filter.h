#pragma once

#include "engine/tracking/pose_sample.h"

#include <optional>

namespace carina
{

/// Smooths the poses of a tracked object: strongly while it is still, and little while it moves
/// (the 1-Euro filter; Casiez, Roussel, Vogel, CHI 2012). Position and rotation each pass a low
/// pass of first order whose limit rises with the speed,
///
///     limit = still + slope * |speed|
///
/// where the speed is that of the raw samples after a low pass of 1 Hz. What it removes is the
/// jitter of the tracker; its price is a delay of 1 / (2 pi limit).
class OneEuroFilter
{
public:
    struct Limits {
        Frequency still; ///< of an object at rest
        double slope;    ///< Hz per m/s, or per rad/s
    };
    struct Settings {
        Limits position{hertz(2.0), 60.0};
        Limits rotation{hertz(2.0), 20.0};
    };
    static constexpr Frequency kSpeedLimit = hertz(1.0);
    /// After a gap longer than this it starts anew.
    static constexpr Duration kLongestGap = std::chrono::milliseconds{150};

    OneEuroFilter() = default;
    explicit OneEuroFilter(const Settings& settings) : m_settings{settings} {}

    /// Adds the next sample. @returns it, with its pose smoothed; one that is lost, or not later
    /// than the last, as it is.
    [[nodiscard]] PoseSample smoothed(PoseSample sample);

private:
    Settings m_settings;
    std::optional<PoseSample> m_raw; ///< the last sample that was seen
    RigidTransform m_X_FO;           ///< smoothed
    Vec3 m_v_FO = Vec3::Zero();
    Vec3 m_w_FO = Vec3::Zero();
};

} // namespace carina
