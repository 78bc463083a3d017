#include "engine/airway/lumen/evened_way.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace carina::evened_way_test
{
namespace
{

constexpr double kSame = 1e-9;      // metres
constexpr double kInwards = 0.7e-3; // metres that a wall may be left behind between directions
constexpr double kRoom = 2e-3;      // metres
constexpr double kEach = 0.004;     // metres from a section to the next

Vec3 out(std::size_t k)
{
    const double angle = 2.0 * std::numbers::pi * double(k) / kLumenDirections;
    return {std::cos(angle), std::sin(angle), 0.0};
}

/// Straight down, with corners at these distances from a centre that may lie beside the line.
MovedWay straight(const std::vector<Vec3>& centres,
                  const std::function<double(std::size_t, std::size_t)>& reach)
{
    MovedWay way;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        MovedSection section{
            .p_A_centre = centres[i], .side = Vec3::UnitX(), .back = -Vec3::UnitY()};
        section.spare = 1.0;
        for (std::size_t k = 0; k < kLumenDirections; ++k)
            section.reach[k] = reach(i, k);
        way.sections.push_back(section);
        way.along.push_back(kEach * double(i));
    }
    return way;
}

std::vector<Vec3> line(std::size_t count)
{
    std::vector<Vec3> centres;
    for (std::size_t i = 0; i < count; ++i)
        centres.emplace_back(0.0, 0.0, -kEach * double(i));
    return centres;
}

/// Whether a place is within a polygon of corners around a centre.
bool isWithin(const Vec3& p, const MovedSection& polygon)
{
    const double u = (p - polygon.p_A_centre).dot(polygon.side);
    const double v = (p - polygon.p_A_centre).dot(polygon.back);
    bool isInside = false;
    for (std::size_t k = 0; k < kLumenDirections; ++k) {
        const std::size_t next = (k + 1) % kLumenDirections;
        const double ua = polygon.reach[k] * out(k).x(), va = polygon.reach[k] * out(k).y();
        const double ub = polygon.reach[next] * out(next).x(),
                     vb = polygon.reach[next] * out(next).y();
        if ((va > v) != (vb > v) && u < ua + (v - va) / (vb - va) * (ub - ua))
            isInside = !isInside;
    }
    return isInside;
}

} // namespace

