#include "engine/tracking/several/frame_calibration.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <random>

namespace carina::frame_calibration_test
{
namespace
{

using namespace std::chrono_literals;

const RigidTransform kX_TD{rotationFromVector({0.4, -2.1, 0.7}), Vec3{1.2, -0.4, 2.1}};
const RigidTransform kX_OP{rotationFromVector({1.3, 0.2, -0.5}), Vec3{0.03, -0.08, 0.05}};
constexpr Duration kLate = 37ms;

/// A body in the first device's frame that a hand turns to and fro, and moves about.
RigidTransform handAt(double t, const Vec3& swing)
{
    return {rotationFromVector({swing.x() * std::sin(3.1 * t), swing.y() * std::sin(4.7 * t + 1.0),
                                swing.z() * std::sin(2.3 * t + 0.4)}),
            Vec3{0.2 * std::sin(0.9 * t), 0.15 * std::cos(1.4 * t), 1.5 + 0.1 * std::sin(t)}};
}

const Vec3 kAllAxes{0.5, 0.3, 0.4};

struct Noise {
    double position = 0.0; ///< of each coordinate, m
    double turn = 0.0;     ///< about each axis, rad
};

PoseSample disturbed(SessionTime time, const RigidTransform& X, const Noise& noise,
                     std::mt19937& random)
{
    std::normal_distribution<double> normal;
    const auto some = [&](double size) {
        return Vec3{size * normal(random), size * normal(random), size * normal(random)};
    };
    const Vec3 turn = some(noise.turn);
    return {
        .time = time,
        .X_FO = {rotationFromVector(turn) * X.rotation(), X.translation() + some(noise.position)}};
}

struct Seen {
    std::vector<PoseSample> first;
    std::vector<PoseSample> second;
};

/// What a device of 60 Hz and one of 30 Hz, which stamps later, see of it.
Seen seen(const Noise& noise, const Vec3& swing = kAllAxes)
{
    std::mt19937 random{7};
    Seen both;
    for (int i = 0; i < 1200; ++i) {
        const double t = i / 60.0;
        both.first.push_back(
            disturbed(SessionTime{fromSeconds(t)}, handAt(t, swing), noise, random));
    }
    for (int i = 0; i < 600; ++i) {
        const double t = 0.004 + i / 30.0;
        both.second.push_back(disturbed(SessionTime{fromSeconds(t) + kLate},
                                        kX_TD.inverse() * handAt(t, swing) * kX_OP, noise, random));
    }
    return both;
}

double degreesBetween(const RigidTransform& a, const RigidTransform& b)
{
    return inDegrees(angleBetween(a.rotation(), b.rotation()));
}

/// How far a place that both see is off, about where the body was.
double millimetresOff(const RigidTransform& X_TD)
{
    const Vec3 p_D = kX_TD.inverse() * Vec3{0.0, 0.0, 1.5};
    return 1e3 * (X_TD * p_D - kX_TD * p_D).norm();
}

} // namespace

class TestFrameCalibration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Without noise and at the same moments the frames are exact: the equation has one solution.
    void isExactWithoutNoise()
    {
        std::vector<BodySeenTwice> pairs;
        for (int i = 0; i < 100; ++i) {
            const RigidTransform X_TO = handAt(0.2 * i, kAllAxes);
            pairs.push_back({X_TO, kX_TD.inverse() * X_TO * kX_OP});
        }
        const auto found = calibrateFrames(pairs);
        QVERIFY2(found, found ? "" : found.error().detail.c_str());
        QVERIFY((found->place.X_FD.matrix() - kX_TD.matrix()).cwiseAbs().maxCoeff() < 1e-9);
        QVERIFY((found->X_OP.matrix() - kX_OP.matrix()).cwiseAbs().maxCoeff() < 1e-9);
        QCOMPARE(found->outliers, 0U);
    }

    void findsFrameAndDelayOfTwoDevices()
    {
        const Seen both = seen({.position = 0.2e-3, .turn = 2e-3});
        const auto found = calibrateFrames(both.first, both.second);
        QVERIFY2(found, found ? "" : found.error().detail.c_str());
        constexpr double kWithin_ms = 1.0;
        QVERIFY(std::abs(1e3 * toSeconds(found->place.late - kLate)) < kWithin_ms);
        constexpr double kWithin_mm = 0.5;
        constexpr double kWithin_deg = 0.1;
        QVERIFY2(millimetresOff(found->place.X_FD) < kWithin_mm,
                 QByteArray::number(millimetresOff(found->place.X_FD)).constData());
        QVERIFY2(degreesBetween(found->place.X_FD, kX_TD) < kWithin_deg,
                 QByteArray::number(degreesBetween(found->place.X_FD, kX_TD)).constData());
        // Two devices with 2 mrad about each of three axes: sqrt(2 * 3) * 2 mrad, less between
        // samples, where two are averaged.
        QVERIFY(found->turn.si > 3e-3 && found->turn.si < 6e-3);
    }

    /// As of a mirrored pose of a flat marker.
    void leavesOutWhatIsFarOff()
    {
        std::vector<BodySeenTwice> pairs;
        for (int i = 0; i < 200; ++i) {
            const RigidTransform X_TO = handAt(0.1 * i, kAllAxes);
            pairs.push_back({X_TO, kX_TD.inverse() * X_TO * kX_OP});
            if (i % 20 == 3)
                pairs.back().X_DP =
                    pairs.back().X_DP * RigidTransform{rotationFromVector({0.6, 0.0, 0.0}), {}};
        }
        const auto found = calibrateFrames(pairs);
        QVERIFY2(found, found ? "" : found.error().detail.c_str());
        QCOMPARE(found->outliers, 10U);
        QVERIFY(degreesBetween(found->place.X_FD, kX_TD) < 1e-6);
    }

    void refusesABodyThatWasTurnedAboutOneAxisOnly()
    {
        const Seen both = seen({}, {0.5, 0.0, 0.0});
        const auto found = calibrateFrames(seenTwice(both.first, both.second, kLate));
        QVERIFY(!found);
        QCOMPARE(found.error().code, Errc::NotEnoughMotion);
    }

    void refusesTooFewMoments()
    {
        const std::vector<BodySeenTwice> pairs(kFewestSeenTwice - 1);
        const auto found = calibrateFrames(pairs);
        QVERIFY(!found);
        QCOMPARE(found.error().code, Errc::TooFewPoses);
    }

    /// A moment counts where both saw the body then, not where one of them is guessed.
    void takesOnlyMomentsAtWhichBothSawIt()
    {
        const Seen both = seen({});
        const std::size_t all = seenTwice(both.first, both.second, kLate).size();
        Seen holed = both;
        for (std::size_t i = 100; i < 130; ++i) // a second
            holed.second[i].validity = Validity::Lost;
        const std::size_t some = seenTwice(holed.first, holed.second, kLate).size();
        QVERIFY(all - some >= 60 && all - some <= 64);
    }
};

CARINA_TEST(TestFrameCalibration)

} // namespace carina::frame_calibration_test

#include "tst_frame_calibration.moc"
