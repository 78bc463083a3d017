#include "tests/support/test_class.h"
#include "widgets/report/plot_svg.h"

#include <QFont>
#include <QGuiApplication>
#include <QXmlStreamReader>

#include <cmath>
#include <set>

namespace carina::plot_svg_test
{
namespace
{

constexpr double kHundredth = 0.011; ///< pixels, to which a coordinate is written

/// What an SVG file holds.
struct Drawing {
    bool isXml = false;
    QRectF axes; // the last rectangle
    std::vector<std::vector<QPointF>> polylines;
    std::vector<QString> dashes; // of each polyline
    std::set<QString> words;
    QString description;
    double smallestFont_px = 1e9;
};

std::vector<QPointF> pointsIn(const QString& pairs)
{
    std::vector<QPointF> points;
    for (const QString& pair : pairs.split(QLatin1Char{' '}, Qt::SkipEmptyParts)) {
        const QStringList numbers = pair.split(QLatin1Char{','});
        points.emplace_back(numbers.value(0).toDouble(), numbers.value(1).toDouble());
    }
    return points;
}

Drawing drawingOf(const QByteArray& svg)
{
    Drawing drawing;
    QXmlStreamReader xml{svg};
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const QXmlStreamAttributes attributes = xml.attributes();
        const auto number = [&attributes](const char* name) {
            return attributes.value(QLatin1StringView{name}).toDouble();
        };
        if (xml.name() == QStringLiteral("polyline")) {
            drawing.polylines.push_back(
                pointsIn(attributes.value(QStringLiteral("points")).toString()));
            drawing.dashes.push_back(
                attributes.value(QStringLiteral("stroke-dasharray")).toString());
        } else if (xml.name() == QStringLiteral("rect")) {
            drawing.axes = {number("x"), number("y"), number("width"), number("height")};
        } else if (xml.name() == QStringLiteral("text")) {
            drawing.smallestFont_px = std::min(drawing.smallestFont_px, number("font-size"));
            drawing.words.insert(xml.readElementText());
        } else if (xml.name() == QStringLiteral("desc")) {
            drawing.description = xml.readElementText();
        }
    }
    drawing.isXml = !xml.hasError();
    return drawing;
}

/// So many parts of the axes from the left and from below.
QPointF partOf(const QRectF& axes, double x, double y)
{
    return {axes.left() + x * axes.width(), axes.bottom() - y * axes.height()};
}

Plot twoSeries()
{
    return {.title = QStringLiteral("A title"),
            .stamp = QStringLiteral("made by <a> & \"test\""),
            .x = {QStringLiteral("time, s")},
            .y = {QStringLiteral("length, m")},
            .series = {{.name = QStringLiteral("first"),
                        .marks = {{1.0, 2.0}, {2.0, 3.0}},
                        .line = {{1.0, 2.0}, {2.0, 2.5}, {3.0, 10.0}}},
                       {.name = QStringLiteral("second"), .line = {{1.0, 0.0}, {3.0, 4.0}}}}};
}

} // namespace

class PlotSvgTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pointsLieWhereTheAxesSay()
    {
        // Axes 1 to 3 and 0 to 10: whole and half parts of their lengths.
        const Drawing drawing = drawingOf(svgOf(twoSeries()));
        QVERIFY(drawing.isXml);
        QCOMPARE(drawing.polylines.size(), std::size_t{2});
        const QRectF& axes = drawing.axes;
        const std::vector<QPointF> truth{partOf(axes, 0.0, 0.2), partOf(axes, 0.5, 0.25),
                                         partOf(axes, 1.0, 1.0)};
        QCOMPARE(drawing.polylines[0].size(), truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) {
            QVERIFY(std::abs(drawing.polylines[0][i].x() - truth[i].x()) < kHundredth);
            QVERIFY(std::abs(drawing.polylines[0][i].y() - truth[i].y()) < kHundredth);
        }
    }

    void logarithmicAxisLeavesOutWhatItCannotShow()
    {
        Plot plot = twoSeries();
        plot.y.isLogarithmic = true;
        plot.series[0].line = {{1.0, 0.0}, {2.0, 1.0}, {3.0, 100.0}};
        plot.series[1].line = {{1.0, 10.0}};
        const Drawing drawing = drawingOf(svgOf(plot));
        QCOMPARE(drawing.polylines[0].size(), std::size_t{2}); // (1, 0) is not among them
        QVERIFY(std::abs(drawing.polylines[0][0].y() - drawing.axes.bottom()) < kHundredth);
        QVERIFY(std::abs(drawing.polylines[0][1].y() - drawing.axes.top()) < kHundredth);
        QVERIFY(std::abs(drawing.polylines[1][0].y() - drawing.axes.center().y()) < kHundredth);
    }

    void hasAllWordsLargeEnoughForPrint()
    {
        const Drawing drawing = drawingOf(svgOf(twoSeries()));
        for (const char* words : {"A title", "made by <a> & \"test\"", "time, s", "length, m",
                                  "first", "second", "0", "10", "3.0"})
            QVERIFY2(drawing.words.contains(QString::fromLatin1(words)), words);
        QCOMPARE(drawing.description, QStringLiteral("made by <a> & \"test\""));
        QVERIFY(drawing.smallestFont_px >= 16.0); // 12 points
    }

    void linesDifferWithoutColour()
    {
        const Drawing drawing = drawingOf(svgOf(twoSeries()));
        QCOMPARE(drawing.dashes[0], QString{});
        QVERIFY(drawing.dashes[1] != drawing.dashes[0]);
    }

    void fontsHaveNoSay()
    {
        const QByteArray before = svgOf(twoSeries());
        QGuiApplication::setFont(QFont{QStringLiteral("DejaVu Sans Mono"), 40});
        QCOMPARE(svgOf(twoSeries()), before);
    }

    void plotOfNothingIsADrawingYet()
    {
        const Drawing drawing = drawingOf(svgOf(Plot{}));
        QVERIFY(drawing.isXml);
        QVERIFY(drawing.polylines.empty());
        QVERIFY(drawing.axes.height() > 400.0);
    }
};

CARINA_SCREEN_TEST(PlotSvgTest)

} // namespace carina::plot_svg_test

#include "tst_plot_svg.moc"
