#include "engine/registration/fit/manikin_fit.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <limits>
#include <random>

namespace carina::manikin_fit_test
{
namespace
{

constexpr double kExact = 1e-12; // m, and as coefficients of a rotation

const std::vector<Vec3> kRibCage_A{
    {0.0, -0.057, 0.034}, {0.0, -0.124, -0.124}, {0.076, -0.116, -0.105}, {-0.076, -0.116, -0.105}};

std::vector<TouchedLandmark> touchedAt(const RigidTransform& X_TA, const std::vector<Vec3>& slips_T)
{
    std::vector<TouchedLandmark> landmarks;
    for (std::size_t i = 0; i < kRibCage_A.size(); ++i)
        landmarks.push_back(
            {.p_AQ = kRibCage_A[i],
             .p_TQ = X_TA * kRibCage_A[i] + (slips_T.empty() ? Vec3{Vec3::Zero()} : slips_T[i])});
    return landmarks;
}

} // namespace

class TestManikinFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheTrackerInTheAnatomy()
    {
        std::mt19937 random{7};
        std::normal_distribution<double> part;
        for (int i = 0; i < 50; ++i) {
            const RigidTransform X_TA{Quat{part(random), part(random), part(random), part(random)},
                                      {part(random), part(random), part(random)}};
            const auto fitted = fitManikin(touchedAt(X_TA, {}));
            QVERIFY(fitted.has_value());
            QVERIFY((fitted->X_AT() * X_TA).matrix().isApprox(Mat4::Identity(), kExact));
            QVERIFY(fitted->fit.rms < kExact);
            QCOMPARE(fitted->fit.residuals.size(), std::size_t{4});
        }
    }

    /// Its frame lies at the mean of what was touched: sternum along z.
    void laysTheManikinsFrameIntoTheTouchedPoints()
    {
        const auto fitted = fitManikin(touchedAt({}, {}));
        const Vec3 mean = 0.25 * (kRibCage_A[0] + kRibCage_A[1] + kRibCage_A[2] + kRibCage_A[3]);
        QVERIFY((fitted->X_TM.translation() - mean).norm() < kExact);
        const Vec3 sternum = (kRibCage_A[0] - kRibCage_A[1]).normalized();
        QVERIFY((fitted->X_TM.rotation() * Vec3::UnitZ() - sternum).norm() < kExact);
        QVERIFY((fitted->X_TM.rotation() * Vec3::UnitX()).x() > 0.9); // to the patient's left
    }

    /// A slip of one landmark away from the others cannot be turned away whole.
    void tellsWhichLandmarkWasMissed()
    {
        const auto fitted =
            fitManikin(touchedAt({}, {Vec3::Zero(), Vec3::Zero(), {0.02, 0.0, 0.0}, Vec3::Zero()}));
        QVERIFY(fitted.has_value());
        const auto& residuals = fitted->fit.residuals;
        QVERIFY(residuals[2] > residuals[0] && residuals[2] > residuals[1]
                && residuals[2] > residuals[3]);
        QVERIFY(fitted->fit.rms > 0.004 && fitted->fit.rms < 0.01);
    }

    void refusesWhatLeavesItOpen()
    {
        auto landmarks = touchedAt({}, {});
        landmarks.resize(2);
        QCOMPARE(fitManikin(landmarks).error().code, Errc::TooFewLandmarks);
        landmarks = touchedAt({}, {});
        for (TouchedLandmark& landmark : landmarks)
            landmark.p_TQ = {0.0, 0.0, landmark.p_TQ.z()};
        QCOMPARE(fitManikin(landmarks).error().code, Errc::DegenerateLandmarks);
        landmarks = touchedAt({}, {});
        for (TouchedLandmark& landmark : landmarks)
            landmark.p_AQ = {0.0, 0.0, landmark.p_AQ.z()};
        QCOMPARE(fitManikin(landmarks).error().code, Errc::DegenerateLandmarks);
        landmarks = touchedAt({}, {});
        landmarks[3].p_TQ.y() = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(fitManikin(landmarks).error().code, Errc::NotFinite);
        landmarks = touchedAt({}, {});
        landmarks[3].p_AQ.y() = std::numeric_limits<double>::infinity();
        QCOMPARE(fitManikin(landmarks).error().code, Errc::NotFinite);
    }
};

CARINA_TEST(TestManikinFit)

} // namespace carina::manikin_fit_test

#include "tst_manikin_fit.moc"
