#pragma once

#include "engine/audio/sampling.h"

namespace carina
{

/// A gain that goes in a straight line to what is asked of it, so that no change is heard as a
/// click.
class GainRamp
{
public:
    static constexpr double kUsual_s = 0.02; ///< of ours

    /// @param ramp_s how long each change takes
    explicit GainRamp(double gain, double ramp_s = kUsual_s)
        : m_samples{static_cast<int>(ramp_s * kSoundRate)}, m_now{gain}, m_target{gain}
    {
    }

    void aim(double gain)
    {
        if (gain == m_target)
            return;
        m_target = gain;
        m_left = m_samples;
        m_step = (m_target - m_now) / m_samples;
    }

    [[nodiscard]] double now() const { return m_now; }
    [[nodiscard]] double target() const { return m_target; }

    /// The gain of the next sample.
    [[nodiscard]] double next()
    {
        if (m_left > 0)
            m_now = --m_left == 0 ? m_target : m_now + m_step;
        return m_now;
    }

private:
    int m_samples;
    double m_now;
    double m_target;
    int m_left = 0;
    double m_step = 0.0;
};

} // namespace carina
