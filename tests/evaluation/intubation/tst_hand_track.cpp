#include "evaluation/intubation/hand_track.h"

#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::hand_track_test
{
namespace
{

constexpr double kExact = 1e-12;

/// Derivatives by central differences.
double speedAt(const HandTrack& track, double t, double dt = 1e-5)
{
    return (track.at(t + dt) - track.at(t - dt)) / (2.0 * dt);
}
double accelerationAt(const HandTrack& track, double t, double dt = 1e-4)
{
    return (track.at(t + dt) - 2.0 * track.at(t) + track.at(t - dt)) / (dt * dt);
}

} // namespace

class TestHandTrack : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The greatest speed is 1.875 times the mean one (Flash and Hogan 1985), half way.
    void movesWithLeastJerk()
    {
        HandTrack track{1.0};
        track.waitUntil(2.0);
        track.moveTo(5.0, 4.0);
        QCOMPARE(track.at(0.0), 1.0);
        QCOMPARE(track.at(2.0), 1.0);
        QCOMPARE(track.at(6.0), 5.0);
        QCOMPARE(track.at(9.0), 5.0);
        QVERIFY(std::abs(track.at(4.0) - 3.0) < kExact);
        QVERIFY(std::abs(speedAt(track, 4.0) - 1.875) < 1e-6);
        for (double t = 2.0; t <= 6.0; t += 0.1)
            QVERIFY(speedAt(track, t) < 1.875 + 1e-6);
    }

    void isAtRestWhereMovementsMeet()
    {
        HandTrack track{0.0};
        track.moveTo(0.1, 1.0);
        track.moveTo(-0.2, 0.5);
        track.waitUntil(3.0);
        track.moveTo(0.0, 2.0);
        for (const double t : {0.0, 1.0, 1.5, 3.0, 5.0}) {
            QVERIFY(std::abs(speedAt(track, t)) < 1e-6);
            // Third derivatives of 60 way / time^3 there.
            QVERIFY(std::abs(accelerationAt(track, t)) < 1e-4 * 60.0 * 0.3 / 0.125);
        }
        QCOMPARE(track.last(), 0.0);
        QCOMPARE(track.end(), 5.0);
    }

    void tremblesAsMuchAsItIsTold()
    {
        std::mt19937 random{5};
        const HandTremor fast{0.3e-3, 0.0, random};
        const HandTremor slow{0.0, 0.5e-3, random};
        Vec3 fastSquares = Vec3::Zero();
        Vec3 slowSquares = Vec3::Zero();
        constexpr int kSamples = 60000;
        double greatestStep = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const double t = 0.01 * i + 1e-3;
            fastSquares += fast.at(t).cwiseAbs2();
            slowSquares += slow.at(t).cwiseAbs2();
            greatestStep = std::max(greatestStep, (slow.at(t + 0.01) - slow.at(t)).norm());
        }
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(std::abs(std::sqrt(fastSquares[axis] / kSamples) - 0.3e-3) < 0.03e-3);
            QVERIFY(std::abs(std::sqrt(slowSquares[axis] / kSamples) - 0.5e-3) < 0.05e-3);
        }
        // Two sines of 0.7 Hz at most along each of three axes.
        QVERIFY(greatestStep < std::sqrt(3.0) * 2.0 * 0.5e-3 * 2.0 * 3.1416 * 0.7 * 0.01);
        QCOMPARE(HandTremor{}.at(1.0).norm(), 0.0);
    }

    void drawsEvenAndNormalNumbers()
    {
        std::mt19937 random{1};
        double even = 0.0;
        double normal = 0.0;
        double squares = 0.0;
        constexpr int kDraws = 40000;
        for (int i = 0; i < kDraws; ++i) {
            const double u = evenBetween(2.0, 4.0, random);
            QVERIFY(u >= 2.0 && u < 4.0);
            even += u / kDraws;
            const double x = normalOf(random);
            normal += x / kDraws;
            squares += x * x / kDraws;
        }
        QVERIFY(std::abs(even - 3.0) < 0.02);
        QVERIFY(std::abs(normal) < 0.02);
        QVERIFY(std::abs(squares - 1.0) < 0.03);
    }
};

CARINA_TEST(TestHandTrack)

} // namespace carina::hand_track_test

#include "tst_hand_track.moc"
