#include "engine/geometry/fit/rigid_fit.h"

#include "engine/geometry/rotation.h"
#include "tests/engine/geometry/fit/horn.h"
#include "tests/support/test_class.h"

#include <numeric>
#include <random>

namespace carina::rigid_fit_test
{
namespace
{

constexpr double kExact = 1e-12;   // m and rad, for coordinates of about a metre
constexpr double kNoise = 0.35e-3; // m, standard deviation along each axis
/// Two ways to the same minimum differ by what rounding leaves of the noise.
constexpr double kSameMinimum = 1e-9; // m and rad

RigidTransform somePose(std::mt19937& random)
{
    std::normal_distribution<double> part;
    return {Quat{part(random), part(random), part(random), part(random)},
            {part(random), part(random), part(random)}};
}

Vec3 somePoint(std::mt19937& random, double size)
{
    std::normal_distribution<double> part{0.0, size};
    return {part(random), part(random), part(random)};
}

/// Landmarks of the anatomy, and the same as a manikin in X_AM shows them.
std::vector<LandmarkPair> pairsOf(const std::vector<Vec3>& p_AQ, const RigidTransform& X_AM)
{
    std::vector<LandmarkPair> pairs;
    for (const Vec3& p : p_AQ)
        pairs.push_back({p, X_AM.inverse() * p});
    return pairs;
}

RigidTransform hornOf(const std::vector<LandmarkPair>& pairs)
{
    std::vector<Vec3> p_AQ;
    std::vector<Vec3> p_MQ;
    for (const LandmarkPair& pair : pairs) {
        p_AQ.push_back(pair.p_AQ);
        p_MQ.push_back(pair.p_MQ);
    }
    return test::hornFit(p_AQ, p_MQ);
}

bool near(const RigidTransform& a, const RigidTransform& b, double tolerance)
{
    return (a.translation() - b.translation()).norm() < tolerance
           && angleBetween(a.rotation(), b.rotation()).si < tolerance;
}

const std::vector<Vec3> kRibCage{
    {0.0, -0.06, 0.04}, {0.0, -0.13, -0.13}, {0.08, -0.12, -0.11}, {-0.08, -0.12, -0.11}};
const std::vector<Vec3> kFlat{
    {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, {-0.1, 0.02, 0.0}, {0.0, -0.15, 0.0}};

} // namespace

class TestRigidFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recoversAnExactPose_data()
    {
        QTest::addColumn<std::vector<Vec3>>("p_AQ");
        QTest::newRow("three in general position")
            << std::vector<Vec3>{{0.3, 0.1, -0.2}, {-0.1, 0.25, 0.4}, {0.05, -0.3, 0.1}};
        QTest::newRow("four on the rib cage") << kRibCage;
        QTest::newRow("four in one plane") << kFlat;
        QTest::newRow("three in a plane that is not through the origin")
            << std::vector<Vec3>{{0.1, 0.0, 0.9}, {0.0, 0.1, 0.9}, {0.0, 0.0, 0.9}};
        QTest::newRow("eight corners of a box")
            << std::vector<Vec3>{{0, 0, 0},  {.1, 0, 0},  {0, .2, 0},  {.1, .2, 0},
                                 {0, 0, .3}, {.1, 0, .3}, {0, .2, .3}, {.1, .2, .3}};
    }

    void recoversAnExactPose()
    {
        QFETCH(std::vector<Vec3>, p_AQ);
        std::mt19937 random{7};
        for (int i = 0; i < 200; ++i) {
            const RigidTransform X_AM = somePose(random);
            const auto fit = fitRigid(pairsOf(p_AQ, X_AM));
            QVERIFY2(fit.has_value(), fit ? "" : fit.error().detail.c_str());
            QVERIFY(near(fit->X_AM, X_AM, 20.0 * kExact));
            QVERIFY(fit->rms < kExact);
            QCOMPARE(fit->residuals.size(), p_AQ.size());
        }
    }

    /// A turn by half a revolution, where a quaternion's sign and a matrix's trace change.
    void recoversHalfTurns()
    {
        for (const Vec3& axis : {Vec3::UnitX().eval(), Vec3::UnitY().eval(), Vec3::UnitZ().eval(),
                                 Vec3{1.0, 1.0, 1.0}.normalized().eval()}) {
            const RigidTransform X_AM{Quat{0.0, axis.x(), axis.y(), axis.z()}, {0.1, -2.0, 0.5}};
            const auto fit = fitRigid(pairsOf(kRibCage, X_AM));
            QVERIFY(fit.has_value());
            QVERIFY((fit->X_AM.matrix() - X_AM.matrix()).cwiseAbs().maxCoeff() < kExact);
        }
    }

