#include "widgets/report/plot_scale.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kIntervals = 6;         ///< of a linear axis, about
constexpr int kDecadesWithMinors = 4; ///< and fewer
constexpr int kLargestPlainPower = 3; ///< 0.001 to 1000 are written out

double roundStep(double length)
{
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (length <= digit * power * (1.0 + 1e-12))
            return digit * power;
    return 10.0 * power;
}

QString powerOfTen(int power)
{
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = QStringLiteral("10");
    for (const QChar letter : QString::number(power))
        text += letter == QLatin1Char{'-'} ? QChar{0x207B} : digits[letter.digitValue()];
    return text;
}

} // namespace

PlotScale PlotScale::linear(double least, double greatest)
{
    CARINA_EXPECTS(std::isfinite(least) && std::isfinite(greatest) && least <= greatest);
    const double near = (greatest - least) / 4.0;
    if (least > 0.0 && least < near)
        least = 0.0;
    if (greatest < 0.0 && -greatest < near)
        greatest = 0.0;
    if (least == greatest)
        greatest = least + std::max(1.0, std::abs(least));
    const double step = roundStep((greatest - least) / kIntervals);
    return {std::floor(least / step + 1e-9) * step, std::ceil(greatest / step - 1e-9) * step, step};
}

PlotScale PlotScale::logarithmic(double least, double greatest)
{
    CARINA_EXPECTS(least > 0.0 && least <= greatest && std::isfinite(greatest));
    const double first = std::floor(std::log10(least) + 1e-9);
    const double last = std::max(first + 1.0, std::ceil(std::log10(greatest) - 1e-9));
    return {std::pow(10.0, first), std::pow(10.0, last), 0.0};
}

bool PlotScale::shows(double value) const
{
    return std::isfinite(value) && (m_step > 0.0 || value > 0.0);
}

double PlotScale::placeOf(double value) const
{
    CARINA_EXPECTS(shows(value));
    if (m_step > 0.0)
        return (value - m_least) / (m_greatest - m_least);
    return std::log10(value / m_least) / std::log10(m_greatest / m_least);
}

std::vector<PlotScale::Tick> PlotScale::ticks() const
{
    if (m_step == 0.0)
        return decades();
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(m_step) + 1e-9)));
    const auto first = std::llround(m_least / m_step);
    const auto last = std::llround(m_greatest / m_step);
    std::vector<Tick> ticks;
    for (auto i = first; i <= last; ++i) {
        const double value = static_cast<double>(i) * m_step;
        ticks.push_back({value, QString::number(value, 'f', decimals)});
    }
    return ticks;
}

std::vector<PlotScale::Tick> PlotScale::decades() const
{
    const auto first = static_cast<int>(std::lround(std::log10(m_least)));
    const auto last = static_cast<int>(std::lround(std::log10(m_greatest)));
    const bool arePlain = std::max(std::abs(first), std::abs(last)) <= kLargestPlainPower;
    std::vector<Tick> ticks;
    for (int power = first; power <= last; ++power) {
        const double value = std::pow(10.0, power);
        ticks.push_back({value, arePlain ? QString::number(value, 'f', std::max(0, -power))
                                         : powerOfTen(power)});
        for (int digit = 2; digit < 10 && power < last && last - first <= kDecadesWithMinors;
             ++digit)
            ticks.push_back({digit * value, {}});
    }
    return ticks;
}

} // namespace carina
