#include "engine/tracking/prediction/motion_predictor.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/pose_history.h"
#include "engine/tracking/tum_file.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <cmath>
#include <numbers>
#include <random>
#include <span>

namespace carina::motion_predictor_test
{
namespace
{

using namespace std::chrono_literals;

SessionTime at(double t) { return SessionTime{fromSeconds(t)}; }

/// A head that sways by 100 mm and turns by 0.3 rad, 0.5 times a second.
RigidTransform headAt(double t)
{
    const double phase = std::sin(2.0 * std::numbers::pi * 0.5 * t);
    return {rotationFromVector(0.3 * phase * Vec3{0.6, 0.0, 0.8}), 0.1 * phase * Vec3::UnitX()};
}

/// Errors, and what was expected of them, as mean squares of the position.
struct Found {
    double error = 0.0;
    double expected = 0.0;
};

/// Of the head predicted by 60 ms, from poses with a noise per axis, in the second of two halves.
Found foundWith(double noise)
{
    std::mt19937 random{23};
    std::normal_distribution<double> part{0.0, noise};
    PoseHistory history{{.estimates = true}};
    Found found;
    constexpr int kSamples = 3600;
    for (int i = 0; i < kSamples; ++i) {
        const double t = i / 60.0;
        RigidTransform X_FO = headAt(t);
        X_FO = RigidTransform{X_FO.rotation(),
                              X_FO.translation() + Vec3{part(random), part(random), part(random)}};
        history.push({.time = at(t), .X_FO = X_FO});
        if (i < kSamples / 2)
            continue;
        const auto shown = history.shownAt(at(t + 0.06));
        found.error += (shown->X_FO.translation() - headAt(t + 0.06).translation()).squaredNorm();
        found.expected += std::pow(shown->deviation->position.si, 2);
    }
    return {2.0 * found.error / kSamples, 2.0 * found.expected / kSamples};
}

/// Squares of the errors on the second half of a recording, where poses are drawn so much ahead.
PredictionError errorOn(std::span<const PoseSample> samples, Duration ahead,
                        const PoseTreatment& treatment)
{
    PoseHistory history{{.estimates = true}};
    history.treat(treatment);
    PredictionError error;
    for (std::size_t i = 0; i + 12 < samples.size(); ++i) {
        history.push(samples[i]);
        std::size_t after = i + 1;
        while (samples[after].time < samples[i].time + ahead && after < i + 12)
            ++after;
        const PoseSample& before = samples[after - 1];
        const double share = toSeconds(samples[i].time + ahead - before.time)
                             / toSeconds(samples[after].time - before.time);
        if (i >= samples.size() / 2 && share <= 1.0)
            error.add(history.shownAt(samples[i].time + ahead)->X_FO,
                      interpolate(before.X_FO, samples[after].X_FO, share));
    }
    return error.root();
}

} // namespace

/// What is drawn of a tracked tool, by the estimates in its PoseHistory.
class TestMotionPredictor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void learnsTheNoiseOfATracker_data()
    {
        QTest::addColumn<double>("noise");
        QTest::newRow("a tenth of a millimetre") << 0.1e-3;
        QTest::newRow("a millimetre") << 1e-3;
        QTest::newRow("four millimetres") << 4e-3;
    }
    void learnsTheNoiseOfATracker()
    {
        QFETCH(double, noise);
        const Found found = foundWith(noise);
        // As a parabola of least squares through six poses: their weights 60 ms ahead have the
        // root of squares 5.81, and it misses this motion without noise by 0.47 mm at most.
        QVERIFY2(std::sqrt(found.error) < std::hypot(std::sqrt(3.0) * 5.81 * noise, 0.47e-3),
                 QByteArray::number(std::sqrt(found.error)).constData());
        const double ratio = std::sqrt(found.expected / found.error);
        QVERIFY2(ratio > 0.8 && ratio < 2.0, QByteArray::number(ratio).constData());
    }

    void estimatesNothingBeforeThreeSamplesAndAfterAGap()
    {
        MotionPredictor predictor;
        predictor.add({.time = at(0.00)});
        predictor.add({.time = at(0.02)});
        QVERIFY(!predictor.estimate());
        predictor.add({.time = at(0.04)});
        QVERIFY(predictor.estimate());
        predictor.add({.time = at(0.04), .X_FO = RigidTransform::translation({1.0, 0.0, 0.0})});
        predictor.add({.time = at(0.05),
                       .X_FO = RigidTransform::translation({1.0, 0.0, 0.0}),
                       .validity = Validity::Lost});
        QCOMPARE(predictor.estimate()->motion.v_FO.norm(), 0.0);
        predictor.add({.time = at(0.20)});
        QVERIFY(!predictor.estimate());
    }

    void predictsARecordedHead_data()
    {
        QTest::addColumn<qint64>("ahead_ms");
        QTest::addColumn<double>("most");
        QTest::newRow("40 ms") << qint64{40} << 0.32;
        QTest::newRow("80 ms") << qint64{80} << 0.27;
    }
    void predictsARecordedHead()
    {
        QFETCH(qint64, ahead_ms);
        QFETCH(double, most);
        const auto file = test::testData("head-motion/traj1_quest2_to_tool1_cut.txt");
        if (!file)
            QSKIP("head-motion/traj1_quest2_to_tool1_cut.txt is not there");
        const auto samples = readTumFile(*file);
        QVERIFY(samples);
        const Duration ahead = std::chrono::milliseconds{ahead_ms};
        const PredictionError shown = errorOn(*samples, ahead, {});
        const PredictionError held = errorOn(*samples, ahead, {.predicts = false});
        QVERIFY(shown.position < most * held.position);
        QVERIFY(shown.rotation < most * held.rotation);
    }
};

CARINA_TEST(TestMotionPredictor)

} // namespace carina::motion_predictor_test

#include "tst_motion_predictor.moc"
