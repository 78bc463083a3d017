#include "engine/registration/error/target_error.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::target_error_test
{
namespace
{

constexpr int kTrials = 20'000;
constexpr double kAgree = 0.03; // of the RMS error, and of the whole variance for each entry
constexpr Length kFle = millimetres(2.0);

/// What many fits by other code leave at the targets, for landmarks touched with these errors.
std::array<Mat3, 5> measuredErrors(const std::vector<LandmarkError>& landmarks,
                                   const std::vector<Mat3>& weights)
{
    test::Hand hand{29};
    std::vector<Vec3> p_A;
    std::vector<Mat3> factors;
    for (const LandmarkError& landmark : landmarks) {
        p_A.push_back(landmark.p_AQ);
        factors.push_back(test::factorOf(landmark.covariance_A));
    }
    std::array<Mat3, 5> sums;
    sums.fill(Mat3::Zero());
    std::vector<Vec3> p_M(p_A.size());
    for (int trial = 0; trial < kTrials; ++trial) {
        const RigidTransform X_MA = hand.pose();
        for (std::size_t i = 0; i < p_A.size(); ++i)
            p_M[i] = X_MA * (p_A[i] + hand.error(factors[i]));
        const RigidTransform X_AM =
            weights.empty() ? test::hornFit(p_A, p_M) : test::weightedFit(p_A, p_M, weights);
        for (std::size_t t = 0; t < sums.size(); ++t) {
            const Vec3 error = X_AM * (X_MA * test::kTargets[t]) - test::kTargets[t];
            sums[t] += error * error.transpose() / kTrials;
        }
    }
    return sums;
}

/// FLE^2 / N (1 + 1/3 sum_k d_k^2 / f_k^2), with d the target's distance from the k-th principal
/// axis and f the landmarks' root mean square from it (Fitzpatrick, West, Maurer 1998).
double rmsByFitzpatrick(const std::vector<Vec3>& p_A, const Vec3& target, double fle)
{
    const auto count = double(p_A.size());
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : p_A)
        mean += p / count;
    Mat3 scatter = Mat3::Zero();
    for (const Vec3& p : p_A)
        scatter += (p - mean) * (p - mean).transpose() / count;
    const Eigen::SelfAdjointEigenSolver<Mat3> principal{scatter};
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        const Vec3 axis = principal.eigenvectors().col(k);
        const double d2 = (target - mean).cross(axis).squaredNorm();
        sum += d2 / (principal.eigenvalues().sum() - principal.eigenvalues()[k]);
    }
    return fle * std::sqrt((1.0 + sum / 3.0) / count);
}

std::vector<LandmarkError> eightAlike() { return equalErrors(test::firstLandmarks(8), kFle); }

} // namespace

