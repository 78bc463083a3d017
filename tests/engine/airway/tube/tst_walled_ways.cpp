#include "engine/airway/tube/walled_ways.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>
#include <random>

namespace carina::walled_ways_test
{
namespace
{

constexpr std::size_t kNodes = 30;
constexpr std::size_t kFirst = 2;
constexpr double kWall = 1e3;
constexpr double kNear = 1e-7; // metres

/// A beam along z, as soft as a rod against bending, whose nodes are pushed aside at random, each
/// in a section of a polygon of its own size.
WalledWays pushed(std::mt19937& random)
{
    WalledWays walled{kNodes, kWall};
    std::normal_distribution<double> push{0.0, 1e-5};
    std::uniform_real_distribution<double> size{1e-3, 4e-3};
    for (BandedSystem::Row& row : walled.system.rows)
        row.diagonal += 1e-6 * Mat3::Identity();
    for (std::size_t i = 0; i < kNodes; ++i) {
        const AcrossWay across = acrossWay(Vec3::UnitZ());
        WalledWays::Node& node = walled.nodes[i];
        node.section = {.p_A_centre = {0.0, 0.0, 0.005 * double(i)},
                        .side = across.side,
                        .back = across.back,
                        .isFree = i % 7 == 3};
        node.section.sides.fill(size(random));
        node.slope = Vec3::UnitZ();
        node.across = acrossGuide(node.section, node.slope);
        walled.system.rows[i].right = {push(random), push(random), 0.1 * push(random)};
    }
    for (std::size_t i = 1; i + 1 < kNodes; ++i) {
        auto* row = &walled.system.rows[i - 1];
        row[0].diagonal += Mat3::Identity();
        row[1].diagonal += 4.0 * Mat3::Identity();
        row[2].diagonal += Mat3::Identity();
        row[1].before -= 2.0 * Mat3::Identity();
        row[2].before -= 2.0 * Mat3::Identity();
        row[2].secondBefore += Mat3::Identity();
    }
    return walled;
}

/// The gradient of the sum at a node, by its definition.
Vec3 gradientAt(std::size_t i, const std::vector<BandedSystem::Row>& rows, const WalledWays& walled)
{
    const auto ways = walled.ways();
    Vec3 sum = rows[i].diagonal * ways[i] - rows[i].right + rows[i].before * ways[i - 1]
               + rows[i].secondBefore * ways[i - 2];
    if (i + 1 < kNodes)
        sum += rows[i + 1].before.transpose() * ways[i + 1];
    if (i + 2 < kNodes)
        sum += rows[i + 2].secondBefore.transpose() * ways[i + 2];
    const GuideSection& section = walled.nodes[i].section;
    for (std::size_t k = 0; !section.isFree && k < kLumenDirections; ++k) {
        const double angle = 2.0 * std::numbers::pi * double(k) / kLumenDirections;
        const Vec3 out = std::cos(angle) * section.side + std::sin(angle) * section.back;
        sum += kWall * std::max(out.dot(ways[i]) - section.sides[k], 0.0) * out;
    }
    return sum;
}

} // namespace

class TestWalledWays : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The sum is convex: where its gradient is zero it is least.
    void areThoseOfTheLeastSum()
    {
        constexpr double kGradient = 1e-9;
        std::mt19937 random{25};
        int found = 0;
        for (int trial = 0; trial < 20; ++trial) {
            WalledWays walled = pushed(random);
            const std::vector<BandedSystem::Row> rows = walled.system.rows;
            // What is left of one search is found by the next, which begins with its walls.
            for (int i = 0; i < 8 && !walled.isLeast(); ++i) {
                walled.system.rows = rows;
                QVERIFY(walled.find(kFirst, kNear));
            }
            found += walled.isLeast();
            for (std::size_t i = 0; i < kFirst; ++i)
                QVERIFY(walled.ways()[i].isZero());
            for (std::size_t i = kFirst; walled.isLeast() && i < kNodes; ++i)
                QVERIFY(gradientAt(i, rows, walled).norm() < kGradient);
        }
        QVERIFY2(found >= 18, qPrintable(QString::number(found)));
    }

    void beginWithTheWallsOfTheLastTime()
    {
        std::mt19937 random{7};
        WalledWays walled = pushed(random);
        const std::vector<BandedSystem::Row> rows = walled.system.rows;
        for (int i = 0; i < 6; ++i) {
            walled.system.rows = rows;
            QVERIFY(walled.find(kFirst, kNear));
        }
        QVERIFY(walled.isLeast());
        const std::vector<Vec3> before{walled.ways().begin(), walled.ways().end()};
        walled.system.rows = rows;
        QVERIFY(walled.find(kFirst, kNear));
        QVERIFY(walled.isLeast());
        for (std::size_t i = 0; i < kNodes; ++i)
            QVERIFY((walled.ways()[i] - before[i]).norm() < kNear);
    }

    void endBeyondAWallByTheLoadOverItsStiffness()
    {
        // One node against one plane.
        WalledWays walled{4, kWall};
        for (BandedSystem::Row& row : walled.system.rows)
            row.diagonal = 1e-3 * Mat3::Identity();
        walled.nodes[3].section.isFree = false;
        walled.nodes[3].section.sides.fill(0.002);
        walled.nodes[3].slope = Vec3::UnitZ();
        walled.nodes[3].across = {Vec3::UnitX(), Vec3::UnitY()};
        walled.system.rows[3].right = {0.1, 0.0, 0.0};
        QVERIFY(walled.find(kFirst, kNear));
        const double depth = (0.1 - 1e-3 * 0.002) / (kWall + 1e-3);
        QVERIFY(std::abs(walled.ways()[3].x() - 0.002 - depth) < 1e-12);
    }

    void refuseAMatrixThatIsNotPositiveDefinite()
    {
        WalledWays walled{4, kWall};
        for (BandedSystem::Row& row : walled.system.rows)
            row.diagonal = -Mat3::Identity();
        QVERIFY(!walled.find(kFirst, kNear));
    }
};

CARINA_TEST(TestWalledWays)

} // namespace carina::walled_ways_test

#include "tst_walled_ways.moc"
