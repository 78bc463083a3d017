#include "tests/support/test_class.h"
#include "widgets/waveform_plot.h"

#include <QImage>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>

namespace carina::waveform_plot_test
{
namespace
{

constexpr double kSpan_s = 10.0;
constexpr double kPixel = 1e-6; ///< rounding, pixels

std::unique_ptr<WaveformPlot> plot(const QString& timeUnit = {})
{
    auto made = std::make_unique<WaveformPlot>();
    made->resize(400, 100);
    made->setUp(QStringLiteral("Flow"), QStringLiteral("L/min"), kSpan_s, 10.0, timeUnit);
    return made;
}

double lastX(const WaveformPlot::Drawing& drawn) { return drawn.curves.back().last().x(); }

} // namespace

class TestWaveformPlot : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsNothingBeforeTheFirstValue()
    {
        const auto drawn = plot()->drawing();
        QVERIFY(drawn.curves.empty());
        QCOMPARE(drawn.bottom, 0.0);
        QCOMPARE(drawn.top, 10.0);
    }

    void sweepsFromLeftToRight()
    {
        const auto shown = plot();
        shown->add(20.0, 0.0);
        const auto begin = shown->drawing();
        QVERIFY(std::abs(lastX(begin) - begin.frame.left()) < kPixel);
        shown->add(22.5, 5.0);
        const auto later = shown->drawing();
        QVERIFY(std::abs(lastX(later) - later.frame.left() - 0.25 * later.frame.width()) < kPixel);
        QVERIFY(std::abs(later.now - lastX(later)) < kPixel);
        QVERIFY(std::abs(later.curves.back().last().y() - later.frame.center().y()) < kPixel);
        QCOMPARE(later.curves.size(), std::size_t{1});
    }

    void writesItsNameWhereNoCurveIs()
    {
        for (const int height : {72, 100, 300}) {
            const auto shown = plot(QStringLiteral("s"));
            shown->resize(400, height);
            shown->add(20.0, 10.0);
            shown->add(20.1, 10.0); // at the very top of the scale
            const auto drawn = shown->drawing();
            QVERIFY(drawn.title.top() >= 0.0 && drawn.title.bottom() <= drawn.frame.top());
            QVERIFY(drawn.title.height() >= shown->fontMetrics().height());
            QVERIFY(drawn.frame.height() > 20.0);
            for (const QPointF& point : drawn.curves.back())
                QVERIFY(point.y() >= drawn.frame.top());
        }
    }

    void leavesTheLastSweepAheadBehindAGap()
    {
        const auto shown = plot();
        for (double t = 0.0; t < 13.0; t += 0.1)
            shown->add(t, 1.0);
        const auto drawn = shown->drawing();
        QCOMPARE(drawn.curves.size(), std::size_t{2});
        const double ahead = drawn.curves[0].first().x();
        const double step = 0.1 / kSpan_s * drawn.frame.width();
        QVERIFY(drawn.curves[1].first().x() - drawn.frame.left() < step + kPixel);
        QVERIFY(ahead > drawn.now);
        const double gap = (ahead - drawn.now) / drawn.frame.width();
        QVERIFY2(gap > 0.03 && gap < 0.06, qPrintable(QString::number(gap)));
    }

    void movesNothingThatIsDrawn()
    {
        const auto shown = plot();
        for (double t = 0.0; t < 4.0; t += 0.5)
            shown->add(t, t);
        const QPolygonF before = shown->drawing().curves[0];
        shown->add(4.0, 4.0);
        const QPolygonF after = shown->drawing().curves[0];
        for (int i = 0; i < before.size(); ++i)
            QCOMPARE(after[i], before[i]);
    }

