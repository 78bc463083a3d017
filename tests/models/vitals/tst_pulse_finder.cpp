#include "models/vitals/pulse_finder.h"
#include "models/vitals/rising_edge.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::pulse_finder_test
{
namespace
{

constexpr double kStep_s = 0.02;

/// Pulses found in a minute of a sine from 0 to `height`, after five seconds.
int pulsesIn(double perMinute, double height)
{
    PulseFinder finder;
    int found = 0;
    for (int i = 0; i < 3250; ++i) {
        const double turn = 2.0 * std::numbers::pi * perMinute / 60.0 * kStep_s * i;
        const bool begins = finder.take(0.5 * height * (1.0 - std::cos(turn)), kStep_s);
        found += begins && i >= 250 ? 1 : 0;
    }
    return found;
}

} // namespace

class TestPulseFinder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsEachPulseOnce_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("height");
        for (const double rate : {40.0, 75.0, 180.0})
            for (const double height : {1.0, 0.3, 0.08})
                QTest::addRow("%g per minute, %g high", rate, height) << rate << height;
    }

    void findsEachPulseOnce()
    {
        QFETCH(double, rate);
        QFETCH(double, height);
        const int found = pulsesIn(rate, height);
        QVERIFY2(std::abs(found - rate) <= 1.0, qPrintable(QString::number(found)));
    }

    void findsNoneInAFlatCurve() { QCOMPARE(pulsesIn(75.0, 0.04), 0); }

    void findsAPulseThatBecameFlatSuddenly()
    {
        PulseFinder finder;
        (void)finder.take(0.0, kStep_s);
        QVERIFY(finder.take(1.0, kStep_s));
        int found = 0;
        for (int i = 0; i < 500; ++i) // ten seconds at a tenth of the height
            found += finder.take(i % 40 < 20 ? 0.0 : 0.1, kStep_s) ? 1 : 0;
        QVERIFY2(found >= 3 && found <= 13, qPrintable(QString::number(found)));
    }

    void risesOncePerCrossing()
    {
        RisingEdge edge{1.0, 2.0};
        QVERIFY(!edge.take(3.0)); // it was not low before
        QVERIFY(!edge.take(1.5));
        QVERIFY(!edge.take(3.0));
        QVERIFY(!edge.take(0.5));
        QVERIFY(!edge.take(1.9));
        QVERIFY(edge.take(2.0));
        QVERIFY(!edge.take(2.5));
    }
};

CARINA_TEST(TestPulseFinder)

} // namespace carina::pulse_finder_test

#include "tst_pulse_finder.moc"
