#include "widgets/report/plot_picture.h"

#include "tests/support/test_class.h"
#include "widgets/report/plot_svg.h"

#include <QImage>
#include <QRegularExpression>

namespace carina::plot_picture_test
{

class PlotPictureTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheDrawingWithTwiceThePixels()
    {
        const Plot plot{.series = {{.line = {{0.0, 1.0}, {6.0, 1.0}}, .isReference = true}}};
        const QByteArray svg = svgOf(plot);
        const QImage image = QImage::fromData(pngOf(svg, QStringLiteral("made by a test")), "PNG");
        QCOMPARE(image.size(), QSize(2 * kFigureWidth, 2 * kFigureHeight));
        QCOMPARE(image.text(QStringLiteral("Description")), QStringLiteral("made by a test"));
        QCOMPARE(image.pixelColor(0, 0), QColor{Qt::white});
        // A level black line: its height is that of its first point. Above it, between two lines
        // of the grid, is nothing.
        const QRegularExpression points{QStringLiteral("points=\"([0-9.]+),([0-9.]+) ")};
        const auto match = points.match(QString::fromUtf8(svg));
        QVERIFY(match.hasMatch());
        const int y = qRound(2.0 * match.captured(2).toDouble());
        const int x = qRound(2.0 * match.captured(1).toDouble()) + 30;
        QCOMPARE(image.pixelColor(x, y), QColor{Qt::black});
        QCOMPARE(image.pixelColor(x, y - 30), QColor{Qt::white});
    }

    void wordsAreDrawn()
    {
        Plot plot{.title = QStringLiteral("A title")};
        const QByteArray with = pngOf(svgOf(plot), {});
        plot.title.clear();
        QVERIFY(with != pngOf(svgOf(plot), {}));
    }
};

CARINA_SCREEN_TEST(PlotPictureTest)

} // namespace carina::plot_picture_test

#include "tst_plot_picture.moc"
