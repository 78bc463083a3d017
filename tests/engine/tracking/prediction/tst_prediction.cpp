#include "engine/tracking/prediction/prediction.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/pose_history.h"
#include "engine/tracking/prediction/motion_filter.h"
#include "engine/tracking/reframed.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <functional>
#include <random>

namespace carina::prediction_test
{
namespace
{

using namespace std::chrono_literals;

SessionTime at(double t) { return SessionTime{fromSeconds(t)}; }

/// A body that moves and turns with a constant jerk-free motion in F, to second order in t.
RigidTransform poseOf(const RigidTransform& start, const Motion& motion, double t)
{
    const Vec3 turn = t * motion.w_FO + t * t / 2.0 * motion.alpha_FO;
    return {rotationFromVector(turn) * start.rotation(),
            start.translation() + t * motion.v_FO + t * t / 2.0 * motion.a_FO};
}

/// Velocity and acceleration of a motion by differences.
Motion differences(const std::function<RigidTransform(double)>& pose)
{
    constexpr double h = 1e-3;
    const auto turn = [&](double t) {
        return rotationVector(pose(t).rotation() * pose(0.0).rotation().conjugate());
    };
    const auto way = [&](double t) { return pose(t).translation(); };
    return {(way(h) - way(-h)) / (2.0 * h), (turn(h) - turn(-h)) / (2.0 * h),
            (way(h) - 2.0 * way(0.0) + way(-h)) / (h * h),
            (turn(h) - 2.0 * turn(0.0) + turn(-h)) / (h * h)};
}

void compare(const Motion& motion, const Motion& expected)
{
    QVERIFY((motion.v_FO - expected.v_FO).norm() < 1e-5);
    QVERIFY((motion.w_FO - expected.w_FO).norm() < 1e-5);
    QVERIFY((motion.a_FO - expected.a_FO).norm() < 1e-4);
    QVERIFY((motion.alpha_FO - expected.alpha_FO).norm() < 1e-4);
}

const Motion kOfO{{0.1, -0.3, 0.2}, {0.5, 0.2, -0.7}, {1.0, 0.5, -2.0}, {0.3, -1.0, 0.4}};
const Motion kOfJ{{-0.2, 0.1, 0.1}, {-0.4, 0.6, 0.2}, {0.3, -0.5, 1.0}, {0.9, 0.2, -0.6}};
const RigidTransform kX_FO{rotationFromVector({0.3, -0.2, 0.9}), Vec3{0.1, 0.2, -1.0}};
const RigidTransform kX_FJ{rotationFromVector({-0.7, 0.1, 0.2}), Vec3{-0.1, 0.1, -0.9}};

PoseSample moving(const RigidTransform& X_FO, const Motion& motion)
{
    return {.time = at(0.0), .X_FO = X_FO, .motion = motion};
}

} // namespace

class TestPrediction : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void movesByVelocityAndAcceleration()
    {
        PoseHistory history;
        history.push(moving(kX_FO, kOfO));
        const auto ahead = history.at(at(0.08));
        const RigidTransform expected = poseOf(kX_FO, kOfO, 0.08);
        QCOMPARE(ahead->how, How::Predicted);
        QVERIFY((ahead->X_FO.translation() - expected.translation()).norm() < 1e-12);
        QVERIFY(angleBetween(ahead->X_FO.rotation(), expected.rotation()).si < 1e-9);
        QVERIFY((ahead->motion->v_FO - (kOfO.v_FO + 0.08 * kOfO.a_FO)).norm() < 1e-12);
    }

    void stopsToAccelerateAfterATenthOfASecond()
    {
        Motion motion = kOfO;
        const RigidTransform at150 = movedOn(kX_FO, motion, 0.15);
        const Vec3 at100 = poseOf(kX_FO, kOfO, 0.1).translation();
        QVERIFY((motion.v_FO - (kOfO.v_FO + 0.1 * kOfO.a_FO)).norm() < 1e-12);
        QVERIFY((at150.translation() - (at100 + 0.05 * motion.v_FO)).norm() < 1e-12);
        QCOMPARE(motion.a_FO.norm(), 0.0);
    }

    void holdsThePoseThatIsDrawnWhereAPersonWantsItSo()
    {
        PoseHistory history;
        history.push(moving(kX_FO, kOfO));
        history.treat({.predicts = false});
        const auto shift = [&](const PoseSample& pose) {
            return (pose.X_FO.translation() - kX_FO.translation()).norm();
        };
        QCOMPARE(shift(*history.shownAt(at(0.08))), 0.0);
        QCOMPARE(history.shownAt(at(0.08))->how, How::Predicted);
        QVERIFY(shift(*history.at(at(0.08))) > 0.01); // what is measured with is not held
        history.treat({.predicts = true});
        QVERIFY(shift(*history.shownAt(at(0.08))) > 0.01);
    }

    void smoothsWhatIsDrawnAndNothingThatIsStored()
    {
        PoseHistory history;
        history.treat({.smooths = true});
        history.push({.time = at(0.0)});
        history.push({.time = at(0.01), .X_FO = RigidTransform::translation({0.001, 0, 0})});
        const auto x = [](const std::optional<PoseSample>& pose) {
            return pose->X_FO.translation().x();
        };
        QVERIFY(x(history.shownAt(at(0.01))) < 0.0005);
        QVERIFY(x(history.shownAt(at(0.005))) < 0.00025);
        QCOMPARE(x(history.at(at(0.01))), 0.001);
        QCOMPARE(x(history.newest()), 0.001);
        QCOMPARE(x(history.samples()[1]), 0.001);
        history.treat({}); // also of what came before
        QCOMPARE(x(history.shownAt(at(0.01))), 0.001);
    }

