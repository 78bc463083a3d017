#include "evaluation/intubation/hand_track.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{

double minimumJerk(double u) { return u * u * u * (10.0 + u * (6.0 * u - 15.0)); }

void HandTrack::waitUntil(double seconds)
{
    CARINA_EXPECTS(seconds >= m_end);
    m_end = seconds;
}

void HandTrack::moveTo(double value, double seconds)
{
    CARINA_EXPECTS(seconds > 0.0);
    m_moves.push_back({m_end, m_end + seconds, last(), value});
    m_end += seconds;
}

double HandTrack::at(double seconds) const
{
    const auto next = std::ranges::upper_bound(m_moves, seconds, {}, &Move::from_s);
    if (next == m_moves.begin())
        return m_start;
    const Move& move = *std::prev(next);
    const double u = std::min((seconds - move.from_s) / (move.until_s - move.from_s), 1.0);
    return std::lerp(move.from, move.to, minimumJerk(u));
}

HandTremor::HandTremor(double tremor, double sway, std::mt19937& random)
{
    // Each of two sines with amplitude a has a root mean square of a / sqrt(2): both have a.
    for (auto& axis : m_sines)
        for (std::size_t i = 0; i < axis.size(); ++i) {
            const bool isFast = i < 2;
            const double hertz =
                isFast ? evenBetween(8.0, 12.0, random) : evenBetween(0.2, 0.7, random);
            axis[i] = {isFast ? tremor : sway, 2.0 * std::numbers::pi * hertz,
                       evenBetween(0.0, 2.0 * std::numbers::pi, random)};
        }
}

Vec3 HandTremor::at(double seconds) const
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t axis = 0; axis < m_sines.size(); ++axis)
        for (const Sine& sine : m_sines[axis])
            sum[Eigen::Index(axis)] +=
                sine.amplitude * std::sin(sine.radiansPerSecond * seconds + sine.phase);
    return sum;
}

double evenOf(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

double evenBetween(double least, double most, std::mt19937& random)
{
    return least + (most - least) * evenOf(random);
}

double normalOf(std::mt19937& random)
{
    const double radius = std::sqrt(-2.0 * std::log(1.0 - evenOf(random)));
    return radius * std::cos(2.0 * std::numbers::pi * evenOf(random));
}

} // namespace carina
