#include "tests/engine/lungs/mechanics/clock_listener.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <random>
#include <vector>

namespace carina::manikin_rate_test
{

using namespace carina::test;

/// What the clock makes of a manikin whose breaths are missed, or that changes its rate.
class TestManikinRate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void doesNotMindMissedBreaths_data();
    void doesNotMindMissedBreaths();
    void followsAManikinThatChangesItsRate_data();
    void followsAManikinThatChangesItsRate();
    void staysWithAManikinThatBreathesIrregularly();
    void pullsByHalfABreathAtTheMost();
};

void TestManikinRate::doesNotMindMissedBreaths_data()
{
    QTest::addColumn<std::vector<int>>("missed");
    QTest::newRow("one") << std::vector{12};
    QTest::newRow("two running") << std::vector{12, 13};
    QTest::newRow("every third") << std::vector{12, 15, 18};
}

/// 20 a minute from 1 s on, of which 22 are there to be heard.
void TestManikinRate::doesNotMindMissedBreaths()
{
    QFETCH(const std::vector<int>, missed);
    Listener listener;
    for (int i = 0; i < 22; ++i) {
        if (std::ranges::find(missed, i) != missed.end())
            continue;
        listener.hearAt(1.0 + 3.0 * i);
        QVERIFY(i < 2 || listener.clock.isLocked());
        if (i > 10) {
            VERIFY_WITHIN(inPerMinute(listener.clock.state().measured), 20.0, 0.05);
            VERIFY_WITHIN(listener.phaseErrorAt(1.0 + 3.0 * i), 0.0, 0.02);
        }
    }
}

void TestManikinRate::followsAManikinThatChangesItsRate_data()
{
    QTest::addColumn<double>("before_perMin");
    QTest::addColumn<double>("after_perMin");
    QTest::newRow("20 to 12") << 20.0 << 12.0;
    QTest::newRow("20 to 13") << 20.0 << 13.0;
    QTest::newRow("20 to 10, as if every other were missed") << 20.0 << 10.0;
    QTest::newRow("12 to 20") << 12.0 << 20.0;
}

/// In eight breaths, whatever they are multiples of.
void TestManikinRate::followsAManikinThatChangesItsRate()
{
    QFETCH(const double, before_perMin);
    QFETCH(const double, after_perMin);
    Listener listener;
    listener.hear(1.0, 60.0 / before_perMin, 10);
    const double period = 60.0 / after_perMin;
    const double from = 1.0 + 9.0 * 60.0 / before_perMin + period;
    listener.hear(from, period, 8);
    QVERIFY(listener.clock.isLocked());
    VERIFY_WITHIN(inPerMinute(listener.clock.state().measured) / after_perMin, 1.0, 0.01);
    VERIFY_WITHIN(listener.rate_perMin() / after_perMin, 1.0, 0.05);
    VERIFY_WITHIN(listener.phaseErrorAt(from + 7.0 * period), 0.0, 0.05);
}

/// Breaths of 1 to 1.77 s: no rate is measured that none of them has.
void TestManikinRate::staysWithAManikinThatBreathesIrregularly()
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> rate_perMin{34.0, 60.0};
    Listener listener;
    double t = 1.0;
    for (int i = 0; i < 400; ++i) {
        listener.hearAt(t);
        t += 60.0 / rate_perMin(random);
        const double measured = inPerMinute(listener.clock.state().measured);
        QVERIFY2(i == 0 || (measured > 33.9 && measured < 60.2),
                 qPrintable(QString::number(measured)));
    }
}

/// A clock that was set to 60 a minute slows down for seconds when it hears a manikin of 4 to 6.
void TestManikinRate::pullsByHalfABreathAtTheMost()
{
    for (const double rate_perMin : {4.1, 5.0, 6.0}) {
        BreathClock clock{perMinute(60.0)};
        const auto period = static_cast<int>(60.0 / rate_perMin / kClockStep);
        for (int i = 0; i < 4 * period; ++i) {
            clock.advance(perMinute(60.0), kClockStep);
            if (i % period == 77)
                clock.trigger(0.0);
            QVERIFY2(std::abs(clock.state().pull) <= 0.5,
                     qPrintable(QString::number(clock.state().pull)));
        }
        VERIFY_WITHIN(inPerMinute(clock.state().measured), rate_perMin, 0.01);
    }
}

CARINA_TEST(TestManikinRate)

} // namespace carina::manikin_rate_test

#include "tst_manikin_rate.moc"