    /// The variance of a constant velocity that is uncertain by 0.1 m/s per axis is (0.1 t)^2.
    void growsLessSureWithTheTimeAhead()
    {
        Motion motion = kOfO;
        motion.a_FO = motion.alpha_FO = Vec3::Zero();
        motion.growth = ErrorGrowth{.position = {0.0, 0.0, 0.01}, .rotation = {1e-6}};
        PoseHistory history;
        history.push(moving(kX_FO, motion));
        for (const double ahead : {0.02, 0.04, 0.08, 0.15, 0.5}) { // the last beyond the horizon
            const double stays = motion.v_FO.norm() * std::max(0.0, ahead - 0.15);
            const auto expected = std::hypot(std::sqrt(3.0) * 0.1 * ahead, stays);
            const auto pose = history.at(at(ahead));
            QVERIFY(std::abs(pose->deviation->position.si - expected) < 1e-9);
        }
        // One that is held is also off by the way.
        history.treat({.predicts = false});
        const double held = history.shownAt(at(0.05))->deviation->position.si;
        const double way = 0.05 * motion.v_FO.norm();
        QVERIFY(std::abs(held - std::hypot(std::sqrt(3.0) * 0.005, way)) < 1e-9);
    }

    void carriesAccelerationOverToOtherFrames()
    {
        const RigidTransform X_OP{rotationFromVector({0.0, 0.4, 0.1}), Vec3{0.02, -0.1, 0.3}};
        compare(*attached(moving(kX_FO, kOfO), X_OP).motion,
                differences([&](double t) { return poseOf(kX_FO, kOfO, t) * X_OP; }));
        compare(*reframed(kX_FJ, moving(kX_FO, kOfO)).motion,
                differences([&](double t) { return kX_FJ * poseOf(kX_FO, kOfO, t); }));
        compare(*seenFrom(moving(kX_FJ, kOfJ), moving(kX_FO, kOfO)).motion,
                differences([&](double t) {
                    return poseOf(kX_FJ, kOfJ, t).inverse() * poseOf(kX_FO, kOfO, t);
                }));
    }

    /// White jerk and white noise of the filter's own figures: the truth is the random walk itself.
    void tellsHowFarItWillBeOff()
    {
        const MotionFilter::Noise noise{
            .rotation = {.measurement = 1e-3, .jerk = 5.0, .rate = 1.0, .acceleration = 1.0},
            .position = {.measurement = 0.2e-3, .jerk = 1.0, .rate = 0.5, .acceleration = 1.0}};
        std::mt19937 random{17};
        std::normal_distribution<double> part;
        const auto unit = [&] { return Vec3{part(random), part(random), part(random)}; };
        constexpr double kDt = 1.0 / 60.0;
        constexpr int kFine = 20; // steps of the truth in a sample
        Vec3 p = Vec3::Zero();
        Vec3 v = Vec3::Zero();
        Vec3 a = Vec3::Zero();
        MotionFilter filter{noise};
        std::vector<std::pair<Vec3, double>> expected; // predicted by 3 samples, and its RMS
        double squares = 0.0;
        double predicted = 0.0;
        int count = 0;
        constexpr int kAhead = 3;
        for (int i = 0; i < 20'000; ++i) {
            for (int fine = 0; fine < kFine; ++fine) {
                const double h = kDt / kFine;
                p += h * v + h * h / 2.0 * a;
                v += h * a;
                a += noise.position.jerk * std::sqrt(h) * unit();
            }
            if (expected.size() >= kAhead && i > 100) {
                const auto& [place, rms] = expected[expected.size() - kAhead];
                squares += (place - p).squaredNorm();
                predicted += rms * rms;
                ++count;
            }
            filter.add(
                {.time = at(kDt * (i + 1)),
                 .X_FO = RigidTransform::translation(p + noise.position.measurement * unit())});
            if (!filter.motion())
                continue;
            const double ahead = kAhead * kDt;
            Motion motion = *filter.motion();
            const double rms = ErrorGrowth::rmsAfter(ahead, motion.growth->position);
            expected.emplace_back(movedOn(filter.pose(), motion, ahead).translation(), rms);
        }
        QVERIFY(count > 10'000);
        const double ratio = std::sqrt(squares / predicted);
        QVERIFY2(std::abs(ratio - 1.0) < 0.03, QByteArray::number(ratio).constData());
    }

    void comparesWithWhatWasMeasuredLater()
    {
        // At constant speed a prediction is right, and holding is off by the way.
        const auto effect = [](int lost, Duration within) {
            PoseHistory history;
            for (int i = 0; i < 60; ++i)
                history.push({.time = at(i / 60.0),
                              .X_FO = RigidTransform::translation({0.2 * i / 60.0, 0.0, 0.0}),
                              .motion = Motion{.v_FO = {0.2, 0.0, 0.0}},
                              .validity = i == lost ? Validity::Lost : Validity::Tracked});
            return history.effect(40ms, within);
        };
        const PredictionEffect whole = effect(-1, 2s);
        QVERIFY(std::abs(whole.held.position - 0.008) < 1e-9);
        QVERIFY(whole.predicted.position < 1e-9);
        QCOMPARE(whole.held.poses, std::size_t{57});
        // The lost one itself, and the three whose later pose lies beside it.
        QCOMPARE(effect(30, 2s).held.poses, std::size_t{54});
        QCOMPARE(effect(-1, 500ms).held.poses, std::size_t{28});
    }
};

CARINA_TEST(TestPrediction)

} // namespace carina::prediction_test

#include "tst_prediction.moc"
