#include "engine/core/clock_shift.h"

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace carina
{
namespace
{

Duration times(double factor, LocalTime t)
{
    return Duration{std::llround(factor * static_cast<double>(t.time_since_epoch().count()))};
}

Result<double> numberIn(const char* text, double largest)
{
    const std::string_view all = text ? text : "0";
    double number = 0.0;
    const auto read = std::from_chars(all.data(), all.data() + all.size(), number);
    if (read.ec != std::errc{} || read.ptr != all.data() + all.size()
        || !(std::abs(number) <= largest))
        return fail(Errc::OutOfRange, std::string{all});
    return number;
}

} // namespace

LocalTime ClockShift::process(LocalTime machine) const
{
    return machine + offset + times(skew, machine);
}

LocalTime ClockShift::machine(LocalTime process) const
{
    const LocalTime withoutOffset = process - offset;
    return withoutOffset - times(skew / (1.0 + skew), withoutOffset);
}

Result<Duration> millisecondsFrom(const char* text)
{
    return numberIn(text, 1e3 * toSeconds(ClockShift::kLargestOffset)).map([](double ms) {
        return fromSeconds(1e-3 * ms);
    });
}

Result<ClockShift> clockShiftFrom(const char* offsetMs, const char* ppm)
{
    const auto offset = millisecondsFrom(offsetMs);
    const auto skew = numberIn(ppm, 1e6 * ClockShift::kLargestSkew);
    if (!offset || !skew)
        return tl::unexpected(offset ? skew.error() : offset.error());
    return ClockShift{*offset, 1e-6 * *skew};
}

} // namespace carina
