#include "engine/geometry/rotation.h"
#include "engine/tracking/pose_history.h"
#include "tests/support/test_class.h"

#include <numbers>

namespace carina::pose_history_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kTolerance = 1e-12; // m or rad: rounding of doubles of size one
constexpr double kPi = std::numbers::pi;
constexpr PoseHistory::Limits kLimits{.capacity = 8, .longestGap = 100ms, .horizon = 50ms};

SessionTime at(Duration t) { return SessionTime{t}; }

Quat aboutZ(double angle) { return rotationFromVector({0.0, 0.0, angle}); }

PoseSample sampleAt(Duration t, const Vec3& p_FO, const Quat& q_FO = Quat::Identity())
{
    return {.time = at(t), .X_FO = {q_FO, p_FO}};
}

PoseSample lostAt(Duration t, const Vec3& p_FO)
{
    PoseSample sample = sampleAt(t, p_FO);
    sample.validity = Validity::Lost;
    return sample;
}

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < kTolerance; }
bool near(const Quat& a, const Quat& b) { return angleBetween(a, b).si < kTolerance; }

} // namespace

/// What PoseHistory answers. The truth is arithmetic on motions at constant velocity.
class PoseHistoryTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsNothingBeforeTheOldestSample()
    {
        PoseHistory history{kLimits};
        QVERIFY(!history.at(at(0ms)));
        history.push(sampleAt(10ms, {1.0, 0.0, 0.0}));
        QVERIFY(!history.at(at(10ms - 1ns)));
        QVERIFY(history.at(at(10ms)));
    }

    /// Where its device stood elsewhere the object was elsewhere, too: nothing has moved in
    /// between.
    void forgetsWhatItStoredOnceItsDeviceIsPlacedAnew()
    {
        PoseHistory history{kLimits};
        const DevicePlace place{RigidTransform::translation({1.0, 0.0, 0.0}), 5ms};
        history.placeDevice(place);
        history.push(sampleAt(10ms, {0.0, 0.0, 0.0}));
        history.placeDevice(place); // as it is
        QVERIFY(history.newest().has_value());
        history.placeDevice({RigidTransform::translation({2.0, 0.0, 0.0}), 5ms});
        QVERIFY(!history.newest());
        history.push(sampleAt(20ms, {0.0, 0.0, 0.0}));
        QVERIFY(near(history.newest()->X_FO.translation(), {2.0, 0.0, 0.0}));
        QVERIFY(!history.newest()->motion);
    }

    void givesTheSampleOfItsTimeUnchanged()
    {
        PoseHistory history{kLimits};
        PoseSample sample = sampleAt(20ms, {0.1, 0.2, 0.3}, aboutZ(0.7));
        sample.motion = Motion{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
        sample.validity = Validity::PartlyOccluded;
        sample.error = 0.00025;
        history.push(sampleAt(0ms, {9.0, 9.0, 9.0}));
        history.push(sample);
        history.push(sampleAt(40ms, {9.0, 9.0, 9.0}));
        const PoseSample answer = history.at(at(20ms)).value();
        QCOMPARE(answer.time, sample.time);
        QCOMPARE(answer.X_FO.translation(), sample.X_FO.translation());
        QCOMPARE(answer.X_FO.rotation().coeffs(), sample.X_FO.rotation().coeffs());
        QCOMPARE(answer.motion->v_FO, Vec3(1.0, 2.0, 3.0));
        QCOMPARE(answer.motion->w_FO, Vec3(4.0, 5.0, 6.0));
        QCOMPARE(answer.validity, Validity::PartlyOccluded);
        QCOMPARE(answer.error, 0.00025);
        QCOMPARE(answer.how, How::Exact);
    }

    void interpolatesAlongALineAndAGreatCircle()
    {
        PoseHistory history{kLimits};
        history.push(sampleAt(0ms, {1.0, 0.0, -1.0}, aboutZ(0.2)));
        history.push(sampleAt(40ms, {3.0, 0.0, -2.0}, aboutZ(1.0)));
        const PoseSample answer = history.at(at(10ms)).value();
        QCOMPARE(answer.time, at(10ms));
        QVERIFY(near(answer.X_FO.translation(), {1.5, 0.0, -1.25}));
        QVERIFY(near(answer.X_FO.rotation(), aboutZ(0.4)));
        QVERIFY(near(answer.motion->v_FO, {50.0, 0.0, -25.0}));
        QVERIFY(near(answer.motion->w_FO, {0.0, 0.0, 20.0}));
        QCOMPARE(answer.validity, Validity::Tracked);
        QCOMPARE(answer.how, How::Interpolated);
    }

    void takesValidityAndErrorOfTheWorseNeighbour_data()
    {
        QTest::addColumn<int>("worse");
        QTest::newRow("the earlier is worse") << 0;
        QTest::newRow("the later is worse") << 1;
    }
    void takesValidityAndErrorOfTheWorseNeighbour()
    {
        QFETCH(int, worse);
        PoseHistory history{kLimits};
        for (int i = 0; i < 2; ++i) {
            PoseSample sample = sampleAt(i * 10ms, Vec3::Zero());
            sample.validity = i == worse ? Validity::PartlyOccluded : Validity::Tracked;
            sample.error = i == worse ? 0.003 : 0.001;
            history.push(sample);
        }
        QCOMPARE(history.at(at(5ms))->validity, Validity::PartlyOccluded);
        QCOMPARE(history.at(at(5ms))->error, 0.003);
    }

    void bridgesAGapUpToItsLimitAndNoLonger_data()
    {
        QTest::addColumn<qint64>("gap");
        QTest::addColumn<bool>("bridged");
        QTest::newRow("shorter") << qint64{99'999'999} << true;
        QTest::newRow("as long as the limit") << qint64{100'000'000} << true;
        QTest::newRow("a nanosecond longer") << qint64{100'000'001} << false;
    }
    void bridgesAGapUpToItsLimitAndNoLonger()
    {
        QFETCH(qint64, gap);
        QFETCH(bool, bridged);
        PoseHistory history{kLimits};
        history.push(sampleAt(0ms, {1.0, 0.0, 0.0}));
        history.push(sampleAt(Duration{gap}, {2.0, 0.0, 0.0}));
        const PoseSample answer = history.at(at(40ms)).value();
        QCOMPARE(answer.validity, bridged ? Validity::Tracked : Validity::Lost);
        QCOMPARE(answer.how, bridged ? How::Interpolated : How::Predicted);
        QCOMPARE(answer.X_FO.translation().x() > 1.0, bridged);
        QCOMPARE(answer.motion.has_value(), bridged);
    }

    void carriesOnByTheSourcesVelocity()
    {
        PoseHistory history{kLimits};
        history.push(sampleAt(0ms, {7.0, 7.0, 7.0})); // would give another velocity
        const Quat tilted = rotationFromVector({0.5 * kPi, 0.0, 0.0});
        PoseSample sample = sampleAt(10ms, {1.0, 2.0, 3.0}, tilted);
        sample.motion = Motion{{1.0, -2.0, 0.5}, {0.0, 0.0, 10.0}};
        sample.error = 0.0004;
        history.push(sample);
        const PoseSample answer = history.at(at(30ms)).value();
        QCOMPARE(answer.time, at(30ms));
        QVERIFY(near(answer.X_FO.translation(), {1.02, 1.96, 3.01}));
        QVERIFY(near(answer.X_FO.rotation(), aboutZ(0.2) * tilted)); // about the axis of F, not O
        QVERIFY(near(answer.motion->v_FO, {1.0, -2.0, 0.5}));
        QVERIFY(near(answer.motion->w_FO, {0.0, 0.0, 10.0}));
        QCOMPARE(answer.validity, Validity::Tracked);
        QCOMPARE(answer.error, 0.0004);
        QCOMPARE(answer.how, How::Predicted);
    }

    void carriesOnByTheDifferenceOfTheNewestTwo()
    {
        PoseHistory history{kLimits};
        const Quat tilted = rotationFromVector({0.0, 0.5 * kPi, 0.0});
        history.push(sampleAt(0ms, {5.0, 5.0, 5.0}));
        history.push(sampleAt(10ms, {1.0, 0.0, 0.0}, tilted));
        history.push(sampleAt(30ms, {1.0, 0.4, 0.0}, aboutZ(0.1) * tilted));
        const PoseSample answer = history.at(at(50ms)).value();
        QVERIFY(near(answer.X_FO.translation(), {1.0, 0.8, 0.0}));
        QVERIFY(near(answer.X_FO.rotation(), aboutZ(0.2) * tilted));
        QVERIFY(near(answer.motion->v_FO, {0.0, 20.0, 0.0}));
        QVERIFY(near(answer.motion->w_FO, {0.0, 0.0, 5.0}));
        QVERIFY(near(history.at(at(30ms))->motion->v_FO, {0.0, 20.0, 0.0}));
        QCOMPARE(history.at(at(30ms))->how, How::Exact);
    }

    void takesTheShorterWayRoundWhereSignsDiffer()
    {
        PoseHistory history{kLimits};
        history.push(sampleAt(0ms, Vec3::Zero(), aboutZ(kPi - 0.1)));
        history.push(sampleAt(10ms, Vec3::Zero(), aboutZ(kPi + 0.1)));
        QVERIFY(near(history.at(at(5ms))->X_FO.rotation(), aboutZ(kPi)));
        QVERIFY(near(history.at(at(20ms))->X_FO.rotation(), aboutZ(kPi + 0.3)));
    }

    void looksPastLostSamplesForAVelocity()
    {
        PoseHistory history{kLimits};
        history.push(sampleAt(0ms, {1.0, 0.0, 0.0}));
        history.push(lostAt(20ms, {1.0, 0.0, 0.0}));
        history.push(sampleAt(40ms, {1.4, 0.0, 0.0}));
        QVERIFY(near(history.at(at(50ms))->motion->v_FO, {10.0, 0.0, 0.0}));
    }

    void holdsThePoseWhereNoVelocityIsKnown_data()
    {
        QTest::addColumn<qint64>("earlier");
        QTest::addColumn<bool>("moves");
        QTest::newRow("a sample as far back as the longest gap") << qint64{100'000'000} << true;
        QTest::newRow("a sample a nanosecond further back") << qint64{99'999'999} << false;
    }
    void holdsThePoseWhereNoVelocityIsKnown()
    {
        QFETCH(qint64, earlier);
        QFETCH(bool, moves);
        PoseHistory history{kLimits};
        history.push(sampleAt(Duration{earlier}, {0.0, 0.0, 0.0}));
        history.push(sampleAt(200ms, {1.0, 0.0, 0.0}));
        const PoseSample answer = history.at(at(210ms)).value();
        QCOMPARE(answer.motion.has_value(), moves);
        QCOMPARE(answer.X_FO.translation().x() > 1.0, moves);
        QCOMPARE(answer.validity, Validity::Tracked);
        QCOMPARE(answer.how, How::Predicted);
    }

    void holdsTheOnlySample()
    {
        PoseHistory history{kLimits};
        history.push(sampleAt(0ms, {1.0, 2.0, 3.0}, aboutZ(0.3)));
        QVERIFY(!history.at(at(0ms))->motion);
        QVERIFY(!history.at(at(20ms))->motion);
        QCOMPARE(history.at(at(20ms))->X_FO.translation(), Vec3(1.0, 2.0, 3.0));
    }

    void predictsUpToTheHorizonAndStaysThere_data()
    {
        QTest::addColumn<qint64>("ahead");
        QTest::addColumn<Validity>("validity");
        QTest::addColumn<double>("x");
        QTest::newRow("a nanosecond on") << qint64{1} << Validity::Tracked << 1e-9;
        QTest::newRow("at the horizon") << qint64{50'000'000} << Validity::Tracked << 0.05;
        QTest::newRow("a nanosecond beyond") << qint64{50'000'001} << Validity::Lost << 0.05;
        QTest::newRow("far beyond") << qint64{9'000'000'000} << Validity::Lost << 0.05;
    }
    void predictsUpToTheHorizonAndStaysThere()
    {
        QFETCH(qint64, ahead);
        QFETCH(Validity, validity);
        QFETCH(double, x);
        PoseHistory history{kLimits};
        PoseSample sample = sampleAt(10ms, Vec3::Zero());
        sample.motion = Motion{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        history.push(sample);
        const PoseSample answer = history.at(at(10ms) + Duration{ahead}).value();
        QCOMPARE(answer.validity, validity);
        QCOMPARE(answer.how, How::Predicted);
        QCOMPARE(answer.motion.has_value(), validity == Validity::Tracked);
        QVERIFY(near(answer.X_FO.translation(), {x, 0.0, 0.0}));
    }

    void keepsTheLastPoseWhileLost()
    {
        PoseHistory history{kLimits};
        PoseSample seen = sampleAt(0ms, {1.0, 0.0, 0.0});
        seen.motion = Motion{{9.0, 9.0, 9.0}, {9.0, 9.0, 9.0}};
        PoseSample lost = lostAt(20ms, {1.0, 0.0, 0.0});
        lost.motion = seen.motion;
        history.push(seen);
        history.push(lost);
        history.push(sampleAt(40ms, {3.0, 0.0, 0.0}));
        for (const Duration t : {Duration{10ms}, Duration{20ms}, Duration{30ms}}) {
            const PoseSample answer = history.at(at(t)).value();
            QCOMPARE(answer.time, at(t));
            QCOMPARE(answer.validity, Validity::Lost);
            QCOMPARE(answer.X_FO.translation(), Vec3(1.0, 0.0, 0.0));
            QVERIFY(!answer.motion);
            QCOMPARE(answer.how, t == 20ms ? How::Exact : How::Predicted);
        }
        QCOMPARE(history.at(at(0ms))->validity, Validity::Tracked);
        QCOMPARE(history.at(at(40ms))->validity, Validity::Tracked);
    }

    /// Which markers and covariance a measured pose had says nothing of one that was not measured.
    void tellsMarkersAndCovarianceOfMeasuredPosesOnly()
    {
        PoseHistory history{kLimits};
        PoseSample sample = sampleAt(0ms, Vec3::Zero());
        sample.covariance_O = Mat6::Identity();
        sample.markers = MarkerSet{0b1011};
        for (const Duration t : {Duration{0ms}, Duration{20ms}}) {
            sample.time = at(t);
            history.push(sample);
        }
        QVERIFY(history.at(at(0ms))->markers == sample.markers);
        QVERIFY(history.newest()->markers == sample.markers);
        const auto isTold = [&history](Duration t) {
            const PoseSample answer = history.at(at(t)).value();
            return answer.markers || answer.covariance_O;
        };
        QVERIFY(!isTold(10ms) && !isTold(30ms));
        history.push(lostAt(40ms, Vec3::Zero()));
        QVERIFY(!isTold(30ms) && !isTold(45ms));
    }

    void predictsNothingFromALostSample()
    {
        PoseHistory history{kLimits};
        history.push(sampleAt(0ms, {1.0, 0.0, 0.0}));
        history.push(sampleAt(10ms, {2.0, 0.0, 0.0}));
        history.push(lostAt(20ms, {2.0, 0.0, 0.0}));
        QCOMPARE(history.at(at(25ms))->validity, Validity::Lost);
        QCOMPARE(history.at(at(25ms))->X_FO.translation(), Vec3(2.0, 0.0, 0.0));
    }
};

CARINA_TEST(PoseHistoryTest)

} // namespace carina::pose_history_test

#include "tst_pose_history.moc"
