#include "engine/registration/landmarks/dwell_detector.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>
#include <vector>

namespace carina::dwell_detector_test
{
namespace
{

constexpr double kExact = 1e-12; // m
constexpr Duration kPeriod = std::chrono::milliseconds{20};
const Vec3 kHere{0.1, -0.2, 0.3};

/// A tip seen every 20 ms: 50 samples stand for one second.
struct Stream {
    DwellDetector detector;
    SessionTime now{std::chrono::seconds{5}};
    std::vector<DwellPoint> points;

    void see(const Vec3& p_FQ, Validity validity = Validity::Tracked)
    {
        now += kPeriod;
        if (const auto point = detector.push(now, p_FQ, validity))
            points.push_back(*point);
    }
    void hold(const Vec3& p_FQ, int samples)
    {
        for (int i = 0; i < samples; ++i)
            see(p_FQ);
    }
};

} // namespace

class TestDwellDetector : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesAPointWithTheSampleThatCompletesASecond()
    {
        Stream stream;
        stream.hold(kHere, 49);
        QCOMPARE(stream.points.size(), 0U);
        stream.hold(kHere, 1);
        QCOMPARE(stream.points.size(), 1U);
        const DwellPoint& point = stream.points.front();
        QVERIFY((point.p_FQ - kHere).norm() < kExact);
        QVERIFY(point.spread < kExact);
        QCOMPARE(point.samples, 50);
        QCOMPARE(point.from.time_since_epoch(), Duration{std::chrono::milliseconds{5020}});
        QCOMPARE(point.until.time_since_epoch(), Duration{std::chrono::milliseconds{6000}});
    }

    void asksForASecondOfEveryTracker_data()
    {
        QTest::addColumn<int>("hertz");
        QTest::newRow("8 Hz") << 8;
        QTest::newRow("20 Hz") << 20;
        QTest::newRow("50 Hz") << 50;
        QTest::newRow("250 Hz") << 250;
    }

    void asksForASecondOfEveryTracker()
    {
        QFETCH(int, hertz);
        DwellDetector detector;
        for (int i = 1; i <= hertz; ++i) {
            const SessionTime time{Duration{std::chrono::seconds{1}} * i / hertz};
            QCOMPARE(detector.push(time, kHere, Validity::Tracked).has_value(), i == hertz);
        }
    }

    /// A place that was taken otherwise is not taken again before the tip was 5 mm away.
    void leavesAPlaceFirst()
    {
        Stream stream;
        stream.detector.leave(kHere);
        for (int i = 0; i < 200; ++i)
            stream.see(kHere + 4.9e-3 * Vec3::UnitX());
        QVERIFY(stream.points.empty());
        QCOMPARE(stream.detector.progress(), 0.0);
        stream.see(kHere + 5.1e-3 * Vec3::UnitX());
        for (int i = 0; i < 60; ++i)
            stream.see(kHere);
        QCOMPARE(stream.points.size(), 1U);
    }

    void givesTheMeanAndTheSpread()
    {
        Stream stream;
        for (int i = 0; i < 50; ++i) // 0.8 mm to either side
            stream.see(kHere + (i % 2 == 0 ? 0.8e-3 : -0.8e-3) * Vec3::UnitY());
        QCOMPARE(stream.points.size(), 1U);
        QVERIFY((stream.points[0].p_FQ - kHere).norm() < kExact);
        QVERIFY(std::abs(stream.points[0].spread - 0.8e-3) < kExact);
    }

    /// Alternating by 2 d about its mean: within a millimetre for d = 0.99, not for 1.01.
    void holdsToAMillimetreAboutTheMean_data()
    {
        QTest::addColumn<double>("sway_mm");
        QTest::addColumn<int>("points");
        QTest::newRow("just within") << 0.99 << 1;
        QTest::newRow("just beyond") << 1.01 << 0;
    }

    void holdsToAMillimetreAboutTheMean()
    {
        QFETCH(double, sway_mm);
        QFETCH(int, points);
        Stream stream;
        for (int i = 0; i < 500; ++i)
            stream.see(kHere + (i % 2 == 0 ? sway_mm : -sway_mm) * 1e-3 * Vec3::UnitX());
        QCOMPARE(int(stream.points.size()), points);
    }

    void takesNothingOfATipThatTravels()
    {
        Stream stream;
        for (int i = 0; i < 500; ++i) // 5 mm/s: 2.5 mm to either side in a second
            stream.see(kHere + i * 0.1e-3 * Vec3::UnitX());
        QVERIFY(stream.points.empty());
    }

    void leavesTheWayToAPointOut()
    {
        Stream stream;
        for (int i = 0; i < 25; ++i)
            stream.see(kHere + (25 - i) * 4e-3 * Vec3::UnitZ());
        stream.hold(kHere, 50);
        QCOMPARE(stream.points.size(), 1U);
        QVERIFY((stream.points[0].p_FQ - kHere).norm() < kExact);
    }

