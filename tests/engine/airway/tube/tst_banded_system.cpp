#include "engine/airway/tube/banded_system.h"
#include "tests/support/test_class.h"

#include <Eigen/Dense>

#include <cmath>
#include <random>

namespace carina::banded_system_test
{
namespace
{

constexpr std::size_t kPlaces = 12;
constexpr std::size_t kFirst = 2;

/// A random one; positive definite, as its diagonal outweighs the rest.
BandedSystem drawn(std::mt19937& random)
{
    std::normal_distribution<double> part;
    using Block = BandedSystem::Block;
    const auto block = [&] { return Block{Block::NullaryExpr([&] { return part(random); })}; };
    BandedSystem system;
    system.resize(kPlaces);
    for (BandedSystem::Row& row : system.rows) {
        const Block half = block();
        row.diagonal = half * half.transpose() + 30.0 * Block::Identity();
        row.before = block();
        row.secondBefore = block();
        row.right = BandedSystem::Values::NullaryExpr([&] { return part(random); });
    }
    return system;
}

/// The whole matrix.
Eigen::MatrixXd wholeOf(const BandedSystem& system)
{
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(3 * kPlaces, 3 * kPlaces);
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const auto at = Eigen::Index(3 * i);
        const BandedSystem::Row& row = system.rows[i];
        whole.block<3, 3>(at, at) = row.diagonal;
        if (i >= 1) {
            whole.block<3, 3>(at, at - 3) = row.before;
            whole.block<3, 3>(at - 3, at) = row.before.transpose();
        }
        if (i >= 2) {
            whole.block<3, 3>(at, at - 6) = row.secondBefore;
            whole.block<3, 3>(at - 6, at) = row.secondBefore.transpose();
        }
    }
    return whole;
}

} // namespace

class TestBandedSystem : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The equations hold, with the given values of the first places.
    void isSolved()
    {
        constexpr double kRounding = 1e-12;
        std::mt19937 random{25};
        BandedSystem system = drawn(random);
        const BandedSystem::Values given{0.3, -0.2, 0.1};
        std::vector<BandedSystem::Values> values(kPlaces, given);
        QVERIFY(system.solve(kFirst, values));
        for (std::size_t i = 0; i < kFirst; ++i)
            QVERIFY(values[i] == given);
        Eigen::VectorXd all(3 * kPlaces);
        for (std::size_t i = 0; i < kPlaces; ++i)
            all.segment<3>(Eigen::Index(3 * i)) = values[i];
        const Eigen::VectorXd right = wholeOf(system) * all;
        for (std::size_t i = kFirst; i < kPlaces; ++i)
            QVERIFY((right.segment<3>(Eigen::Index(3 * i)) - system.rows[i].right).norm()
                    < kRounding);
    }

    /// As of a rod of 64 pieces that is hard to stretch, of 200 mm, aslant, at rest and loaded at
    /// its tip: as a cantilever, although it is 1e9 times as stiff along as across.
    void keepsWhatIsSoftBesideWhatIsStiff()
    {
        constexpr double kOfSolution = 1e-4; // share
        constexpr double kStretch = 2e8;
        constexpr int kPieces = 64;
        const double h = 0.2 / kPieces;
        const Eigen::Vector3d t = Eigen::Vector3d{1.0, 2.0, -3.0}.normalized();
        const Eigen::Vector3d across = t.unitOrthogonal();
        BandedSystem system;
        system.resize(kPieces + 1);
        const Eigen::Matrix3d bend =
            (Eigen::Matrix3d::Identity() - t * t.transpose()) / (h * h * h);
        const Eigen::Matrix3d stretch = kStretch / h * t * t.transpose();
        for (std::size_t i = 0; i + 2 <= kPieces; ++i) {
            auto* row = &system.rows[i];
            row[0].diagonal += bend;
            row[1].diagonal += 4.0 * bend;
            row[2].diagonal += bend;
            row[1].before -= 2.0 * bend;
            row[2].before -= 2.0 * bend;
            row[2].secondBefore += bend;
        }
        for (std::size_t i = 1; i <= kPieces; ++i) {
            system.rows[i].diagonal += stretch;
            system.rows[i].before -= stretch;
            system.rows[i - 1].diagonal += stretch;
        }
        system.rows.back().right = across;
        std::vector<BandedSystem::Values> values(kPieces + 1, BandedSystem::Values::Zero());
        QVERIFY(system.solve(kFirst, values));
        // Each of n turns is by its distance from the tip: h^3 (1 + 4 + ... + n^2).
        const double n = kPieces - 1;
        const double truth = h * h * h * n * (n + 1.0) * (2.0 * n + 1.0) / 6.0;
        const double found = values.back().dot(across);
        QVERIFY2(std::abs(found - truth) < kOfSolution * truth,
                 qPrintable(QString::number(found / truth)));
    }

    void refusesAMatrixThatIsNotPositiveDefinite()
    {
        std::mt19937 random{25};
        BandedSystem system = drawn(random);
        system.rows[7].diagonal -= 90.0 * BandedSystem::Block::Identity();
        std::vector<BandedSystem::Values> values(kPlaces, BandedSystem::Values::Zero());
        QVERIFY(!system.solve(kFirst, values));
    }
};

CARINA_TEST(TestBandedSystem)

} // namespace carina::banded_system_test

#include "tst_banded_system.moc"
