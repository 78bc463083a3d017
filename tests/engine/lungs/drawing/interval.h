#pragma once

#include <algorithm>
#include <cmath>

namespace carina::test
{

/// All numbers from low to high. What is computed with intervals holds for every number in them, so
/// that one evaluation says something about infinitely many. Rounding is left out: bounds are meant
/// to be compared with room to spare.
struct Interval {
    double low = 0.0;
    double high = 0.0;

    Interval() = default;
    explicit(false) Interval(double x) : low{x}, high{x} {} // NOLINT: a number is an interval
    Interval(double from, double to) : low{from}, high{to} {}

    friend Interval operator+(const Interval& a, const Interval& b)
    {
        return {a.low + b.low, a.high + b.high};
    }
    friend Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
    friend Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
    friend Interval operator*(const Interval& a, const Interval& b)
    {
        const auto [least, greatest] =
            std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
        return {least, greatest};
    }
    /// @pre b does not hold 0.
    friend Interval operator/(const Interval& a, const Interval& b)
    {
        return a * Interval{1.0 / b.high, 1.0 / b.low};
    }
    friend Interval min(const Interval& a, const Interval& b)
    {
        return {std::min(a.low, b.low), std::min(a.high, b.high)};
    }
    friend Interval max(const Interval& a, const Interval& b)
    {
        return {std::max(a.low, b.low), std::max(a.high, b.high)};
    }
};

} // namespace carina::test
