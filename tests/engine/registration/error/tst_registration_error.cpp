#include "engine/registration/error/registration_error.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/engine/registration/fit/swabbed_shapes.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>

namespace carina::registration_error_test
{
namespace
{

constexpr int kTrials = 20'000;
constexpr double kAgree = 0.03; // of the RMS error, and of the whole variance for each entry
constexpr int kSwabs = 800;
constexpr double kSwabsAgree = 0.10; // of the RMS error
constexpr double kFle = 1e-3;        // m
constexpr double kSwabNoise = 0.3e-3;
const Vec3 kHalf{0.10, 0.06, 0.15}; // of a box about the origin

/// Covariances of the error at the targets.
using Measured = std::array<Mat3, 5>;

void add(Measured& sums, const RigidTransform& X_AM, const RigidTransform& X_MA, int trials)
{
    for (std::size_t t = 0; t < sums.size(); ++t) {
        const Vec3 error = X_AM * (X_MA * test::kTargets[t]) - test::kTargets[t];
        sums[t] += error * error.transpose() / trials;
    }
}

Measured none()
{
    Measured sums;
    sums.fill(Mat3::Zero());
    return sums;
}

/// The stylus as it is held at the landmarks.
std::vector<Mat3> heldAt(std::size_t count, bool alike)
{
    std::vector<Mat3> R_AS;
    for (std::size_t i = 0; i < count; ++i)
        R_AS.push_back(
            rotationFromVector(alike ? Vec3{0.4, -0.3, 1.2}
                                     : Vec3{0.8 * std::sin(2.0 * double(i)), 0.3 * double(i), 1.0})
                .toRotationMatrix());
    return R_AS;
}

/// What many fits by other code leave, of touches that stray each for itself and of a tip that is
/// off by the same at all touches of a fit.
Measured measuredErrors(const std::vector<Vec3>& p_A, const std::vector<Mat3>& R_AS,
                        const Mat3& tip_S)
{
    test::Hand hand{53};
    const Mat3 factor = test::factorOf(tip_S);
    Measured sums = none();
    std::vector<Vec3> p_M(p_A.size());
    for (int trial = 0; trial < kTrials; ++trial) {
        const RigidTransform X_MA = hand.pose();
        const Vec3 off_S = hand.error(factor);
        for (std::size_t i = 0; i < p_A.size(); ++i)
            p_M[i] = X_MA * (p_A[i] + R_AS[i] * off_S + kFle / std::sqrt(3.0) * hand.unit());
        add(sums, test::hornFit(p_A, p_M), X_MA, kTrials);
    }
    return sums;
}

/// The FRE that such touches leave on average (Sibson 1979).
Length freOf(std::size_t count) { return metres(kFle * std::sqrt(1.0 - 2.0 / double(count))); }

/// Points on the three faces of the box that meet in one corner, away from its edges.
std::vector<Vec3> onCorner()
{
    std::mt19937 random{3};
    std::uniform_real_distribution<double> in{0.015, 0.09};
    std::vector<Vec3> points;
    for (int i = 0; i < 120; ++i) {
        Vec3 inward{in(random), in(random), in(random)};
        inward[i % 3] = 0.0;
        points.push_back(kHalf - inward);
    }
    return points;
}

/// A plane before the chest, and points on it.
TriangleMesh plane()
{
    return {.positions = {{-1.0F, -0.1F, -1.0F},
                          {1.0F, -0.1F, -1.0F},
                          {1.0F, -0.1F, 1.0F},
                          {-1.0F, -0.1F, 1.0F}},
            .normals = {},
            .triangles = {{0, 1, 2}, {0, 2, 3}}};
}

std::vector<Vec3> onPlane()
{
    std::mt19937 random{3};
    std::uniform_real_distribution<double> side{-0.1, 0.1};
    std::vector<Vec3> points;
    for (int i = 0; i < 120; ++i)
        points.push_back({side(random), -0.1, side(random)});
    return points;
}

/// What refining many registrations on a surface came to.
struct Refined {
    Measured measured = none();
    Measured predicted = none(); ///< on average
    std::size_t loose = 0;       ///< motions that the last swab did not hold
};

/// @param tip of the tip's error along each axis, metres: all of a swab shares it
Refined refineMany(const TriangleMesh& mesh, const std::vector<Vec3>& p_A_swab, double tip)
{
    test::Hand hand{59};
    const SurfaceTree tree{mesh};
    const std::vector<Vec3> p_A = test::firstLandmarks(8);
    const Mat6 before = fitCovariance(equalErrors(p_A, metres(kFle))).value();
    Refined refined;
    for (int trial = 0; trial < kSwabs; ++trial) {
        const RigidTransform X_MA = hand.pose();
        std::vector<Vec3> p_M;
        for (const Vec3& p : p_A)
            p_M.push_back(X_MA * (p + kFle / std::sqrt(3.0) * hand.unit()));
        std::vector<Vec3> p_MQ;
        const Vec3 off_A = tip * hand.unit();
        for (const Vec3& p : p_A_swab)
            p_MQ.push_back(X_MA * (p + off_A + kSwabNoise * hand.unit()));
        const auto refinement = refineOnSurface(tree, p_MQ, test::hornFit(p_A, p_M));
        if (!refinement)
            return {};
        add(refined.measured, refinement->X_AM, X_MA, kSwabs);
        const Mat6 covariance =
            refinedCovariance(before, *refinement, tip * tip * Mat3::Identity());
        for (std::size_t t = 0; t < 5; ++t)
            refined.predicted[t] += pointCovariance(covariance, test::kTargets[t]) / kSwabs;
        refined.loose = refinement->loose.size();
    }
    return refined;
}

double rmsOf(const Mat3& covariance) { return std::sqrt(covariance.trace()); }

} // namespace

class TestRegistrationError : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWhatManyFitsLeave_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<bool>("alike");
        QTest::addColumn<Mat3>("tip");
        const Mat3 ball = 1e-6 * test::ellipsoid({0.5, 0.5, 0.5}, Vec3::Zero());
        const Mat3 needle = 1e-6 * test::ellipsoid({0.2, 0.3, 1.5}, {0.4, -0.7, 0.2});
        for (const int count : {4, 8})
            for (const bool alike : {true, false})
                for (const Mat3& tip : {ball, needle})
                    QTest::addRow("%d landmarks, held %s, tip %s", count,
                                  alike ? "alike" : "otherwise",
                                  tip == ball ? "alike in all directions" : "unlike")
                        << count << alike << tip;
    }

    void isWhatManyFitsLeave()
    {
        QFETCH(int, count);
        QFETCH(bool, alike);
        QFETCH(Mat3, tip);
        const std::vector<Vec3> p_A = test::firstLandmarks(count);
        const std::vector<Mat3> R_AS = heldAt(p_A.size(), alike);
        const auto predicted = registrationError(p_A, R_AS, tip, freOf(p_A.size()));
        QVERIFY(predicted.has_value());
        QVERIFY(std::abs(predicted->touch.fle.rms.si / kFle - 1.0) < 1e-12);
        QCOMPARE(predicted->touch.fle.degrees, 3.0 * count - 6.0);
        const Measured measured = measuredErrors(p_A, R_AS, tip);
        for (std::size_t t = 0; t < measured.size(); ++t) {
            const Mat3 covariance = pointCovariance(predicted->covariance_A, test::kTargets[t]);
            const double ratio = rmsOf(covariance) / rmsOf(measured[t]);
            QVERIFY2(std::abs(ratio - 1.0) < kAgree, qPrintable(QString::number(ratio)));
            QVERIFY2((covariance - measured[t]).cwiseAbs().maxCoeff()
                         < kAgree * measured[t].trace(),
                     test::kTargetNames[t]);
        }
    }

    void knowsATipThatIsNotKnown()
    {
        const std::vector<Vec3> p_A = test::firstLandmarks(6);
        const auto error = registrationError(p_A, heldAt(6, true), Mat3::Zero(), freOf(6));
        QVERIFY(error->covariance_A.isApprox(*fitCovariance(equalErrors(p_A, metres(kFle)))));
    }

    void believesInNoPerfectHand()
    {
        const auto error =
            registrationError(test::firstLandmarks(4), heldAt(4, true), Mat3::Zero(), metres(0.0));
        QCOMPARE(error->touch.fle.rms.si, kLeastFle.si);
        QVERIFY(error->covariance_A.trace() > 0.0);
    }

    void believesInNoHandBetterThanItsTracker()
    {
        const Length tracker = millimetres(0.7);
        const std::vector<std::optional<Length>> seen(4, tracker);
        const auto error = registrationError(test::firstLandmarks(4), heldAt(4, true), Mat3::Zero(),
                                             millimetres(0.2), {}, seen);
        QCOMPARE(error->own.rms.si, tracker.si);
        const auto worse = registrationError(test::firstLandmarks(4), heldAt(4, true), Mat3::Zero(),
                                             millimetres(2.0), {}, seen);
        QVERIFY(worse->own.rms > millimetres(2.0)); // as without
        const std::array<LocalisationError, 1> luck{{{millimetres(0.5), 18.0}}};
        const auto pooled = registrationError(test::firstLandmarks(4), heldAt(4, true),
                                              Mat3::Zero(), millimetres(0.2), luck, seen);
        QCOMPARE(pooled->touch.pooled, 1);
        QCOMPARE(pooled->touch.fle.rms.si, tracker.si);
    }

    /// Of the touches of which it is not known, nothing is assumed.
    void leavesTouchesAlikeThatTheTrackerSawAlike()
    {
        const std::vector<Vec3> p_A = test::firstLandmarks(6);
        std::vector<std::optional<Length>> seen(6, millimetres(0.4));
        seen[1] = seen[4] = std::nullopt;
        const auto error =
            registrationError(p_A, heldAt(6, true), Mat3::Zero(), freOf(6), {}, seen);
        QVERIFY(error->covariance_A.isApprox(*fitCovariance(equalErrors(p_A, metres(kFle)))));
    }

    /// A hand of 0.5 mm, and a tracker that sees some landmarks far worse than others.
    void isWhatManyFitsLeaveOfTouchesThatWereSeenUnlike()
    {
        constexpr double kHand = 0.5e-3;
        const std::vector<Vec3> p_A = test::firstLandmarks(8);
        const std::array seen_mm{0.2, 0.2, 0.3, 0.3, 2.0, 0.4, 0.2, 1.5};
        std::vector<std::optional<Length>> seen;
        std::vector<double> part; // standard deviation along each axis, m
        double squares = 0.0;
        for (const double mm : seen_mm) {
            seen.push_back(millimetres(mm));
            const double square = kHand * kHand + 1e-6 * mm * mm;
            part.push_back(std::sqrt(square / 3.0));
            squares += square;
        }
        const Length fre = metres(std::sqrt(squares / 8.0 * (1.0 - 2.0 / 8.0)));
        const auto predicted = registrationError(p_A, heldAt(8, true), Mat3::Zero(), fre, {}, seen);
        test::Hand hand{67};
        Measured measured = none();
        std::vector<Vec3> p_M(p_A.size());
        for (int trial = 0; trial < kTrials; ++trial) {
            const RigidTransform X_MA = hand.pose();
            for (std::size_t i = 0; i < p_A.size(); ++i)
                p_M[i] = X_MA * (p_A[i] + part[i] * hand.unit());
            add(measured, test::hornFit(p_A, p_M), X_MA, kTrials);
        }
        for (std::size_t t = 0; t < measured.size(); ++t) {
            const Mat3 covariance = pointCovariance(predicted->covariance_A, test::kTargets[t]);
            QVERIFY2(std::abs(rmsOf(covariance) / rmsOf(measured[t]) - 1.0) < kAgree,
                     test::kTargetNames[t]);
        }
    }

    void refusesWhatCannotBeFitted()
    {
        const Mat3 tip = 1e-8 * Mat3::Identity();
        QCOMPARE(registrationError(test::firstLandmarks(2), heldAt(2, true), tip, metres(kFle))
                     .error()
                     .code,
                 Errc::TooFewLandmarks);
        const std::vector<Vec3> line{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, {0.0, 0.0, 0.2}};
        QCOMPARE(registrationError(line, heldAt(3, true), tip, metres(kFle)).error().code,
                 Errc::DegenerateLandmarks);
    }

    /// Three faces of a box hold all motions, a plane leaves three loose.
    void isRefinedAsManySwabsAre_data()
    {
        QTest::addColumn<bool>("corner");
        QTest::addColumn<double>("tip");
        for (const double tip : {0.0, 0.5e-3}) {
            QTest::addRow("corner of a box, tip off by %.1f mm", 1e3 * tip) << true << tip;
            QTest::addRow("plane, tip off by %.1f mm", 1e3 * tip) << false << tip;
        }
    }

    void isRefinedAsManySwabsAre()
    {
        QFETCH(bool, corner);
        QFETCH(double, tip);
        const Refined refined = corner ? refineMany(test::box(kHalf), onCorner(), tip)
                                       : refineMany(plane(), onPlane(), tip);
        QCOMPARE(refined.loose, corner ? 0U : 3U);
        const std::vector<Vec3> p_A = test::firstLandmarks(8);
        const Mat6 before = fitCovariance(equalErrors(p_A, metres(kFle))).value();
        for (std::size_t t = 0; t < refined.measured.size(); ++t) {
            const double ratio = rmsOf(refined.predicted[t]) / rmsOf(refined.measured[t]);
            qInfo("%-15s %.3f mm of %.3f mm before, predicted %.3f of it", test::kTargetNames[t],
                  1e3 * rmsOf(refined.measured[t]),
                  1e3 * rmsOf(pointCovariance(before, test::kTargets[t])), ratio);
            QVERIFY(std::abs(ratio - 1.0) < kSwabsAgree);
        }
    }
};

CARINA_TEST(TestRegistrationError)

} // namespace carina::registration_error_test

#include "tst_registration_error.moc"
