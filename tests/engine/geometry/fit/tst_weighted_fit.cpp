#include "engine/geometry/fit/weighted_fit.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::weighted_fit_test
{
namespace
{

constexpr double kSameMinimum = 1e-9; // m and rad

struct Touched {
    std::vector<UncertainPair> pairs;
    RigidTransform X_AM;
};

/// Landmarks touched with unlike errors in the manikin's frame and known with others in the
/// anatomy's.
Touched someTouches(test::Hand& hand, int count, bool alsoAnatomy)
{
    Touched touched{.pairs = {}, .X_AM = hand.pose()};
    const std::vector<Vec3> p_A = test::firstLandmarks(count);
    const std::vector<Mat3> errors = test::unlikeErrors(p_A.size());
    for (std::size_t i = 0; i < p_A.size(); ++i) {
        UncertainPair pair;
        pair.covariance_M = errors[i];
        if (alsoAnatomy)
            pair.covariance_A = errors[p_A.size() - 1 - i];
        pair.pair.p_AQ = p_A[i];
        if (alsoAnatomy)
            pair.pair.p_AQ += hand.error(test::factorOf(pair.covariance_A));
        pair.pair.p_MQ =
            touched.X_AM.inverse() * p_A[i] + hand.error(test::factorOf(pair.covariance_M));
        touched.pairs.push_back(pair);
    }
    return touched;
}

double chiSquaredAt(const std::vector<UncertainPair>& pairs, const RigidTransform& X_AM)
{
    const Mat3 R = X_AM.rotation().toRotationMatrix();
    double sum = 0.0;
    for (const UncertainPair& pair : pairs) {
        const Vec3 e = pair.pair.p_AQ - X_AM * pair.pair.p_MQ;
        sum += e.dot((pair.covariance_A + R * pair.covariance_M * R.transpose()).inverse() * e);
    }
    return sum;
}

bool near(const RigidTransform& a, const RigidTransform& b)
{
    return (a.translation() - b.translation()).norm() < kSameMinimum
           && angleBetween(a.rotation(), b.rotation()).si < kSameMinimum;
}

} // namespace

class TestWeightedFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recoversAnExactPose()
    {
        test::Hand hand{47};
        for (int i = 0; i < 50; ++i) {
            Touched touched = someTouches(hand, 3 + i % 6, true);
            for (UncertainPair& pair : touched.pairs)
                pair.pair.p_MQ = touched.X_AM.inverse() * pair.pair.p_AQ;
            const auto fit = fitWeighted(touched.pairs);
            QVERIFY(fit.has_value());
            QVERIFY(near(fit->fit.X_AM, touched.X_AM));
            QVERIFY(fit->chiSquared < 1e-12);
            QVERIFY(fit->fit.rms < 1e-12);
        }
    }

    /// Errors of the anatomy do not turn with the fit, so its minimum can be found by other code.
    void findsTheSameMinimumAsOtherCode()
    {
        test::Hand hand{53};
        for (int i = 0; i < 200; ++i) {
            Touched touched = someTouches(hand, 4 + i % 5, true);
            std::vector<Vec3> p_A;
            std::vector<Vec3> p_M;
            std::vector<Mat3> weights;
            for (UncertainPair& pair : touched.pairs) {
                pair.covariance_M = Mat3::Zero();
                p_A.push_back(pair.pair.p_AQ);
                p_M.push_back(pair.pair.p_MQ);
                weights.push_back(1e-6 * pair.covariance_A.inverse());
            }
            const auto fit = fitWeighted(touched.pairs);
            QVERIFY(fit.has_value());
            QVERIFY(near(fit->fit.X_AM, test::weightedFit(p_A, p_M, weights)));
            QVERIFY(std::abs(fit->chiSquared / chiSquaredAt(touched.pairs, fit->fit.X_AM) - 1.0)
                    < 1e-9);
        }
    }

    void isTheUnweightedFitWhereAllErrorsAreAlike()
    {
        test::Hand hand{59};
        for (int i = 0; i < 100; ++i) {
            Touched touched = someTouches(hand, 3 + i % 6, false);
            std::vector<LandmarkPair> pairs;
            for (UncertainPair& pair : touched.pairs) {
                pair.covariance_A = 1e-6 * Mat3::Identity();
                pair.covariance_M = 3e-6 * Mat3::Identity();
                pairs.push_back(pair.pair);
            }
            const auto fit = fitWeighted(touched.pairs);
            const auto expected = fitRigid(pairs);
            QVERIFY(fit.has_value() && expected.has_value());
            QVERIFY(near(fit->fit.X_AM, expected->X_AM));
            QVERIFY(std::abs(fit->fit.rms / expected->rms - 1.0) < 1e-9);
            const double squares = expected->rms * expected->rms * double(pairs.size());
            QVERIFY(std::abs(fit->chiSquared / (squares / 4e-6) - 1.0) < 1e-9);
            for (std::size_t k = 0; k < pairs.size(); ++k)
                QVERIFY(std::abs(fit->fit.residuals[k] - expected->residuals[k]) < kSameMinimum);
        }
    }

    /// Of touches that stray as their covariances say: chi-squared is 3 N - 6 on average, the pose
    /// is off by its covariance, and by less than where covariances are not heeded.
    void isOffByItsCovariance()
    {
        constexpr int kTrials = 4000;
        test::Hand hand{61};
        double chiSquared = 0.0;
        double squares = 0.0;
        double unweighted = 0.0;
        double predicted = 0.0;
        const Vec3 target = test::kTargets[2];
        for (int i = 0; i < kTrials; ++i) {
            const Touched touched = someTouches(hand, 8, true);
            std::vector<LandmarkPair> pairs;
            for (const UncertainPair& pair : touched.pairs)
                pairs.push_back(pair.pair);
            const auto fit = fitWeighted(touched.pairs);
            QVERIFY(fit.has_value());
            QCOMPARE(fit->degrees, 18.0);
            QCOMPARE(fit->scale(), fit->chiSquared / 18.0);
            const Vec3 p_M = touched.X_AM.inverse() * target;
            chiSquared += fit->chiSquared / kTrials;
            squares += (fit->fit.X_AM * p_M - target).squaredNorm() / kTrials;
            unweighted += (fitRigid(pairs)->X_AM * p_M - target).squaredNorm() / kTrials;
            predicted += pointCovariance(fit->covariance_A, target).trace() / kTrials;
        }
        QVERIFY(std::abs(chiSquared / 18.0 - 1.0) < 0.02);
        QVERIFY(std::abs(squares / predicted - 1.0) < 0.06); // of squares: 3 % of the RMS
        QVERIFY(squares < 0.8 * unweighted);
    }

    /// The manikin's covariances turn with it: whichever way its frame lies, the anatomy's pose in
    /// the tracker is the same.
    void turnsTheManikinsErrors()
    {
        test::Hand hand{67};
        const Touched touched = someTouches(hand, 6, true);
        const RigidTransform X_MN = hand.pose();
        const Mat3 R_NM = X_MN.rotation().toRotationMatrix().transpose();
        std::vector<UncertainPair> turned = touched.pairs;
        for (UncertainPair& pair : turned) {
            pair.pair.p_MQ = X_MN.inverse() * pair.pair.p_MQ;
            pair.covariance_M = R_NM * pair.covariance_M * R_NM.transpose();
        }
        const auto fit = fitWeighted(touched.pairs);
        const auto other = fitWeighted(turned);
        QVERIFY(fit.has_value() && other.has_value());
        QVERIFY(near(fit->fit.X_AM * X_MN, other->fit.X_AM));
    }

    /// Places that have nothing to do with each other, each known well along one direction only.
    void refusesTouchesThatContradictEachOther()
    {
        test::Hand hand{139};
        int refused = 0;
        for (int i = 0; i < 500; ++i) {
            std::vector<UncertainPair> pairs;
            for (int k = 0; k < 3 + i % 5; ++k)
                pairs.push_back({.pair = {0.1 * hand.unit(), 0.1 * hand.unit()},
                                 .covariance_M = test::ellipsoid({1e-4, 1e-3, 1.0}, hand.unit())});
            const auto fit = fitWeighted(pairs);
            refused += fit ? 0 : 1;
            if (fit)
                QVERIFY(std::isfinite(fit->chiSquared) && fit->covariance_A.allFinite());
            else
                QCOMPARE(fit.error().code, Errc::DegenerateLandmarks);
        }
        QVERIFY(refused > 0);
    }

    void refusesWhatCannotBeFitted_data()
    {
        QTest::addColumn<std::vector<UncertainPair>>("pairs");
        QTest::addColumn<Errc>("code");
        test::Hand hand{71};
        const auto sound = someTouches(hand, 8, true).pairs;
        const double nan = std::numeric_limits<double>::quiet_NaN();
        auto bad = sound;
        bad.resize(2);
        QTest::newRow("two") << bad << Errc::TooFewLandmarks;
        QTest::newRow("none") << std::vector<UncertainPair>{} << Errc::TooFewLandmarks;
        bad = sound;
        bad[1].pair.p_MQ.z() = nan;
        QTest::newRow("no place") << bad << Errc::NotFinite;
        bad = sound;
        bad[4].covariance_M(2, 2) = nan;
        QTest::newRow("no covariance") << bad << Errc::NotFinite;
        bad[4].covariance_M.setZero();
        bad[4].covariance_A.setZero();
        QTest::newRow("without any error") << bad << Errc::OutOfRange;
        bad = sound;
        for (UncertainPair& pair : bad)
            pair.pair.p_AQ = Vec3{pair.pair.p_AQ.z(), 0.0, 0.0};
        QTest::newRow("on one line") << bad << Errc::DegenerateLandmarks;
    }

    void refusesWhatCannotBeFitted()
    {
        QFETCH(std::vector<UncertainPair>, pairs);
        QFETCH(Errc, code);
        const auto fit = fitWeighted(pairs);
        QVERIFY(!fit);
        QCOMPARE(fit.error().code, code);
    }
};

CARINA_TEST(TestWeightedFit)

} // namespace carina::weighted_fit_test

#include "tst_weighted_fit.moc"
