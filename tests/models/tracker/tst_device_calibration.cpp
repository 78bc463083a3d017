#include "models/tracker/device_calibration.h"

#include "tests/models/tracker/two_trackers.h"
#include "tests/support/test_class.h"

namespace carina::device_calibration_test
{
namespace
{

using test::TwoTrackers;
using State = DeviceCalibration::State;

constexpr int kTube = 0;
constexpr int kOtherHand = 1;
constexpr int kStill = 2;
constexpr double kLongEnough_s = 31.0;
constexpr double kAWhile_s = 10.0;

/// What two devices see is collected to its end, or for as long.
struct Bench {
    TwoTrackers trackers;
    DeviceCalibration calibration{TwoTrackers::devices(), trackers.make()};

    void calibrate(int toolOfSecond = kTube, double seconds = kLongEnough_s)
    {
        calibration.begin(0, toolOfSecond);
        trackers.run(calibration, seconds);
    }
    [[nodiscard]] bool says(const char* words) const
    {
        return calibration.text().contains(QString::fromUtf8(words));
    }
};

} // namespace

/// Two simulated trackers, of which the test knows how they stand to each other.
class TestDeviceCalibration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheTrueFrameAndDelay()
    {
        Bench bench;
        QCOMPARE(bench.calibration.state(), State::Idle);
        bench.calibrate();
        QVERIFY2(bench.calibration.state() == State::Accepted,
                 qPrintable(bench.calibration.text()));
        const FrameCalibration& found = bench.calibration.found();
        constexpr double kWithin_ms = 1.0;
        QVERIFY(std::abs(1e3 * toSeconds(found.place.late - TwoTrackers::kLate)) < kWithin_ms);
        constexpr double kWithin_mm = 0.5;
        QVERIFY2(test::millimetresOff(found.place.X_FD) < kWithin_mm,
                 QByteArray::number(test::millimetresOff(found.place.X_FD)).constData());
        constexpr double kWithin_deg = 0.1;
        QVERIFY2(test::degreesOff(found.place.X_FD) < kWithin_deg,
                 QByteArray::number(test::degreesOff(found.place.X_FD)).constData());
        QVERIFY2(bench.says("ms later") && bench.says("mm and") && bench.says("° (RMS)"),
                 qPrintable(bench.calibration.text()));
        QCOMPARE(bench.trackers.inUse(), 0U); // they are free again
    }

    void tellsHowFarItWasTurnedAndMovedAndWhatIsMissing()
    {
        Bench bench;
        bench.trackers.swing = Vec3::Zero();
        bench.trackers.path = Vec3::Zero();
        bench.calibrate(kTube, 1.0);
        QVERIFY2(bench.says("Turn the body"), qPrintable(bench.calibration.text()));
        bench.trackers.swing = {0.5, 0.0, 0.0};
        bench.trackers.run(bench.calibration, kAWhile_s);
        QVERIFY2(bench.says("about other axes"), qPrintable(bench.calibration.text()));
        // A sine of 0.5 rad has an RMS of 20°, less while it was still.
        QVERIFY(bench.calibration.coverage()[0].isEnough);
        QVERIFY(!bench.calibration.coverage()[1].isEnough);
        bench.trackers.swing = {0.5, 0.4, 0.45};
        bench.trackers.run(bench.calibration, kAWhile_s);
        QVERIFY2(bench.says("Move it about"), qPrintable(bench.calibration.text()));
        QVERIFY(bench.calibration.coverage()[1].isEnough);
        QVERIFY(!bench.calibration.coverage()[3].isEnough);
        bench.trackers.path = {0.09, 0.07, 0.05};
        bench.trackers.run(bench.calibration, 0.8 * kAWhile_s);
        QVERIFY2(bench.says("moved enough"), qPrintable(bench.calibration.text()));
        QVERIFY(bench.calibration.share() > 0.9 && bench.calibration.share() < 1.0);
    }

    void refusesABodyThatWasTurnedAboutOneAxisOnly()
    {
        Bench bench;
        bench.trackers.swing = {0.5, 0.0, 0.0};
        bench.calibrate();
        QCOMPARE(bench.calibration.state(), State::Refused);
        QVERIFY2(bench.says("about one axis only"), qPrintable(bench.calibration.text()));
    }

    void refusesABodyThatWasNotTurned()
    {
        Bench bench;
        bench.trackers.swing = Vec3::Zero();
        bench.calibrate();
        QCOMPARE(bench.calibration.state(), State::Refused);
        QVERIFY2(bench.says("turned too little"), qPrintable(bench.calibration.text()));
    }

    void refusesAToolThatIsNotOnTheBody_data()
    {
        QTest::addColumn<int>("tool");
        QTest::addRow("one that lies still") << kStill;
        QTest::addRow("one that another hand turns") << kOtherHand;
    }
    void refusesAToolThatIsNotOnTheBody()
    {
        QFETCH(int, tool);
        Bench bench;
        bench.calibrate(tool);
        QCOMPARE(bench.calibration.state(), State::Refused);
        QVERIFY2(bench.says("not turned alike"), qPrintable(bench.calibration.text()));
        bench.calibrate(); // with the right one
        QCOMPARE(bench.calibration.state(), State::Accepted);
    }

    void refusesAToolThatSlipsOnTheBody()
    {
        Bench bench;
        bench.trackers.slip = 0.03;
        bench.calibrate();
        QCOMPARE(bench.calibration.state(), State::Refused);
        QVERIFY2(bench.says("Fix both tools"), qPrintable(bench.calibration.text()));
    }

    void waitsWhileOneDoesNotSeeTheBody()
    {
        Bench bench;
        bench.calibrate(kTube, kAWhile_s);
        bench.trackers.isHiddenFromSecond = true;
        bench.trackers.run(bench.calibration, 1.0);
        const double share = bench.calibration.share();
        QVERIFY2(bench.says("Not seen by: NDI tracker at second:1"),
                 qPrintable(bench.calibration.text()));
        bench.trackers.run(bench.calibration, kLongEnough_s);
        QCOMPARE(bench.calibration.share(), share);
        QCOMPARE(bench.calibration.state(), State::Watching);
        bench.trackers.isHiddenFromSecond = false;
        bench.trackers.run(bench.calibration, kLongEnough_s - kAWhile_s);
        QVERIFY2(bench.calibration.state() == State::Accepted,
                 qPrintable(bench.calibration.text()));
    }

    void givesTheDevicesFreeWhereItIsCancelled()
    {
        Bench bench;
        bench.calibrate(kTube, kAWhile_s);
        QCOMPARE(bench.trackers.inUse(), 2U);
        bench.calibration.cancel();
        QCOMPARE(bench.trackers.inUse(), 0U);
        QCOMPARE(bench.calibration.state(), State::Idle);
        QCOMPARE(bench.calibration.share(), 0.0);
        QVERIFY(bench.calibration.text().isEmpty());
    }

    void saysWhyADeviceCannotBeUsed()
    {
        DeviceCalibration calibration{
            TwoTrackers::devices(),
            [](const TrackerDescription& described) -> Result<std::unique_ptr<Tracker>> {
                return fail(Errc::WrongAddress, described.address);
            }};
        calibration.begin(0, 0);
        QCOMPARE(calibration.state(), State::Refused);
        QVERIFY2(calibration.text().contains(QStringLiteral("first:1")),
                 qPrintable(calibration.text()));
    }
};

CARINA_TEST(TestDeviceCalibration)

} // namespace carina::device_calibration_test

#include "tst_device_calibration.moc"
