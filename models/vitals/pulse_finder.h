#pragma once

#include "models/vitals/rising_edge.h"

#include <algorithm>

namespace carina
{

/// Finds the pulses in an oximeter's curve, however flat it has become: each rise through half of
/// its greatest height of late.
class PulseFinder
{
public:
    static constexpr double kLeast = 0.05;      ///< of the curve's scale: flatter is no pulse
    static constexpr double kForgotten_s = 3.0; ///< time constant of what was high

    /// @param step_s time since the last value
    /// @returns whether a pulse begins with this value
    bool take(double value, double step_s)
    {
        m_height = std::max(value, m_height * (1.0 - std::min(1.0, step_s / kForgotten_s)));
        return m_edge.take(m_height > kLeast ? value / m_height : 0.0);
    }

private:
    double m_height = 0.0;
    RisingEdge m_edge{0.35, 0.5};
};

} // namespace carina
