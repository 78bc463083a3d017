#include "engine/geometry/fit/weighted_fit.h"
#include "engine/registration/error/target_error.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::touch_weights_test
{
namespace
{

constexpr int kRegistrations = 2000;
constexpr double kSamples = 60.0; // of a touch that is held for a second
// Noise of a sample, m: worst along the depth. Of a camera: the stylus in docs/tracking.md.
const Vec3 kInfraredTracker{0.1e-3, 0.1e-3, 0.3e-3};
const Vec3 kCamera{0.14e-3, 0.14e-3, 2.67e-3};
const Vec3 kTip_S{0.05e-3, 0.05e-3, 0.132e-3}; // m, of a calibration that was good enough to end
constexpr Angle kLean = degrees(30.0);         // of the stylus from touch to touch, RMS
constexpr double kFewPercent = 0.03;

/// What is known of each touch: the hand's error, alike for all; the tracker's, as the mean of a
/// touch has it; the tip's, turned as the stylus was held.
std::vector<Mat3> covariancesOf(test::Hand& hand, std::size_t count, Length fleOfHand,
                                const Vec3& noise)
{
    std::vector<Mat3> covariances;
    for (std::size_t i = 0; i < count; ++i) {
        const Mat3 R_AS =
            rotationFromVector(kLean.si / std::sqrt(3.0) * hand.unit()).toRotationMatrix();
        covariances.push_back(fleOfHand.si * fleOfHand.si / 3.0 * Mat3::Identity()
                              + test::ellipsoid(noise / std::sqrt(kSamples), Vec3::Zero())
                              + R_AS * test::ellipsoid(kTip_S, Vec3::Zero()) * R_AS.transpose());
    }
    return covariances;
}

struct Squares {
    double alike = 0.0;
    double weighted = 0.0;
};

} // namespace

/// Whether a fit gains by weighting each touch by the covariance that is known of it.
class TestTouchWeights : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// With a hand that strays by a millimetre all covariances are nearly that of the hand.
    void gainNothingWhereTheHandStraysMost_data()
    {
        QTest::addColumn<double>("hand_mm");
        QTest::addColumn<Vec3>("noise");
        QTest::newRow("hand 1 mm") << 1.0 << kInfraredTracker;
        QTest::newRow("hand 0.5 mm") << 0.5 << kInfraredTracker;
        QTest::newRow("hand 1 mm, camera") << 1.0 << kCamera;
        QTest::newRow("hand 0.5 mm, camera") << 0.5 << kCamera;
    }

    void gainNothingWhereTheHandStraysMost()
    {
        QFETCH(double, hand_mm);
        QFETCH(Vec3, noise);
        const std::vector<Vec3> p_A = test::firstLandmarks(8);
        test::Hand hand{191};
        std::array<Squares, test::kTargets.size()> squares;
        for (int i = 0; i < kRegistrations; ++i) {
            const auto covariances = covariancesOf(hand, p_A.size(), millimetres(hand_mm), noise);
            std::vector<UncertainPair> pairs;
            std::vector<LandmarkPair> plain;
            for (std::size_t k = 0; k < p_A.size(); ++k) {
                const LandmarkPair pair{p_A[k],
                                        p_A[k] + hand.error(test::factorOf(covariances[k]))};
                plain.push_back(pair);
                pairs.push_back({pair, covariances[k], Mat3::Zero()});
            }
            const auto alike = fitRigid(plain);
            const auto weighted = fitWeighted(pairs);
            QVERIFY(alike && weighted);
            for (std::size_t t = 0; t < squares.size(); ++t) {
                const Vec3& p = test::kTargets[t];
                squares[t].alike += (alike->X_AM * p - p).squaredNorm();
                squares[t].weighted += (weighted->fit.X_AM * p - p).squaredNorm();
            }
        }
        for (std::size_t t = 0; t < squares.size(); ++t) {
            const double gain = 1.0 - std::sqrt(squares[t].weighted / squares[t].alike);
            qInfo("%-15s %.3f mm RMS with equal weights, %.2f %% less with weights",
                  test::kTargetNames[t], 1e3 * std::sqrt(squares[t].alike / kRegistrations),
                  100.0 * gain);
            QVERIFY(std::abs(gain) < kFewPercent);
        }
    }
};

CARINA_TEST(TestTouchWeights)

} // namespace carina::touch_weights_test

#include "tst_touch_weights.moc"
