#include "widgets/error_bands.h"

#include "engine/core/expects.h"
#include "widgets/history_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kFinest_mm = 0.1;

/// At equal steps of lightness: 98, 75, 49, 22.
constexpr std::array kScale{QColor{255, 250, 215}, QColor{242, 168, 92}, QColor{192, 80, 62},
                            QColor{100, 22, 54}};

/// So many are told apart by the lighter part of the scale, whose end stands out from a dark window
/// also without colours.
constexpr int kFewBands = 8;
constexpr double kLighterPart = 0.8;

ErrorBands bandsOfWidth(double width_mm, const ErrorRange& range)
{
    const auto first = static_cast<int>(std::floor(inMillimetres(range.least) / width_mm));
    const auto end = static_cast<int>(std::ceil(inMillimetres(range.most) / width_mm));
    return {millimetres(width_mm), first, std::max(1, end - first)};
}

} // namespace

ErrorBands bandsOver(const ErrorRange& range)
{
    CARINA_EXPECTS(range.least.si >= 0.0 && range.least <= range.most
                   && std::isfinite(range.most.si));
    const double span_mm = inMillimetres(range.most - range.least);
    double width_mm = roundUpTo125(std::max(kFinest_mm, span_mm / kMostErrorBands));
    while (bandsOfWidth(width_mm, range).count > kMostErrorBands)
        width_mm = roundUpTo125(1.5 * width_mm);
    return bandsOfWidth(width_mm, range);
}

QColor bandColor(int band, int count)
{
    CARINA_EXPECTS(band >= 0 && band < count);
    const double end = (kScale.size() - 1) * (count <= kFewBands ? kLighterPart : 1.0);
    const double place = count == 1 ? 0.0 : double(band) * end / (count - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kScale.size() - 2);
    const double share = place - double(below);
    const QColor& a = kScale[below];
    const QColor& b = kScale[below + 1];
    const auto between = [share](int from, int to) {
        return static_cast<int>(std::lround(from + share * (to - from)));
    };
    return {between(a.red(), b.red()), between(a.green(), b.green()), between(a.blue(), b.blue())};
}

QColor isolineColor(int band, int count)
{
    CARINA_EXPECTS(band >= 0 && band < count);
    return bandColor(2 * band <= count ? count - 1 : 0, count);
}

} // namespace carina