    void startsAfreshAfterAGapAndAfterAStepBack()
    {
        const auto shown = plot();
        shown->add(1.0, 1.0);
        shown->add(11.1, 1.0);
        QCOMPARE(shown->drawing().curves.size(), std::size_t{1});
        QCOMPARE(shown->drawing().curves[0].size(), 1);
        shown->add(11.2, 1.0);
        QCOMPARE(shown->drawing().curves[0].size(), 2);
        shown->add(11.2, 1.0);
        QCOMPARE(shown->drawing().curves[0].size(), 1);
    }

    void holdsZeroAndBothExtremes()
    {
        const auto shown = plot();
        shown->add(0.0, 34.0);
        QCOMPARE(shown->drawing().top, 40.0);
        QCOMPARE(shown->drawing().bottom, 0.0);
        shown->add(0.1, -0.5); // less than would be seen
        QCOMPARE(shown->drawing().bottom, 0.0);
        shown->add(0.2, -12.0);
        const auto drawn = shown->drawing();
        QCOMPARE(drawn.bottom, -15.0);
        QVERIFY(std::abs(drawn.zero - drawn.frame.top() - 40.0 / 55.0 * drawn.frame.height())
                < kPixel);
    }

    void shrinksItsScaleOnlyAsASweepBegins()
    {
        const auto shown = plot();
        shown->add(0.0, 90.0);
        for (double t = 0.1; t < 9.95; t += 0.1) {
            shown->add(t, 1.0);
            QCOMPARE(shown->drawing().top, 100.0);
        }
        shown->add(10.0, 1.0);
        QCOMPARE(shown->drawing().top, 10.0);
    }

    // What is written as 5 stands where a curve at 5 does, and so do both ends.
    void writesValuesAtTheirHeight()
    {
        const auto shown = plot();
        shown->add(0.0, 5.0);
        const auto drawn = shown->drawing();
        QCOMPARE(drawn.ticks.front().value, 0.0);
        QCOMPARE(drawn.ticks.back().value, 10.0);
        QVERIFY(std::abs(drawn.ticks.front().y - drawn.frame.bottom()) < kPixel);
        QVERIFY(std::abs(drawn.ticks.back().y - drawn.frame.top()) < kPixel);
        QVERIFY(drawn.ticks.size() > 2);
        for (const WaveformPlot::Tick& tick : drawn.ticks)
            if (tick.value == 5.0)
                QVERIFY(std::abs(tick.y - drawn.curves[0].first().y()) < kPixel);
        for (std::size_t i = 1; i < drawn.ticks.size(); ++i)
            QVERIFY(drawn.ticks[i - 1].y - drawn.ticks[i].y > shown->fontMetrics().height());
        QCOMPARE(drawn.times.size(), std::size_t{9}); // each second of ten
    }

    // Also where there is no room for numbers between both ends.
    void drawsLinesAcrossAtRoundValues()
    {
        for (const int height : {72, 100, 300}) {
            const auto shown = plot();
            shown->resize(400, height);
            shown->add(0.0, 34.0);
            shown->add(0.1, -12.0); // a scale from -15 to 40
            const auto drawn = shown->drawing();
            QVERIFY2(drawn.across.size() >= 2, qPrintable(QString::number(height)));
            double before = drawn.frame.bottom() + 1.0;
            for (const double y : drawn.across) {
                QVERIFY(y > drawn.frame.top() && y < drawn.frame.bottom());
                QVERIFY(before > drawn.frame.bottom() || before - y > 8.0);
                before = y;
            }
            const auto isCrossed = [&drawn](double at) {
                return std::ranges::any_of(drawn.across,
                                           [at](double y) { return std::abs(y - at) < kPixel; });
            };
            QVERIFY(isCrossed(drawn.zero));
            for (std::size_t i = 1; i + 1 < drawn.ticks.size(); ++i)
                QVERIFY(isCrossed(drawn.ticks[i].y));
        }
    }

