#include "engine/sync/streams/stream_view.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

namespace carina::stream_view_test
{
namespace
{

using namespace std::chrono_literals;

constexpr SessionTime kTaken{50h};
constexpr double kTolerance = 1e-12;

/// At x (m) at kTaken + age, moving at 1 m/s along x and turning at 2 rad/s about z.
StreamCpo sampleOf(double x, Duration age, double turned = 0.0)
{
    StreamCpo sample;
    sample.time = kTaken + age;
    sample.X_AO = RigidTransform{rotationFromVector(Vec3{0.0, 0.0, turned}), Vec3{x, 0.0, 0.0}};
    sample.motion = StreamMotion{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, 2.0}};
    return sample;
}

double xOf(const RigidTransform& X_AO) { return X_AO.translation().x(); }
double turnOf(const RigidTransform& X_AO) { return rotationVector(X_AO.rotation()).z(); }
bool isNear(double a, double b) { return std::abs(a - b) <= kTolerance; }

} // namespace

class TestStreamView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void carriesOnFor150MillisecondsAndFadesOver100_data()
    {
        QTest::addColumn<int>("after_ms");
        QTest::addColumn<double>("carried_s");
        QTest::newRow("before its time") << -40 << 0.0;
        QTest::newRow("at its time") << 0 << 0.0;
        QTest::newRow("within the horizon") << 100 << 0.100;
        QTest::newRow("at the horizon") << 150 << 0.150;
        // The integral of 1 - s/0.1 to 0.05 is 0.05 - 0.0125; to 0.1 it is 0.05.
        QTest::newRow("half faded") << 200 << 0.150 + 0.0375;
        QTest::newRow("faded") << 250 << 0.200;
        QTest::newRow("long after") << 60000 << 0.200;
    }
    void carriesOnFor150MillisecondsAndFadesOver100()
    {
        QFETCH(int, after_ms);
        QFETCH(double, carried_s);
        StreamView view;
        view.take(sampleOf(0.5, 0ms), kTaken + 10ms);
        const RigidTransform drawn = view.at(kTaken + after_ms * 1ms);
        QVERIFY(isNear(xOf(drawn), 0.5 + carried_s));
        QVERIFY(isNear(turnOf(drawn), 2.0 * carried_s));
    }

    void staysWithoutAVelocity()
    {
        StreamCpo sample = sampleOf(0.5, 0ms);
        sample.motion.reset();
        QVERIFY(isNear(xOf(carriedOn(sample, kTaken + 100ms)), 0.5));
    }

    void worksOffTheDifferenceIn50Milliseconds()
    {
        // Drawn at 0.1 m and 0.2 rad; 30 mm and 0.1 rad further on than that says the next.
        StreamView view;
        view.take(sampleOf(0.0, 0ms), kTaken);
        const SessionTime drawn = kTaken + 100ms;
        view.take(sampleOf(0.110, 80ms, 0.26), drawn);
        QVERIFY(isNear(xOf(view.at(drawn)), 0.100));
        QVERIFY(isNear(turnOf(view.at(drawn)), 0.2));
        // Half of it is left in the middle: 0.155 - 0.015 and 0.35 - 0.05.
        QVERIFY(isNear(xOf(view.at(drawn + 25ms)), 0.140));
        QVERIFY(isNear(turnOf(view.at(drawn + 25ms)), 0.300));
        QVERIFY(isNear(xOf(view.at(drawn + 50ms)), 0.180));
        QVERIFY(isNear(turnOf(view.at(drawn + 50ms)), 0.400));
    }

    void velocityIsContinuousAtBothEndsOfABlend()
    {
        StreamView view;
        view.take(sampleOf(0.0, 0ms), kTaken);
        const SessionTime drawn = kTaken + 50ms;
        view.take(sampleOf(0.070, 50ms), drawn);
        const auto speed = [&](SessionTime t) {
            return (xOf(view.at(t + 10us)) - xOf(view.at(t))) / 10e-6;
        };
        QVERIFY(std::abs(speed(drawn) - 1.0) < 1e-3);
        QVERIFY(std::abs(speed(drawn + 50ms - 10us) - 1.0) < 1e-3);
        QVERIFY(speed(drawn + 25ms) > 1.5);
    }

    void smallCorrectionsAreMadeAtOnce_data()
    {
        QTest::addColumn<double>("shift_mm");
        QTest::addColumn<double>("turn_deg");
        QTest::addColumn<bool>("isAtOnce");
        QTest::newRow("0.09 mm") << 0.09 << 0.0 << true;
        QTest::newRow("0.11 mm") << 0.11 << 0.0 << false;
        QTest::newRow("0.09 deg") << 0.0 << 0.09 << true;
        QTest::newRow("0.11 deg") << 0.0 << 0.11 << false;
    }
    void smallCorrectionsAreMadeAtOnce()
    {
        QFETCH(double, shift_mm);
        QFETCH(double, turn_deg);
        QFETCH(bool, isAtOnce);
        StreamView view;
        view.take(sampleOf(0.0, 0ms), kTaken);
        const StreamCpo next = sampleOf(shift_mm * 1e-3, 0ms, degrees(turn_deg).si);
        view.take(next, kTaken);
        const RigidTransform drawn = view.at(kTaken);
        QCOMPARE(isNear(xOf(drawn), shift_mm * 1e-3) && isNear(turnOf(drawn), degrees(turn_deg).si),
                 isAtOnce);
    }

    void blendsOnFromWhereItIsWhenTheNextComes()
    {
        StreamView view;
        view.take(sampleOf(0.0, 0ms), kTaken);
        view.take(sampleOf(0.030, 0ms), kTaken);
        const double before = xOf(view.at(kTaken + 20ms));
        view.take(sampleOf(0.080, 20ms), kTaken + 20ms);
        QVERIFY(isNear(xOf(view.at(kTaken + 20ms)), before));
        QVERIFY(isNear(xOf(view.at(kTaken + 70ms)), 0.130));
    }

    void isStaleAfter300Milliseconds()
    {
        StreamView view;
        QVERIFY(view.isStale(kTaken));
        view.take(sampleOf(0.0, 0ms), kTaken + 40ms);
        QVERIFY(!view.isStale(kTaken + 300ms));
        QVERIFY(view.isStale(kTaken + 300ms + 1ns));
    }
};

CARINA_TEST(TestStreamView)

} // namespace carina::stream_view_test

#include "tst_stream_view.moc"