class TestEvenedWay : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesARoundPipeAsItIs()
    {
        MovedWay way = straight(line(20), [](std::size_t, std::size_t) { return 0.006; });
        evenOut(way, kRoom);
        for (std::size_t i = 0; i < way.sections.size(); ++i) {
            QVERIFY((way.sections[i].p_A_centre - line(20)[i]).norm() < kSame);
            for (const double side : way.sections[i].reach)
                QVERIFY(std::abs(side - 0.006) < kSame);
            QVERIFY(std::abs(way.along[i] - kEach * double(i)) < kSame);
        }
    }

    /// Middles that lie beside each other by 2 mm, in walls that do not.
    void makesACentreLineEven()
    {
        std::vector<Vec3> centres = line(24);
        for (std::size_t i = 1; i + 1 < centres.size(); ++i)
            centres[i].x() += i % 2 == 0 ? 1e-3 : -1e-3;
        MovedWay way = straight(centres, [](std::size_t, std::size_t) { return 0.008; });
        evenOut(way, kRoom);
        for (std::size_t i = 4; i + 4 < way.sections.size(); ++i)
            QVERIFY(std::abs(way.sections[i].p_A_centre.x()) < 0.1e-3);
    }

    /// Walls with hollows and bulges: what is left is convex by being made of sides, and within
    /// them.
    void staysWithinItsWalls()
    {
        std::mt19937 random{24};
        std::uniform_real_distribution<double> any{0.0, 2.0 * std::numbers::pi};
        for (int trial = 0; trial < 40; ++trial) {
            std::array<double, kLumenDirections> reach{};
            const double two = any(random);
            const double three = any(random);
            for (std::size_t k = 0; k < kLumenDirections; ++k) {
                const double angle = 2.0 * std::numbers::pi * double(k) / kLumenDirections;
                reach[k] = 0.008 + 0.004 * std::sin(2.0 * angle + two)
                           + 0.0025 * std::sin(3.0 * angle + three);
            }
            const auto drawn = [&](std::size_t, std::size_t k) { return reach[k]; };
            MovedWay way = straight(line(9), drawn);
            const MovedWay before = straight(line(9), drawn);
            evenOut(way, kRoom);
            const MovedSection& after = way.sections[4];
            for (int step = 0; step < 64; ++step) {
                const double angle = 0.1 * step;
                const Vec3 direction = std::cos(angle) * after.side + std::sin(angle) * after.back;
                double there = 1.0;
                for (std::size_t k = 0; k < kLumenDirections; ++k) {
                    const double cosine =
                        out(k).x() * std::cos(angle) + out(k).y() * std::sin(angle);
                    if (cosine > 0.0)
                        there = std::min(there, after.reach[k] / cosine);
                }
                const Vec3 p = after.p_A_centre + std::max(there - kInwards, 0.0) * direction;
                QVERIFY(isWithin(p, before.sections[4]));
            }
        }
    }

    /// Of two opposite walls that are far, and two that are near, each stays.
    void keepsASlot()
    {
        const auto slot = [](std::size_t, std::size_t k) {
            return std::min(0.010 / std::max(std::abs(out(k).x()), 1e-9),
                            0.002 / std::max(std::abs(out(k).y()), 1e-9));
        };
        MovedWay way = straight(line(9), slot);
        evenOut(way, kRoom);
        QVERIFY(std::abs(way.sections[4].reach[0] - 0.010) < kInwards);
        QVERIFY(std::abs(way.sections[4].reach[kLumenDirections / 4] - 0.002) < kInwards);
    }

    void narrowsSlowlyBeforeANarrowPlace()
    {
        MovedWay way =
            straight(line(21), [](std::size_t i, std::size_t) { return i == 10 ? 0.001 : 0.012; });
        evenOut(way, kRoom);
        for (std::size_t i = 0; i + 1 < way.sections.size(); ++i)
            QVERIFY(std::abs(way.sections[i + 1].reach[0] - way.sections[i].reach[0])
                    < 0.4 * kEach + kSame);
        QVERIFY(way.sections[10].reach[0] < 0.001 + kSame);
    }

    /// At the inner side of a bend planes of neighbours meet: no section goes that far.
    void endsBeforeItsNeighboursPlane()
    {
        constexpr double kBend = 0.02;
        MovedWay way;
        for (int i = 0; i < 12; ++i) {
            const double a = kEach / kBend * i;
            const AcrossWay across = acrossWay({0.0, std::cos(a), -std::sin(a)});
            MovedSection section{
                .p_A_centre = {0.0, kBend * std::sin(a), kBend * (std::cos(a) - 1.0)},
                .side = across.side,
                .back = across.back};
            section.spare = 1.0;
            section.reach.fill(0.03);
            way.sections.push_back(section);
            way.along.push_back(kEach * i);
        }
        evenOut(way, kRoom);
        // The centre of the bend is kBend from the line, less what the line was moved towards it.
        for (std::size_t i = 1; i + 1 < way.sections.size(); ++i) {
            const MovedSection& section = way.sections[i];
            const Vec3 middle{section.p_A_centre.x(), 0.0, -kBend};
            const double toMiddle = (middle - section.p_A_centre).norm();
            QVERIFY(std::min(section.reach[kLumenDirections / 4],
                             section.reach[3 * kLumenDirections / 4])
                    < 0.8 * toMiddle);
        }
    }
};

CARINA_TEST(TestEvenedWay)

} // namespace carina::evened_way_test

#include "tst_evened_way.moc"