    void comparesTwoPlaces()
    {
        const auto shown = plot();
        for (double t = 0.0; t < 5.0; t += 0.5)
            shown->add(t, t);
        shown->setFrozen(true);
        QVERIFY(!shown->drawing().mark);
        shown->setMark(1.1);
        shown->setCursor(3.0);
        const auto drawn = shown->drawing();
        QVERIFY(drawn.mark && drawn.cursor);
        QVERIFY(std::abs(*drawn.mark - drawn.frame.left() - 0.1 * drawn.frame.width()) < kPixel);
        QVERIFY(std::abs(*drawn.cursor - *drawn.mark - 0.2 * drawn.frame.width()) < kPixel);
        shown->setFrozen(false);
        QVERIFY(!shown->drawing().mark);
    }

    void sweepsInAnotherTime()
    {
        const auto shown = plot();
        for (double t = 0.0; t < 9.0; t += 0.5)
            shown->add(t, 1.0);
        shown->setSpan(30.0);
        const auto longer = shown->drawing();
        QCOMPARE(longer.curves[0].size(), 18);
        QVERIFY(std::abs(longer.now - longer.frame.left() - 8.5 / 30.0 * longer.frame.width())
                < kPixel);
        shown->setSpan(6.0);
        const auto shorter = shown->drawing();
        QCOMPARE(shorter.curves.size(), std::size_t{2}); // 6 to 8.5 s, and before it what is left
        QVERIFY(shorter.curves[0].size() + shorter.curves[1].size() < 13);
    }

    void holdsStillToBeMeasured()
    {
        const auto shown = plot();
        for (double t = 0.0; t < 5.0; t += 0.5)
            shown->add(t, t);
        const QSignalSpy pointed{shown.get(), &WaveformPlot::pointedAt};
        QTest::keyClick(shown.get(), Qt::Key_Right); // not frozen
        QCOMPARE(pointed.count(), 0);
        shown->setFrozen(true);
        shown->add(5.0, 99.0);
        QCOMPARE(shown->drawing().curves[0].size(), 10);
        const auto drawn = shown->drawing();
        const QPoint there{int(drawn.frame.left() + 0.31 * drawn.frame.width()), 50};
        QTest::mouseClick(shown.get(), Qt::LeftButton, {}, there);
        QCOMPARE(pointed.last()[0].toDouble(), 3.0);
        shown->setCursor(3.0);
        QCOMPARE(shown->atCursor()->value, 3.0);
        QVERIFY(std::abs(*shown->drawing().cursor - drawn.frame.left() - 0.3 * drawn.frame.width())
                < kPixel);
        QTest::keyClick(shown.get(), Qt::Key_Left);
        QCOMPARE(pointed.last()[0].toDouble(), 2.5);
        shown->setFrozen(false);
        QVERIFY(!shown->atCursor());
        shown->add(5.5, 1.0);
        QCOMPARE(shown->drawing().curves[0].size(), 1);
    }

    void paintsTheCurveInTheAccentColour()
    {
        const auto shown = plot(QStringLiteral("s"));
        QPalette palette;
        palette.setColor(QPalette::Base, Qt::black);
        palette.setColor(QPalette::Text, Qt::white);
        palette.setColor(QPalette::Mid, Qt::gray);
        palette.setColor(QPalette::Highlight, Qt::red);
        shown->setPalette(palette);
        for (double t = 0.0; t < 5.0; t += 0.1)
            shown->add(t, 5.0);
        const QImage image = shown->grab().toImage();
        const auto drawn = shown->drawing();
        const QColor there = image.pixelColor(int(drawn.frame.left() + 40),
                                              int(std::floor(drawn.frame.center().y())));
        QVERIFY(there.red() > 200 && there.green() < 80);
        const QColor ahead = image.pixelColor(int(drawn.frame.right() - 40),
                                              int(std::floor(drawn.frame.center().y())));
        QVERIFY(ahead.red() < 80);
    }
};

CARINA_SCREEN_TEST(TestWaveformPlot)

} // namespace carina::waveform_plot_test

#include "tst_waveform_plot.moc"
