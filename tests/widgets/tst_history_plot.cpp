#include "tests/support/test_class.h"
#include "widgets/history_plot.h"

#include <QImage>

namespace carina::history_plot_test
{
namespace
{

constexpr std::size_t kCapacity = 11;
constexpr double kPixel = 1e-6; ///< rounding, pixels

/// A plot 300 pixels wide with these values.
std::unique_ptr<HistoryPlot> plotOf(const std::vector<double>& values,
                                    const std::optional<HistoryPlot::Band>& band = {})
{
    auto plot = std::make_unique<HistoryPlot>();
    plot->resize(300, 140);
    plot->setUp(kCapacity, QStringLiteral("ms"), QStringLiteral("nothing yet"));
    plot->setHistory(values, band);
    return plot;
}

QImage painted(HistoryPlot& plot)
{
    QPalette palette;
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::Text, Qt::black);
    palette.setColor(QPalette::Highlight, Qt::red);
    plot.setPalette(palette);
    return plot.grab().toImage();
}

} // namespace

class TestHistoryPlot : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scalesEndAtRoundNumbers_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("top");
        QTest::newRow("nothing") << 0.0 << 1.0;
        QTest::newRow("below nothing") << -3.0 << 1.0;
        QTest::newRow("one") << 1.0 << 1.0;
        QTest::newRow("just above one") << 1.01 << 2.0;
        QTest::newRow("two") << 2.0 << 2.0;
        QTest::newRow("four") << 4.0 << 5.0;
        QTest::newRow("seven") << 7.0 << 10.0;
        QTest::newRow("small") << 0.034 << 0.05;
        QTest::newRow("large") << 180.0 << 200.0;
    }

    void scalesEndAtRoundNumbers()
    {
        QFETCH(const double, value);
        QFETCH(const double, top);
        QVERIFY(std::abs(roundUpTo125(value) - top) < 1e-9 * top);
    }

    void drawsTheNewestAtTheRightEdge()
    {
        const auto plot = plotOf({5.0, 0.0, 10.0});
        const HistoryPlot::Drawing drawn = plot->drawing();
        QCOMPARE(drawn.top, 10.0);
        QCOMPARE(drawn.curve.size(), 3);
        QVERIFY(std::abs(drawn.curve[2].x() - drawn.frame.right()) < kPixel);
        QVERIFY(std::abs(drawn.curve[2].y() - drawn.frame.top()) < kPixel);
        QVERIFY(std::abs(drawn.curve[1].y() - drawn.frame.bottom()) < kPixel);
        QVERIFY(std::abs(drawn.curve[0].y() - drawn.frame.center().y()) < kPixel);
        const double step = drawn.frame.width() / (kCapacity - 1);
        QVERIFY(std::abs(drawn.curve[2].x() - drawn.curve[0].x() - 2.0 * step) < kPixel);
    }

    void aFullHistoryIsAsWideAsTheFrame()
    {
        std::vector<double> values(kCapacity, 1.0);
        values.insert(values.begin(), {7.0, 8.0}); // older than it shows
        const HistoryPlot::Drawing drawn = plotOf(values)->drawing();
        QCOMPARE(drawn.curve.size(), int(kCapacity));
        QVERIFY(std::abs(drawn.curve.first().x() - drawn.frame.left()) < kPixel);
        QVERIFY(std::abs(drawn.curve.last().x() - drawn.frame.right()) < kPixel);
    }

    void theBandReachesOneSigmaToEitherSide()
    {
        const auto drawn = plotOf({4.0, 6.0}, HistoryPlot::Band{5.0, 1.0})->drawing();
        QCOMPARE(drawn.top, 10.0);
        const double tenth = drawn.frame.height() / 10.0;
        QVERIFY(std::abs(drawn.mean.value() - drawn.frame.center().y()) < kPixel);
        QVERIFY(std::abs(drawn.band.top() - (drawn.frame.center().y() - tenth)) < kPixel);
        QVERIFY(std::abs(drawn.band.bottom() - (drawn.frame.center().y() + tenth)) < kPixel);
        QCOMPARE(drawn.band.left(), drawn.frame.left());
        QCOMPARE(drawn.band.right(), drawn.frame.right());
    }

    void theBandStaysInsideTheFrame()
    {
        const auto drawn = plotOf({0.0, 9.0}, HistoryPlot::Band{4.5, 4.6})->drawing();
        QVERIFY(std::abs(drawn.band.bottom() - drawn.frame.bottom()) < kPixel);
        const auto high = plotOf({9.9}, HistoryPlot::Band{9.9, 0.2})->drawing();
        QCOMPARE(high.top, 20.0); // the band counts, too
    }

    void isDrawnInTheColoursOfThePalette()
    {
        const auto plot = plotOf({5.0, 5.0, 5.0}, HistoryPlot::Band{5.0, 1.0});
        const QImage image = painted(*plot);
        const HistoryPlot::Drawing drawn = plot->drawing();
        const auto at = [&](const QPointF& p) { return image.pixelColor(p.toPoint()); };
        const QPointF outside{drawn.frame.center().x(), drawn.frame.top() + 5.0};
        QCOMPARE(at(outside), QColor{Qt::white});
        const QColor band = at({drawn.frame.left() + 20.0, drawn.band.top() + 3.0});
        QVERIFY(band.red() == 255 && band.green() < 255); // reddish, but not red
        QVERIFY(band.green() > 0);
        QVERIFY(at((drawn.curve[1] + drawn.curve[2]) / 2.0).lightness() < 100); // the curve
    }

    void saysSoWhereThereIsNothing()
    {
        const auto plot = plotOf({});
        QVERIFY(plot->drawing().curve.isEmpty());
        QImage image = painted(*plot);
        QImage blank = image;
        blank.fill(image.pixel(0, 0));
        QVERIFY(image != blank);
    }

    void isReachedByTab() { QCOMPARE(plotOf({})->focusPolicy(), Qt::TabFocus); }
};

CARINA_SCREEN_TEST(TestHistoryPlot)

} // namespace carina::history_plot_test

#include "tst_history_plot.moc"
