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
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(4 * kPlaces, 4 * kPlaces);
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const auto at = Eigen::Index(4 * i);
        const BandedSystem::Row& row = system.rows[i];
        whole.block<4, 4>(at, at) = row.diagonal;
        if (i >= 1) {
            whole.block<4, 4>(at, at - 4) = row.before;
            whole.block<4, 4>(at - 4, at) = row.before.transpose();
        }
        if (i >= 2) {
            whole.block<4, 4>(at, at - 8) = row.secondBefore;
            whole.block<4, 4>(at - 8, at) = row.secondBefore.transpose();
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
        const BandedSystem::Values given{0.3, -0.2, 0.1, 0.5};
        std::vector<BandedSystem::Values> values(kPlaces, given);
        QVERIFY(system.solve(kFirst, values));
        for (std::size_t i = 0; i < kFirst; ++i)
            QVERIFY(values[i] == given);
        Eigen::VectorXd all(4 * kPlaces);
        for (std::size_t i = 0; i < kPlaces; ++i)
            all.segment<4>(Eigen::Index(4 * i)) = values[i];
        const Eigen::VectorXd right = wholeOf(system) * all;
        for (std::size_t i = kFirst; i < kPlaces; ++i)
            QVERIFY((right.segment<4>(Eigen::Index(4 * i)) - system.rows[i].right).norm()
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
        for (BandedSystem::Row& row : system.rows)
            row.diagonal(3, 3) = 1.0;
        const Eigen::Matrix3d bend =
            (Eigen::Matrix3d::Identity() - t * t.transpose()) / (h * h * h);
        const Eigen::Matrix3d stretch = kStretch / h * t * t.transpose();
        for (std::size_t i = 0; i + 2 <= kPieces; ++i) {
            auto* row = &system.rows[i];
            row[0].diagonal.topLeftCorner<3, 3>() += bend;
            row[1].diagonal.topLeftCorner<3, 3>() += 4.0 * bend;
            row[2].diagonal.topLeftCorner<3, 3>() += bend;
            row[1].before.topLeftCorner<3, 3>() -= 2.0 * bend;
            row[2].before.topLeftCorner<3, 3>() -= 2.0 * bend;
            row[2].secondBefore.topLeftCorner<3, 3>() += bend;
        }
        for (std::size_t i = 1; i <= kPieces; ++i) {
            system.rows[i].diagonal.topLeftCorner<3, 3>() += stretch;
            system.rows[i].before.topLeftCorner<3, 3>() -= stretch;
            system.rows[i - 1].diagonal.topLeftCorner<3, 3>() += stretch;
        }
        system.rows.back().right.head<3>() = across;
        std::vector<BandedSystem::Values> values(kPieces + 1, BandedSystem::Values::Zero());
        QVERIFY(system.solve(kFirst, values));
        // Each of n turns is by its distance from the tip: h^3 (1 + 4 + ... + n^2).
        const double n = kPieces - 1;
        const double truth = h * h * h * n * (n + 1.0) * (2.0 * n + 1.0) / 6.0;
        const double found = values.back().head<3>().dot(across);
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
