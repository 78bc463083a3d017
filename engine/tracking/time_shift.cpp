#include "engine/tracking/time_shift.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace carina
{
namespace
{

constexpr Duration kSpeedOver = std::chrono::milliseconds{60};
constexpr Duration kLongestHole = std::chrono::milliseconds{150};
constexpr Angle kLeastChange = degrees(2.0); // a second: standard deviation of the speed

/// Angular speeds at multiples of kShiftStep after `start`, rad/s; NaN where it is not known.
struct Speeds {
    SessionTime start{};
    std::vector<double> values{};
};

std::vector<PoseSample> seenOf(std::span<const PoseSample> samples)
{
    std::vector<PoseSample> seen;
    for (const PoseSample& sample : samples)
        if (sample.validity != Validity::Lost)
            seen.push_back(sample);
    return seen;
}

Quat unknownRotation()
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone, kNone, kNone};
}

/// The rotation at a time between two samples; NaN in a hole.
Quat rotationAt(const std::vector<PoseSample>& samples, SessionTime t)
{
    const auto after = std::ranges::lower_bound(samples, t, {}, &PoseSample::time);
    if (after == samples.end() || (after == samples.begin() && after->time != t))
        return unknownRotation();
    if (after->time == t)
        return after->X_FO.rotation();
    const PoseSample& before = *std::prev(after);
    const Duration gap = after->time - before.time;
    if (gap > kLongestHole)
        return unknownRotation();
    return before.X_FO.rotation().slerp(toSeconds(t - before.time) / toSeconds(gap),
                                        after->X_FO.rotation());
}

Speeds speedsOf(const std::vector<PoseSample>& samples)
{
    Speeds speeds{.start = samples.front().time + kSpeedOver / 2};
    for (SessionTime t = speeds.start; t + kSpeedOver / 2 <= samples.back().time; t += kShiftStep) {
        const Quat from = rotationAt(samples, t - kSpeedOver / 2);
        const Quat to = rotationAt(samples, t + kSpeedOver / 2);
        const bool isKnown = from.coeffs().allFinite() && to.coeffs().allFinite();
        speeds.values.push_back(isKnown ? angleBetween(to, from).si / toSeconds(kSpeedOver)
                                        : std::nan(""));
    }
    return speeds;
}

/// Correlation of a(t) and b(t + shift) over all steps at which both are known.
struct Correlation {
    double value = 0.0;
    std::size_t steps = 0;
    double deviation = 0.0; ///< of a
};

Correlation correlationAt(const Speeds& a, const Speeds& b, std::ptrdiff_t shift)
{
    std::array<double, 5> sums{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const std::ptrdiff_t j = std::ptrdiff_t(i) + shift;
        if (j < 0 || j >= std::ptrdiff_t(b.values.size()))
            continue;
        const double x = a.values[i];
        const double y = b.values[std::size_t(j)];
        if (!std::isfinite(x) || !std::isfinite(y))
            continue;
        ++count;
        sums[0] += x;
        sums[1] += y;
        sums[2] += x * x;
        sums[3] += y * y;
        sums[4] += x * y;
    }
    if (count < 2)
        return {};
    const auto n = double(count);
    const double varA = sums[2] / n - sums[0] * sums[0] / (n * n);
    const double varB = sums[3] / n - sums[1] * sums[1] / (n * n);
    const double both = sums[4] / n - sums[0] * sums[1] / (n * n);
    if (!(varA > 0.0 && varB > 0.0))
        return {.steps = count};
    return {both / std::sqrt(varA * varB), count, std::sqrt(varA)};
}

} // namespace

Result<TimeShift> timeShift(std::span<const PoseSample> first, std::span<const PoseSample> second,
                            Duration most)
{
    const auto a = seenOf(first);
    const auto b = seenOf(second);
    if (a.size() < 2 || b.size() < 2)
        return fail(Errc::TooFewPoses, "fewer than two poses were seen");
    const Speeds speedsA = speedsOf(a);
    const Speeds speedsB = speedsOf(b);
    // b's steps begin at another time than a's; the rest is added at the end.
    const auto offset = (speedsA.start - speedsB.start) / kShiftStep;
    const Duration rest = (speedsB.start + offset * kShiftStep) - speedsA.start;
    const auto steps = most / kShiftStep;
    std::vector<Correlation> all;
    for (auto step = -steps - 1; step <= steps + 1; ++step)
        all.push_back(correlationAt(speedsA, speedsB, std::ptrdiff_t(offset + step)));
    const auto fewest = std::ranges::min(all, {}, &Correlation::steps).steps;
    if (Duration{kShiftStep} * std::int64_t(fewest) < 4 * most)
        return fail(Errc::TooFewPoses, "the recordings overlap too shortly");
    const auto best = std::ranges::max_element(all, {}, &Correlation::value);
    const auto at = best - all.begin();
    if (best->deviation < kLeastChange.si || best->value < kLeastCorrelation || at == 0
        || at + 1 == std::ptrdiff_t(all.size()))
        return fail(Errc::NotEnoughMotion, "the two do not show one motion that turns to and fro");
    const double before = all[std::size_t(at - 1)].value;
    const double after = all[std::size_t(at + 1)].value;
    const double bend = before - 2.0 * best->value + after;
    const double fine = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
    const Duration coarse = (at - steps - 1) * kShiftStep;
    return TimeShift{coarse + rest + fromSeconds(fine * toSeconds(kShiftStep)), best->value};
}

} // namespace carina
