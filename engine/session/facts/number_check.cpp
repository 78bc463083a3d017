#include "engine/session/facts/number_check.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace carina
{

namespace
{

std::string inWords(double number)
{
    std::array<char, 32> text{};
    const auto written =
        std::to_chars(text.begin(), text.end(), number, std::chars_format::general, 6);
    return {text.begin(), written.ptr};
}

} // namespace

Result<void> checkNumber(const char* what, double value, double lowest, double highest,
                         const char* unit)
{
    if (!std::isfinite(value))
        return fail(Errc::NotFinite, what);
    if (value < lowest || value > highest)
        return fail(Errc::OutOfRange, std::string{what} + " " + inWords(value) + unit + " ("
                                          + inWords(lowest) + " to " + inWords(highest) + ")");
    return {};
}

Result<void> checkNumbers(std::initializer_list<CheckedNumber> numbers)
{
    for (const CheckedNumber& n : numbers) {
        const Result<void> verdict = checkNumber(n.what, n.value, n.lowest, n.highest, n.unit);
        if (!verdict)
            return verdict;
    }
    return {};
}

} // namespace carina