    void findsTheSameMinimumAsHorn()
    {
        std::mt19937 random{11};
        for (int i = 0; i < 500; ++i) {
            std::vector<Vec3> p_AQ;
            for (int k = 0; k < 3 + i % 8; ++k)
                p_AQ.push_back(somePoint(random, 0.15));
            auto pairs = pairsOf(p_AQ, somePose(random));
            for (LandmarkPair& pair : pairs)
                pair.p_MQ += somePoint(random, kNoise);
            const auto fit = fitRigid(pairs);
            QVERIFY(fit.has_value());
            QVERIFY(near(fit->X_AM, hornOf(pairs), kSameMinimum));
        }
    }

    /// The trap: without the sign of the determinant each of these sets yields a mirror image.
    void neverMirrors_data()
    {
        QTest::addColumn<std::vector<Vec3>>("p_AQ");
        QTest::addColumn<double>("noise");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("flat and noisy") << kFlat << 0.01 << false;
        QTest::newRow("nearly flat and very noisy") << kRibCage << 0.05 << false;
        QTest::newRow("mirrored") << kRibCage << 0.0 << true;
        QTest::newRow("mirrored and noisy") << kRibCage << kNoise << true;
    }

    void neverMirrors()
    {
        QFETCH(std::vector<Vec3>, p_AQ);
        QFETCH(double, noise);
        QFETCH(bool, mirrored);
        std::mt19937 random{13};
        for (int i = 0; i < 200; ++i) {
            auto pairs = pairsOf(p_AQ, somePose(random));
            for (LandmarkPair& pair : pairs) {
                pair.p_MQ += somePoint(random, noise);
                if (mirrored)
                    pair.p_MQ.x() = -pair.p_MQ.x();
            }
            const auto fit = fitRigid(pairs);
            QVERIFY2(fit.has_value(), fit ? "" : fit.error().detail.c_str());
            QVERIFY(fit->X_AM.matrix().topLeftCorner(3, 3).determinant() > 0.999);
            QVERIFY(near(fit->X_AM, hornOf(pairs), 1e-6));
        }
    }

    void reportsEachResidual()
    {
        // A square and one pushed in along its diagonals: nothing turns or shifts by symmetry.
        const double side = 0.1;
        const double push = 0.004;
        std::vector<LandmarkPair> pairs;
        for (const Vec3& corner : {Vec3{1, 1, 0}, Vec3{-1, 1, 0}, Vec3{-1, -1, 0}, Vec3{1, -1, 0}})
            pairs.push_back({side * corner, side * corner - push * corner.normalized()});
        const auto fit = fitRigid(pairs);
        QVERIFY(fit.has_value());
        for (const double residual : fit->residuals)
            QVERIFY(std::abs(residual - push) < kExact);
        QVERIFY(std::abs(fit->rms - push) < kExact);
    }

    void reportsTheRootMeanSquareOfUnequalResiduals()
    {
        std::mt19937 random{17};
        auto pairs = pairsOf(kRibCage, somePose(random));
        pairs[2].p_MQ += Vec3{0.003, -0.002, 0.004};
        const auto fit = fitRigid(pairs);
        QVERIFY(fit.has_value());
        const RigidTransform X_AM = hornOf(pairs);
        double squares = 0.0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const double residual = (X_AM * pairs[i].p_MQ - pairs[i].p_AQ).norm();
            squares += residual * residual;
            QVERIFY(std::abs(fit->residuals[i] - residual) < kSameMinimum);
        }
        QVERIFY(std::abs(fit->rms - std::sqrt(squares / 4.0)) < kSameMinimum);
    }

    /// E(FRE^2) = (1 - 2/N) E(FLE^2) (Sibson 1979, Fitzpatrick 1998), with FLE^2 = 3 sigma^2.
    void leavesOfTheNoiseWhatTheoryLeaves()
    {
        constexpr int kTrials = 4000;
        constexpr double kThreeStandardErrors = 0.05; // of a mean of 6 degrees of freedom, generous
        std::mt19937 random{19};
        double squares = 0.0;
        for (int i = 0; i < kTrials; ++i) {
            auto pairs = pairsOf(kRibCage, somePose(random));
            for (LandmarkPair& pair : pairs)
                pair.p_MQ += somePoint(random, kNoise);
            const auto fit = fitRigid(pairs);
            QVERIFY(fit.has_value());
            squares += fit->rms * fit->rms / kTrials;
        }
        const double expected = (1.0 - 2.0 / 4.0) * 3.0 * kNoise * kNoise;
        QVERIFY(std::abs(squares / expected - 1.0) < kThreeStandardErrors);
    }
};

CARINA_TEST(TestRigidFit)

} // namespace carina::rigid_fit_test

#include "tst_rigid_fit.moc"
