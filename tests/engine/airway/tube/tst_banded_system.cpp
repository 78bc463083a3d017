#include "engine/airway/tube/banded_system.h"
#include "tests/support/test_class.h"

#include <Eigen/Dense>

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
