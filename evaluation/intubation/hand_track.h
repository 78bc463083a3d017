#pragma once

#include "engine/geometry/vec.h"

#include <array>
#include <random>
#include <vector>

namespace carina
{

/// The share of a minimum-jerk movement at a share u of its duration, 0 to 1: 10 u^3 - 15 u^4 + 6
/// u^5 (Flash and Hogan, J Neurosci 1985;5:1688), which begins and ends without speed or
/// acceleration. @pre u is within 0..1
[[nodiscard]] double minimumJerk(double u);

/// A number that a person takes from one value to the next by minimum-jerk movements, with pauses
/// between them. Times in seconds from the first movement's start.
class HandTrack
{
public:
    explicit HandTrack(double start) : m_start{start} {}

    /// Stays until a time. @pre not before end()
    void waitUntil(double seconds);
    /// Goes to a value within a time, which begins at end(). @pre seconds is above zero
    void moveTo(double value, double seconds);

    /// Its end so far.
    [[nodiscard]] double end() const { return m_end; }
    /// The value there.
    [[nodiscard]] double last() const { return m_moves.empty() ? m_start : m_moves.back().to; }
    /// The value at a time: before the first movement its start, after the last one its end.
    [[nodiscard]] double at(double seconds) const;

private:
    struct Move {
        double from_s, until_s;
        double from, to;
    };

    double m_start;
    double m_end = 0.0;
    std::vector<Move> m_moves; // in their order, without overlap
};

/// How a hand trembles and sways: along each axis two sines of the band of physiological tremor, 8
/// to 12 Hz (McAuley and Marsden, Brain 2000;123:1545), and two slow ones, 0.2 to 0.7 Hz, of ours.
/// A pure function of time.
class HandTremor
{
public:
    HandTremor() = default; ///< of a hand that is still
    /// @param tremor, sway root mean squares along one axis, metres
    HandTremor(double tremor, double sway, std::mt19937& random);

    [[nodiscard]] Vec3 at(double seconds) const;

private:
    struct Sine {
        double amplitude = 0.0;
        double radiansPerSecond = 0.0;
        double phase = 0.0;
    };
    std::array<std::array<Sine, 4>, 3> m_sines{};
};

/// An even number of 0 to 1; of the generator alone, as the distributions of the standard library
/// differ from one to the next.
[[nodiscard]] double evenOf(std::mt19937& random);
/// An even number between two others.
[[nodiscard]] double evenBetween(double least, double most, std::mt19937& random);
/// A number of the normal distribution with deviation 1 (Box and Muller 1958).
[[nodiscard]] double normalOf(std::mt19937& random);

} // namespace carina
