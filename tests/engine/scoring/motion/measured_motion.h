#pragma once

#include "engine/scoring/motion/motion_meter.h"

#include <cmath>
#include <functional>

namespace carina::test
{

inline constexpr double kRate_Hz = 60.0;

inline SessionTime atSeconds(double seconds)
{
    return SessionTime{std::chrono::nanoseconds{std::llround(seconds * 1e9)}};
}

inline PoseSample placed(double seconds, const Vec3& p_F)
{
    PoseSample sample;
    sample.time = atSeconds(seconds);
    sample.X_FO = RigidTransform::translation(p_F);
    return sample;
}

/// Whether sample i is lost.
using IsLost = std::function<bool(int i)>;

/// Adds the positions of a motion at kRate_Hz, both ends included.
inline void addMotion(
    MotionMeter& meter, double from_s, double to_s, const std::function<Vec3(double)>& p_F,
    const IsLost& isLost = [](int) { return false; })
{
    const int intervals = int(std::lround((to_s - from_s) * kRate_Hz));
    for (int i = 0; i <= intervals; ++i) {
        const double t = from_s + i / kRate_Hz;
        PoseSample sample = placed(t, p_F(t));
        if (isLost(i))
            sample.validity = Validity::Lost;
        meter.add(sample);
    }
}

} // namespace carina::test