class TestTargetError : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWhatManyFitsLeave_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<bool>("unlike");
        QTest::addColumn<bool>("weighed");
        for (const int count : {4, 6, 8}) {
            QTest::addRow("%d, alike in all directions", count) << count << false << false;
            QTest::addRow("%d, unlike, weighed alike", count) << count << true << false;
            QTest::addRow("%d, unlike, weighed by covariance", count) << count << true << true;
        }
    }

    void isWhatManyFitsLeave()
    {
        QFETCH(int, count);
        QFETCH(bool, unlike);
        QFETCH(bool, weighed);
        std::vector<LandmarkError> landmarks = equalErrors(test::firstLandmarks(count), kFle);
        const std::vector<Mat3> errors = test::unlikeErrors(landmarks.size());
        std::vector<Mat3> weights;
        for (std::size_t i = 0; unlike && i < landmarks.size(); ++i) {
            landmarks[i].covariance_A = errors[i];
            if (weighed)
                weights.push_back(1e-6 * errors[i].inverse());
        }
        const auto covariance =
            fitCovariance(landmarks, weighed ? Weighting::ByCovariance : Weighting::Alike);
        QVERIFY(covariance.has_value());
        const auto measured = measuredErrors(landmarks, weights);
        for (std::size_t t = 0; t < measured.size(); ++t) {
            const TargetError predicted = targetError(*covariance, test::kTargets[t]);
            const double rms = std::sqrt(measured[t].trace());
            QVERIFY2(std::abs(predicted.rms.si / rms - 1.0) < kAgree, test::kTargetNames[t]);
            QVERIFY2((predicted.covariance_A - measured[t]).cwiseAbs().maxCoeff()
                         < kAgree * measured[t].trace(),
                     test::kTargetNames[t]);
        }
    }

    void agreesWithFitzpatrick_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {3, 4, 6, 8})
            QTest::addRow("%d landmarks", count) << count;
    }

    void agreesWithFitzpatrick()
    {
        QFETCH(int, count);
        const std::vector<Vec3> p_A = test::firstLandmarks(count);
        const auto alike = fitCovariance(equalErrors(p_A, kFle));
        const auto weighed = fitCovariance(equalErrors(p_A, kFle), Weighting::ByCovariance);
        QVERIFY(alike.has_value() && weighed.has_value());
        for (const Vec3& target : test::kTargets) {
            const double expected = rmsByFitzpatrick(p_A, target, kFle.si);
            QVERIFY(std::abs(targetError(*alike, target).rms.si / expected - 1.0) < 1e-9);
            QVERIFY(std::abs(targetError(*weighed, target).rms.si / expected - 1.0) < 1e-9);
        }
    }

    /// What a tip that is off does to a stylus that is always held alike: it shifts all.
    void sharedErrorShiftsWhatIsTouchedAlike()
    {
        const auto landmarks = eightAlike();
        const Mat3 tip = 1e-8 * test::ellipsoid({3.0, 1.0, 2.0}, {0.3, 0.2, 0.1});
        const Mat3 held = rotationFromVector({0.4, -0.3, 1.2}).toRotationMatrix();
        const std::vector<Mat3> R_AS(landmarks.size(), held);
        const auto shared = sharedCovariance(landmarks, R_AS, tip);
        QVERIFY(shared.has_value());
        const Mat3 expected = held * tip * held.transpose();
        for (const Vec3& target : test::kTargets)
            QVERIFY((pointCovariance(*shared, target) - expected).norm() < 1e-9 * expected.norm());
    }

    /// Held otherwise at each landmark, it moves the anatomy as a fit of so displaced ones does.
    void sharedErrorMovesTheFit_data()
    {
        QTest::addColumn<bool>("weighed");
        QTest::newRow("weighed alike") << false;
        QTest::newRow("weighed by covariance") << true;
    }

    void sharedErrorMovesTheFit()
    {
        QFETCH(bool, weighed);
        std::vector<LandmarkError> landmarks = eightAlike();
        const std::vector<Mat3> errors = test::unlikeErrors(landmarks.size());
        std::vector<Mat3> weights;
        std::vector<Mat3> R_AS;
        std::vector<Vec3> p_A;
        test::Hand hand{31};
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            landmarks[i].covariance_A = errors[i];
            weights.push_back(weighed ? Mat3{1e-6 * errors[i].inverse()} : Mat3::Identity());
            R_AS.push_back(hand.pose().rotation().toRotationMatrix());
            p_A.push_back(landmarks[i].p_AQ);
        }
        const Vec3 off_S{0.3e-6, -0.2e-6, 0.5e-6}; // so small that first order is exact
        const auto shared = sharedCovariance(landmarks, R_AS, off_S * off_S.transpose(),
                                             weighed ? Weighting::ByCovariance : Weighting::Alike);
        QVERIFY(shared.has_value());
        std::vector<Vec3> p_M = p_A;
        for (std::size_t i = 0; i < p_M.size(); ++i)
            p_M[i] += R_AS[i] * off_S;
        const RigidTransform X_AM = test::weightedFit(p_A, p_M, weights);
        for (const Vec3& target : test::kTargets) {
            const Vec3 moved = X_AM * target - target;
            QVERIFY((pointCovariance(*shared, target) - moved * moved.transpose()).norm()
                    < 1e-4 * off_S.squaredNorm());
        }
    }

    void namesTheWeakestDirection_data()
    {
        QTest::addColumn<std::vector<Vec3>>("p_A");
        QTest::addColumn<Vec3>("target");
        QTest::addColumn<int>("axis");
        // Nearly on a line along z: a turn about it moves what lies before it to the side, what
        // lies beside it to the front.
        const std::vector<Vec3> upright{
            {0, 0, 0.2}, {0, 0, -0.2}, {0.01, 0, 0}, {-0.01, 0.01, 0.0}};
        const std::vector<Vec3> level{{0.2, 0, 0}, {-0.2, 0, 0}, {0, 0, 0.01}, {0, 0.01, -0.01}};
        QTest::newRow("to the side") << upright << Vec3{0, -0.2, 0} << 0;
        QTest::newRow("to the front") << upright << Vec3{0.2, 0, 0} << 1;
        QTest::newRow("to the feet") << level << Vec3{0, -0.2, 0} << 2;
    }

    void namesTheWeakestDirection()
    {
        QFETCH(std::vector<Vec3>, p_A);
        QFETCH(Vec3, target);
        QFETCH(int, axis);
        const auto covariance = fitCovariance(equalErrors(p_A, kFle));
        QVERIFY(covariance.has_value());
        const TargetError error = targetError(*covariance, target);
        QCOMPARE(int(error.weakestAxis), axis);
        QVERIFY(std::abs(error.weakest_A[axis]) > 0.99);
        QVERIFY(std::abs(error.weakest_A.norm() - 1.0) < 1e-12);
        const double along = error.weakest_A.dot(error.covariance_A * error.weakest_A);
        QVERIFY(along > 0.9 * error.rms.si * error.rms.si);
    }

    void boundGrowsWhereTheSizeIsOnlyEstimated()
    {
        const auto covariance = fitCovariance(eightAlike());
        QVERIFY(covariance.has_value());
        const TargetError known = targetError(*covariance, test::kTargets[0]);
        const TargetError estimated = targetError(*covariance, test::kTargets[0], 18.0);
        QCOMPARE(known.bound.si, errorBound(known.covariance_A).si);
        QCOMPARE(estimated.bound.si, errorBound(known.covariance_A, 18.0).si);
        QCOMPARE(estimated.rms, known.rms);
        QVERIFY(estimated.bound > 1.05 * known.bound);
    }

    void refusesWhatCannotBeFitted_data()
    {
        QTest::addColumn<std::vector<LandmarkError>>("landmarks");
        QTest::addColumn<Errc>("code");
        auto bad = eightAlike();
        bad.resize(2);
        QTest::newRow("two") << bad << Errc::TooFewLandmarks;
        bad = eightAlike();
        bad[7].p_AQ.y() = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("no place") << bad << Errc::NotFinite;
        bad[7].p_AQ.y() = 1e3;
        QTest::newRow("a kilometre away") << bad << Errc::OutOfRange;
        bad = eightAlike();
        bad[3].covariance_A(1, 1) = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("no covariance") << bad << Errc::NotFinite;
        bad[3].covariance_A = Mat3::Zero();
        QTest::newRow("without any error") << bad << Errc::OutOfRange;
        bad[3].covariance_A = Vec3{1e-6, 1e-6, -1e-6}.asDiagonal();
        QTest::newRow("a negative variance") << bad << Errc::OutOfRange;
        bad[3].covariance_A = 1e-6 * Mat3::Identity();
        bad[3].covariance_A(0, 1) = 1e-7;
        QTest::newRow("not symmetric") << bad << Errc::OutOfRange;
        const std::vector<Vec3> line{{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0.3, 0, 1e-3}};
        QTest::newRow("on one line") << equalErrors(line, kFle) << Errc::DegenerateLandmarks;
        const std::vector<Vec3> place(5, Vec3{0.1, 0.2, 0.3});
        QTest::newRow("at one place") << equalErrors(place, kFle) << Errc::DegenerateLandmarks;
    }

    void refusesWhatCannotBeFitted()
    {
        QFETCH(std::vector<LandmarkError>, landmarks);
        QFETCH(Errc, code);
        const auto covariance = fitCovariance(landmarks);
        QVERIFY(!covariance);
        QCOMPARE(covariance.error().code, code);
        const std::vector<Mat3> held(landmarks.size(), Mat3::Identity());
        QCOMPARE(sharedCovariance(landmarks, held, Mat3::Identity()).error().code, code);
    }

    void takesThreeLandmarks()
    {
        QVERIFY(fitCovariance(equalErrors(test::firstLandmarks(3), kFle)));
    }
};

CARINA_TEST(TestTargetError)

} // namespace carina::target_error_test

#include "tst_target_error.moc"
