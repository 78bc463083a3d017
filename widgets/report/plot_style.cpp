#include "widgets/report/plot_style.h"

#include <array>

namespace carina
{
namespace
{

constexpr double kMarkRadius = 4.5;

/// Colours of Okabe and Ito (2008), told apart by the colour-blind; in grey by dash and mark.
constexpr std::array kInks{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                           "#8a6d00", "#56b4e9", "#555555"};
constexpr std::array kDashes{"", "12 6", "3 5", "16 6 3 6"};

QString polygon(const QPointF& centre, std::initializer_list<QPointF> offsets)
{
    QString data;
    for (const QPointF& offset : offsets)
        data += QLatin1Char{data.isEmpty() ? 'M' : 'L'} + svgPoint(centre + kMarkRadius * offset);
    return data + QLatin1Char{'Z'};
}

QString circle(const QPointF& centre)
{
    // Two half circles, for an arc to where it begins is none.
    const QString arc = QStringLiteral("A%1,%1 0 1 1 ").arg(kMarkRadius);
    const QString left = svgPoint(centre - QPointF{kMarkRadius, 0.0});
    const QString right = svgPoint(centre + QPointF{kMarkRadius, 0.0});
    return QLatin1Char{'M'} + left + arc + right + arc + left + QLatin1Char{'Z'};
}

} // namespace

SvgStroke lineStroke(const Plot& plot, std::size_t series)
{
    if (plot.series[series].isReference)
        return {.colour = QStringLiteral("#000000"), .width = 4.0};
    return {.colour = QString::fromLatin1(kInks[series % kInks.size()]),
            .width = 2.0,
            .dashes = QString::fromLatin1(kDashes[series % kDashes.size()])};
}

QString markFill(const Plot& plot, std::size_t series)
{
    return series % 10 < 5 ? lineStroke(plot, series).colour : QStringLiteral("#ffffff");
}

QString markOutline(std::size_t series, const QPointF& at)
{
    switch (series % 5) {
    case 0:
        return circle(at);
    case 1:
        return polygon(at, {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}});
    case 2:
        return polygon(at, {{0.0, -1.2}, {1.2, 1.0}, {-1.2, 1.0}});
    case 3:
        return polygon(at, {{0.0, -1.4}, {1.4, 0.0}, {0.0, 1.4}, {-1.4, 0.0}});
    default:
        return polygon(at, {{0.0, 1.2}, {1.2, -1.0}, {-1.2, -1.0}});
    }
}

} // namespace carina