    void takesOneTouchOnce()
    {
        Stream stream;
        stream.hold(kHere, 500);
        stream.hold(kHere + 4.9e-3 * Vec3::UnitX(), 500);
        stream.hold(kHere, 500);
        QCOMPARE(stream.points.size(), 1U);
    }

    void takesTheNextPointOnceTheTipHasLeft()
    {
        Stream stream;
        stream.hold(kHere, 50);
        stream.hold(kHere + 5.1e-3 * Vec3::UnitX(), 49);
        QCOMPARE(stream.points.size(), 1U);
        stream.hold(kHere + 5.1e-3 * Vec3::UnitX(), 1);
        QCOMPARE(stream.points.size(), 2U);
        stream.hold(kHere, 50);
        QCOMPARE(stream.points.size(), 3U);
    }

    void leavesOutWhatIsNoPosition_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<Validity>("validity");
        QTest::newRow("lost") << 0.5 << Validity::Lost;
        QTest::newRow("no number") << std::numeric_limits<double>::quiet_NaN() << Validity::Tracked;
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << Validity::Tracked;
    }

    void leavesOutWhatIsNoPosition()
    {
        QFETCH(double, x);
        QFETCH(Validity, validity);
        Stream stream;
        stream.hold(kHere, 25);
        stream.see({x, 0.0, 0.0}, validity);
        stream.hold(kHere, 25);
        QCOMPARE(stream.points.size(), 1U);
        QCOMPARE(stream.points[0].samples, 49); // of the 50 periods
        QVERIFY((stream.points[0].p_FQ - kHere).norm() < kExact);
    }

    void takesAPartlyOccludedTip()
    {
        Stream stream;
        for (int i = 0; i < 50; ++i)
            stream.see(kHere, Validity::PartlyOccluded);
        QCOMPARE(stream.points.size(), 1U);
    }

    void leavesOutSamplesThatAreNotNewer()
    {
        Stream stream;
        stream.hold(kHere, 49);
        QVERIFY(!stream.detector.push(stream.now, kHere, Validity::Tracked));
        QVERIFY(!stream.detector.push(stream.now - kPeriod, kHere, Validity::Tracked));
        stream.hold(kHere, 1);
        QCOMPARE(stream.points.size(), 1U);
        QCOMPARE(stream.points[0].samples, 50);
    }

    void beginsAnewAfterAGap_data()
    {
        QTest::addColumn<int>("gap_ms");
        QTest::addColumn<int>("samples");
        QTest::newRow("bridged") << 200 << 41; // 40 samples cover 960 ms * 40 / 39
        QTest::newRow("too long") << 201 << 50;
    }

    void beginsAnewAfterAGap()
    {
        QFETCH(int, gap_ms);
        QFETCH(int, samples);
        Stream stream;
        stream.hold(kHere, 25);
        stream.now += std::chrono::milliseconds{gap_ms} - kPeriod;
        stream.hold(kHere, 50);
        QCOMPARE(stream.points.size(), 1U);
        QCOMPARE(stream.points[0].samples, samples);
    }

    void showsHowMuchOfTheHoldIsDone()
    {
        Stream stream;
        QCOMPARE(stream.detector.progress(), 0.0);
        stream.hold(kHere, 1);
        QCOMPARE(stream.detector.progress(), 0.0);
        stream.hold(kHere, 1);
        QCOMPARE(stream.detector.progress(), 0.04);
        stream.hold(kHere, 23);
        QCOMPARE(stream.detector.progress(), 0.5);
        stream.hold(kHere, 24);
        QCOMPARE(stream.detector.progress(), 0.98);
        stream.hold(kHere, 1);
        QCOMPARE(stream.detector.progress(), 0.0);
    }

    void showsTheHoldOfWhatIsStillOnly()
    {
        Stream stream;
        stream.hold(kHere, 30);
        stream.hold(kHere + 0.01 * Vec3::UnitX(), 20);
        QCOMPARE(stream.detector.progress(), 0.4);
        stream.hold(kHere + 0.01 * Vec3::UnitX(), 20);
        QCOMPARE(stream.detector.progress(), 0.8);
        Stream odd;
        odd.hold(kHere, 29);
        odd.hold(kHere + 0.01 * Vec3::UnitX(), 20);
        QCOMPARE(odd.detector.progress(), 0.4);
    }

    void keepsToOtherSettings()
    {
        Stream stream;
        stream.detector = DwellDetector{{.hold = std::chrono::milliseconds{500},
                                         .radius = millimetres(3.0),
                                         .leave = millimetres(20.0)}};
        for (int i = 0; i < 25; ++i)
            stream.see(kHere + (i % 2 == 0 ? 2.5e-3 : -2.5e-3) * Vec3::UnitY());
        QCOMPARE(stream.points.size(), 1U);
        stream.hold(kHere + 19e-3 * Vec3::UnitX(), 100);
        QCOMPARE(stream.points.size(), 1U);
    }
};

CARINA_TEST(TestDwellDetector)

} // namespace carina::dwell_detector_test

#include "tst_dwell_detector.moc"
