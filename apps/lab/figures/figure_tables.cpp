#include "apps/lab/figures/figure_tables.h"

#include <QLocale>

namespace carina::lab
{
namespace
{

constexpr std::size_t kMostCoefficients = kTrendOfStrategies + 1;
constexpr std::size_t kPsis = 5;

QByteArray numberField(double value)
{
    return QByteArray::number(value, 'g', QLocale::FloatingPointShortest);
}

/// Quoted only where it must be: the name of a file may hold anything.
QByteArray textField(const std::string& text)
{
    QByteArray field = QByteArray::fromStdString(text);
    if (!field.contains(',') && !field.contains('"') && !field.contains('\n'))
        return field;
    return '"' + field.replace('"', "\"\"") + '"';
}

QByteArray stampFields(const FigureStamp& stamp, const DriftFigure& figure)
{
    return stamp.version + ',' + QByteArray::number(stamp.seed) + ','
           + QByteArray::number(stamp.seeds) + ',' + textField(figure.network);
}

/// So many fields, the first of them filled.
QByteArray filledFields(std::span<const double> values, std::size_t count)
{
    QByteArray fields;
    for (std::size_t i = 0; i < count; ++i)
        fields += ',' + (i < values.size() ? numberField(values[i]) : QByteArray{});
    return fields;
}

} // namespace

QByteArray pointsCsv(const DriftFigure& figure, const FigureStamp& stamp)
{
    QByteArray csv = "version,seed,seeds,network,curve," + textField(figure.xColumn) + ','
                     + textField(figure.yColumn) + ",trend\n";
    for (const DriftCurve& curve : figure.curves) {
        const bool hasTrend = !curve.trend.coefficients.empty();
        for (std::size_t i = 0; i < curve.x.size(); ++i)
            csv += stampFields(stamp, figure) + ',' + textField(curve.name) + ','
                   + numberField(curve.x[i]) + ',' + numberField(curve.y[i]) + ','
                   + (hasTrend ? numberField(curve.trend.at(curve.x[i])) : QByteArray{}) + '\n';
    }
    return csv;
}

QByteArray trendsCsv(std::span<const DriftFigure> figures, const FigureStamp& stamp)
{
    QByteArray csv = "version,seed,seeds,network,figure,curve,x,y,order";
    for (std::size_t i = 0; i < kMostCoefficients; ++i)
        csv += ",coefficient_" + QByteArray::number(i);
    for (std::size_t i = 1; i <= kPsis; ++i)
        csv += ",psi_" + QByteArray::number(i);
    csv += '\n';
    for (const DriftFigure& figure : figures) {
        for (const DriftCurve& curve : figure.curves) {
            const auto& coefficients = curve.trend.coefficients;
            if (coefficients.empty())
                continue;
            csv += stampFields(stamp, figure) + ',' + textField(figure.name) + ','
                   + textField(curve.name) + ',' + textField(figure.xColumn) + ','
                   + textField(figure.yColumn) + ',' + QByteArray::number(coefficients.size() - 1)
                   + filledFields(coefficients, kMostCoefficients);
            const bool isByParticipants = curve.x.size() == kPsis;
            csv += filledFields(isByParticipants ? curve.y : std::vector<double>{}, kPsis) + '\n';
        }
    }
    return csv;
}

QByteArray paperCsv(std::span<const PaperValue> values, const FigureStamp& stamp)
{
    QByteArray csv = "version,seed,seeds,network,figure,y,quantity,measured,order,paper_figure,"
                     "paper_printed,paper_trend,source\n";
    for (const PaperValue& value : values) {
        const DriftFigure& figure = *value.figure;
        csv += stampFields(stamp, figure) + ',' + textField(figure.name) + ','
               + textField(figure.yColumn) + ',' + textField(value.quantity) + ','
               + numberField(value.measured) + ','
               + QByteArray::number(figure.curves.back().trend.coefficients.size() - 1) + ','
               + QByteArray::number(value.number) + ',' + textField(value.printed) + ','
               + textField(value.trend) + ",Hamza-Lup et al. 2004\n";
    }
    return csv;
}

} // namespace carina::lab
