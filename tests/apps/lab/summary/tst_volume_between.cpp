#include "apps/lab/summary/volume_between.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace carina::volume_between_test
{

using carina::lab::Sameness;
using carina::lab::volumesBetween;

namespace
{

using namespace std::chrono_literals;

constexpr double kTidal_ml = 400.0;
constexpr double kPeriod_s = 3.0;
/// Of a cubic between frames of 20 Hz: (3/128) h^4 of the largest fourth derivative, rounded up.
constexpr double kCubic_ml = 0.001 * kTidal_ml * 0.01;

double volumeAt(double t_s)
{
    return 1000.0 + 0.5 * kTidal_ml * (1.0 - std::cos(2.0 * std::numbers::pi * t_s / kPeriod_s));
}

/// A minute of frames every 50 ms from `start`; session time is `behind` the instant by which it is
/// `late`, and the right lung has a third of the gas.
std::vector<LoggedFrame> breathing(Duration start, Duration late = {})
{
    std::vector<LoggedFrame> frames;
    for (Duration local = start; local < 60s; local += 50ms) {
        LoggedFrame frame;
        frame.local = LocalTime{local};
        frame.session = SessionTime{local - late + 100h};
        const double volume_ml = volumeAt(toSeconds(local - late));
        frame.volume_ml = {volume_ml / 3.0, volume_ml * 2.0 / 3.0};
        frames.push_back(frame);
    }
    return frames;
}

} // namespace

class TestVolumeBetween : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneBreathDrawnTwiceIsTheSame()
    {
        for (const Sameness same : {Sameness::SessionTime, Sameness::Instant}) {
            const auto apart = volumesBetween(breathing(0s), breathing(17ms), same);
            QVERIFY(apart.instants > 1100);
            QVERIFY(apart.largest_ml < kCubic_ml);
        }
    }

    void aClockThatIsLateShowsAtTheSameInstantOnly()
    {
        const auto owner = breathing(0s);
        const auto viewer = breathing(17ms, 10ms);
        const auto session = volumesBetween(owner, viewer, Sameness::SessionTime);
        QVERIFY(session.largest_ml < kCubic_ml);
        // The steepest of the curve is pi/T times its height, 10 ms of it.
        const auto instant = volumesBetween(owner, viewer, Sameness::Instant);
        const double steepest_ml = std::numbers::pi / kPeriod_s * kTidal_ml * 0.010;
        QVERIFY(std::abs(instant.largest_ml - steepest_ml) < 0.01 * steepest_ml);
        QVERIFY(std::abs(instant.mean_ml - 2.0 / std::numbers::pi * steepest_ml)
                < 0.01 * steepest_ml);
        QVERIFY(instant.p95_ml > instant.mean_ml && instant.p95_ml < instant.largest_ml);
    }

    void anOffsetIsSeenInFull()
    {
        auto viewer = breathing(17ms);
        for (LoggedFrame& frame : viewer)
            frame.volume_ml[0] -= 5.0;
        const auto apart = volumesBetween(breathing(0s), viewer, Sameness::SessionTime);
        QVERIFY(std::abs(apart.mean_ml - 5.0) < kCubic_ml);
        QVERIFY(std::abs(apart.largest_ml - 5.0) < kCubic_ml);
    }

    void comparesOnlyWhereBothWereDrawing_data()
    {
        QTest::addColumn<qint64>("gap_ms"); // between the owner's second and third frame
        QTest::addColumn<int>("instants");
        QTest::newRow("no gap") << qint64{50} << 1;
        QTest::newRow("the longest") << qint64{200} << 1;
        QTest::newRow("too long") << qint64{201} << 0;
    }

    void comparesOnlyWhereBothWereDrawing()
    {
        QFETCH(const qint64, gap_ms);
        QFETCH(const int, instants);
        std::vector<LoggedFrame> owner(4);
        Duration at{};
        for (std::size_t i = 0; i < owner.size(); ++i) {
            at += i == 2 ? Duration{gap_ms * 1ms} : Duration{50ms};
            owner[i].session = SessionTime{at};
        }
        std::vector<LoggedFrame> viewer(3);
        viewer[0].session = SessionTime{60ms};  // before its second frame
        viewer[1].session = SessionTime{100ms}; // with it
        viewer[2].session = owner[2].session;   // with its third
        QCOMPARE(volumesBetween(owner, viewer, Sameness::SessionTime).instants, instants);
    }

    void nothingDrawnIsNothingCompared()
    {
        const auto apart = volumesBetween({}, breathing(0s), Sameness::Instant);
        QCOMPARE(apart.instants, 0);
        QCOMPARE(apart.mean_ml, 0.0);
        QCOMPARE(apart.largest_ml, 0.0);
    }

    void framesOfOneTimeCountOnce()
    {
        auto owner = breathing(0s);
        owner.insert(owner.begin() + 600, 3, owner[600]);
        const auto apart = volumesBetween(owner, breathing(17ms), Sameness::SessionTime);
        QVERIFY(apart.instants > 1100);
        QVERIFY(apart.largest_ml < kCubic_ml);
    }
};

CARINA_TEST(TestVolumeBetween)

} // namespace carina::volume_between_test

#include "tst_volume_between.moc"
