#include "apps/lab/figures/figure_plots.h"

namespace carina::lab
{
namespace
{

constexpr int kTrendPoints = 200;

QString trendWords(std::size_t order)
{
    if (order == 1)
        return QStringLiteral("linear regression");
    return QStringLiteral("trend of order %1").arg(order);
}

std::vector<QPointF> trendLine(const DriftCurve& curve)
{
    const double first = curve.x.front();
    const double length = curve.x.back() - first;
    std::vector<QPointF> line;
    for (int i = 0; i <= kTrendPoints; ++i) {
        const double x = first + length * i / kTrendPoints;
        line.emplace_back(x, curve.trend.at(x));
    }
    return line;
}

PlotSeries seriesOf(const DriftCurve& curve)
{
    PlotSeries series;
    series.name = QString::fromStdString(curve.name);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        series.marks.emplace_back(curve.x[i], curve.y[i]);
    const std::size_t coefficients = curve.trend.coefficients.size();
    if (coefficients > 0) {
        series.name += QStringLiteral(", ") + trendWords(coefficients - 1);
        series.line = trendLine(curve);
    } else {
        series.line = series.marks;
    }
    return series;
}

QString stampOf(const DriftFigure& figure, const FigureStamp& stamp)
{
    const QString seeds = stamp.seeds == 1 ? QStringLiteral("seed %1").arg(stamp.seed)
                                           : QStringLiteral("seeds %1 to %2")
                                                 .arg(stamp.seed)
                                                 .arg(qint64{stamp.seed} + stamp.seeds - 1);
    return QStringLiteral("Carina %1, network %2, %3")
        .arg(QString::fromUtf8(stamp.version), QString::fromStdString(figure.network), seeds);
}

} // namespace

Plot plotOf(const DriftFigure& figure, const FigureStamp& stamp)
{
    Plot plot{.title = QString::fromStdString(figure.title),
              .stamp = stampOf(figure, stamp),
              .x = {QString::fromStdString(figure.xLabel), figure.isLogarithmic},
              .y = {QString::fromStdString(figure.yLabel), figure.isLogarithmic, true},
              .series = {}};
    for (const DriftCurve& curve : figure.curves)
        plot.series.push_back(seriesOf(curve));
    if (figure.hasLimit) {
        plot.series.back().marks.clear();
        plot.series.back().isReference = true;
    }
    return plot;
}

} // namespace carina::lab
