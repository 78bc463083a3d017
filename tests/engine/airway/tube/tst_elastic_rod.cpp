#include "engine/airway/tube/elastic_rod.h"
#include "engine/core/units.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace carina::elastic_rod_test
{
namespace
{

constexpr double kStiffness = 5e-3; // N m^2
constexpr int kSegments = 64;
constexpr double kOfSolution = 0.01; // share
constexpr double kOfElastica = 0.05;

/// Straight along -z; the first segment is held.
std::vector<Vec3> straight(double length)
{
    std::vector<Vec3> line;
    for (int i = 0; i <= kSegments; ++i)
        line.emplace_back(0.0, 0.0, -length * i / kSegments);
    return line;
}

/// An arc from the end of the held segment on, which is straight before it; towards -y.
std::vector<Vec3> arc(double radius, double angle)
{
    std::vector<Vec3> line{{0.0, 0.0, radius * angle / (kSegments - 1)}};
    for (int i = 0; i < kSegments; ++i) {
        const double a = angle * i / (kSegments - 1);
        line.emplace_back(0.0, -radius * (1.0 - std::cos(a)), -radius * std::sin(a));
    }
    return line;
}

/// The turns of a line that begins along -z, in a frame that is carried along it without rotation
/// about it: about the axis of each, 2 sin(phi / 2).
std::vector<Vec3> turnsOf(std::span<const Vec3> line)
{
    std::vector<Vec3> turns;
    Quat frame = Quat::Identity();
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Vec3 before = (line[i] - line[i - 1]).normalized();
        const Vec3 after = (line[i + 1] - line[i]).normalized();
        turns.emplace_back(frame.inverse()
                           * Vec3{2.0 / (before + after).norm() * before.cross(after)});
        frame = Quat::FromTwoVectors(before, after) * frame;
    }
    return turns;
}

/// Of bending, joules: E I / (2 l) times the square of what each turn differs from that at rest.
/// Of the first one half a segment bends.
double energyOf(const ElasticRod& rod, std::span<const Vec3> rest)
{
    const std::vector<Vec3> turns = turnsOf(rod.nodes());
    const std::vector<Vec3> atRest = turnsOf(rest);
    double sum = (turns[0] - atRest[0]).squaredNorm();
    for (std::size_t i = 0; i < turns.size(); ++i)
        sum += (turns[i] - atRest[i]).squaredNorm();
    return 0.5 * kStiffness / rod.along(1) * sum;
}

/// A guide along a line in free space.
RodGuide freeAlong(const std::vector<Vec3>& line)
{
    RodGuide guide;
    guide.addFree(line);
    return guide;
}

/// A rod that lies along its curve at rest in free space, and what holds it.
struct Laid {
    explicit Laid(const std::vector<Vec3>& rest) : guide{freeAlong(rest)}, rod{kStiffness, rest}
    {
        hold.guide = &guide;
        rod.layAlong(hold, rest.size(), 0.0);
    }
    Laid(const Laid&) = delete;

    /// How far its tip goes with a load at it.
    [[nodiscard]] Vec3 deflected(const Vec3& load)
    {
        constexpr int kSteps = 60; // the load comes in the first half of them
        const Vec3 before = rod.nodes().back();
        for (int i = 1; i <= kSteps; ++i)
            if (!rod.step(hold, std::min(2.0 * i / kSteps, 1.0) * load))
                return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
        return rod.nodes().back() - before;
    }

    RodGuide guide;
    ElasticRod rod;
    RodHold hold;
};

/// A straight pipe along -z from `begin` on, with free space before it.
RodGuide pipe(double radius, double begin, double length)
{
    RodGuide guide;
    guide.addFree(std::vector<Vec3>{{0.0, 0.0, 0.02}, {0.0, 0.0, 0.0}, {0.0, 0.0, -begin}});
    for (double z = begin + 0.004; z <= begin + length; z += 0.004) {
        const AcrossWay across = acrossWay(-Vec3::UnitZ());
        GuideSection section{.p_A_centre = {0.0, 0.0, -z},
                             .side = across.side,
                             .back = across.back,
                             .isFree = false};
        section.sides.fill(radius);
        guide.add(section);
    }
    return guide;
}

constexpr double kBeforeGuide = 0.02; ///< of the pipe: its begin before the origin, metres

} // namespace

class TestElasticRod : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Euler and Bernoulli.
    void bendsAsACantilever()
    {
        const double length = 0.3;
        Laid it{straight(length)};
        const double load = 0.002;
        const double free = length * (kSegments - 1) / kSegments;
        const double truth = load * std::pow(free, 3) / (3.0 * kStiffness);
        const double found = it.deflected({load, 0.0, 0.0}).x();
        QVERIFY2(std::abs(found - truth) < kOfSolution * truth,
                 qPrintable(QString::number(found / truth)));
    }

    /// P L^2 / (E I) = 2: deflection 0.49346 L, shortening 0.16064 L (Bisshopp and Drucker 1945).
    void bendsFarAsAnElastica()
    {
        const double length = 0.3;
        Laid it{straight(length)};
        const double free = length * (kSegments - 1) / kSegments;
        const Vec3 found = it.deflected({2.0 * kStiffness / (free * free), 0.0, 0.0});
        QVERIFY(std::abs(found.x() / free - 0.49346) < kOfElastica * 0.49346);
        QVERIFY(std::abs(found.z() / free - 0.16064) < kOfElastica * 0.16064);
    }

    /// A quarter of a circle, clamped at one end, loaded at the other across its direction there,
    /// by Castigliano: pi P R^3 / (4 E I) along the load and P R^3 / (2 E I) across it.
    void bendsACurvedBeam()
    {
        const double radius = 0.14;
        Laid it{arc(radius, 0.5 * std::numbers::pi)};
        const double load = 0.001;
        const double unit = load * std::pow(radius, 3) / kStiffness;
        const Vec3 found = it.deflected({0.0, 0.0, load});
        const double along = 0.25 * std::numbers::pi * unit;
        QVERIFY(std::abs(found.z() - along) < kOfSolution * along);
        QVERIFY(std::abs(-found.y() - 0.5 * unit) < kOfSolution * 0.5 * unit);
    }

    /// E I L (1 / R - 1 / R0)^2 / 2, R infinite in a pipe so narrow that the rod is straight in it.
    void takesTheEnergyOfAnotherRadius()
    {
        const double radius = 0.14;
        const double angle = 1.5;
        const std::vector<Vec3> rest = arc(radius, angle);
        ElasticRod rod{kStiffness, rest};
        const RodGuide guide = pipe(1e-5, 1e-3, 0.3);
        const RodHold hold{.guide = &guide, .first = kBeforeGuide - rest.front().z()};
        rod.layAlong(hold, ElasticRod::kHeld, hold.first + rod.along(ElasticRod::kHeld));
        for (int i = 0; i < 40; ++i)
            QVERIFY(rod.step(hold));
        const double truth = 0.5 * kStiffness * angle / radius;
        constexpr double kOfEnergy = 0.02; // share: half a turn is left at what holds it
        const double energy = energyOf(rod, rest);
        QVERIFY2(std::abs(energy - truth) < kOfEnergy * truth,
                 qPrintable(QString::number(energy / truth)));
    }

    void isAsLongAsAtRest()
    {
        constexpr double kStretch = 1e-6; // share
        Laid it{straight(0.3)};
        static_cast<void>(it.deflected({0.1, 0.0, 0.05}));
        for (std::size_t i = 0; i + 1 < it.rod.nodes().size(); ++i) {
            const double length = (it.rod.nodes()[i + 1] - it.rod.nodes()[i]).norm();
            QVERIFY(std::abs(length / (0.3 / kSegments) - 1.0) < kStretch);
        }
    }

    /// A curved rod that is pushed along a pipe is straight in it, with play, and goes as far as it
    /// is pushed: in each of the steps.
    void slidesIntoAPipe()
    {
        constexpr double kOutside = 1e-6; // metres
        constexpr double kBehind = 1e-3;
        constexpr double kRadius = 0.002;
        const std::vector<Vec3> rest = arc(0.14, 1.5);
        ElasticRod rod{kStiffness, rest};
        const RodGuide guide = pipe(kRadius, 0.004, 0.6);
        RodHold hold{.guide = &guide, .first = kBeforeGuide - rest.front().z()};
        rod.layAlong(hold, ElasticRod::kHeld, hold.first + rod.along(ElasticRod::kHeld));
        for (int i = 0; i < 20; ++i)
            QVERIFY(rod.step(hold));
        const double tip = rod.nodes().back().z();
        for (int i = 1; i <= 100; ++i) {
            hold.first += 0.0015;
            QVERIFY(rod.step(hold));
            for (std::size_t k = 0; k < rod.nodes().size(); ++k) {
                const Vec3& p = rod.nodes()[k];
                if (p.z() < -0.008)
                    QVERIFY(std::hypot(p.x(), p.y())
                            < kRadius / std::cos(std::numbers::pi / kLumenDirections) + kOutside);
            }
            QVERIFY(std::abs(rod.nodes().back().z() - tip + 0.0015 * i) < kBehind);
        }
    }

    /// Pushed 30 mm beyond a stop it stays there, and does not bend: it is behind what holds it.
    void staysAtAStop()
    {
        constexpr double kNear = 1e-5; // metres
        const std::vector<Vec3> rest = straight(0.2);
        ElasticRod rod{kStiffness, rest};
        const RodGuide guide = pipe(0.005, 0.004, 0.6);
        RodHold hold{.guide = &guide, .first = kBeforeGuide, .stop = kBeforeGuide + 0.21};
        rod.layAlong(hold, ElasticRod::kHeld, hold.first + rod.along(ElasticRod::kHeld));
        for (int i = 0; i < 40; ++i) {
            hold.first += 0.001;
            QVERIFY(rod.step(hold));
        }
        QVERIFY(std::abs(rod.nodes().back().z() + 0.21) < kNear);
        QVERIFY(std::abs(rod.heldBack() - 0.03) < kNear);
        QVERIFY(energyOf(rod, rest) < 1e-9);
        // What stopped it is gone: it comes on, not at once.
        hold.stop = 1.0;
        QVERIFY(rod.step(hold));
        QVERIFY(std::abs(rod.heldBack() - 0.03 + ElasticRod::kMostOn) < kNear);
        for (int i = 0; i < 20; ++i)
            QVERIFY(rod.step(hold));
        QVERIFY(std::abs(rod.nodes().back().z() + 0.24) < kNear);
    }

    /// Wherever it lay before: the same place that it is held at, the same form.
    void forgetsWhereItLay()
    {
        constexpr double kNear = 2e-5; // metres
        const std::vector<Vec3> rest = arc(0.14, 1.5);
        const RodGuide guide = pipe(0.004, 0.004, 0.6);
        const auto heldFrom = [&](double from) {
            ElasticRod rod{kStiffness, rest};
            RodHold hold{.guide = &guide, .first = from};
            rod.layAlong(hold, ElasticRod::kHeld, hold.first + rod.along(ElasticRod::kHeld));
            const double until = kBeforeGuide + 0.05;
            for (int i = 1; i <= 50; ++i) {
                hold.first = from + i * (until - from) / 50;
                static_cast<void>(rod.step(hold));
            }
            for (int i = 0; i < 30; ++i)
                static_cast<void>(rod.step(hold));
            return std::vector<Vec3>{rod.nodes().begin(), rod.nodes().end()};
        };
        const std::vector<Vec3> pushed = heldFrom(kBeforeGuide);
        const std::vector<Vec3> pulled = heldFrom(kBeforeGuide + 0.1);
        for (std::size_t i = 0; i < pushed.size(); ++i)
            QVERIFY((pushed[i] - pulled[i]).norm() < kNear);
    }

    /// While what holds it rests, from whatever it was bent to.
    void gainsNoEnergyWhileItIsHeldStill()
    {
        constexpr double kRounding = 1e-9; // joules
        std::mt19937 random{25};
        std::uniform_real_distribution<double> part{-0.05, 0.05};
        for (int trial = 0; trial < 10; ++trial) {
            const std::vector<Vec3> rest = arc(0.14, 1.5);
            Laid it{rest};
            static_cast<void>(it.deflected({part(random), part(random), part(random)}));
            double before = energyOf(it.rod, rest);
            for (int i = 0; i < 40; ++i) {
                QVERIFY(it.rod.step(it.hold));
                const double energy = energyOf(it.rod, rest);
                QVERIFY2(energy <= before + kRounding,
                         qPrintable(QStringLiteral("%1 %2 %3").arg(i).arg(energy).arg(before)));
                before = energy;
            }
            QVERIFY(before < kRounding);
        }
    }

    /// Likewise between walls, against which a load at its tip had pressed it: from the step on
    /// that lets go of it.
    void gainsNoEnergyBetweenWalls()
    {
        constexpr double kOfLargest = 1e-3; // by the last of Newton's steps
        std::mt19937 random{26};
        std::uniform_real_distribution<double> part{-0.5, 0.5};
        for (int trial = 0; trial < 10; ++trial) {
            const std::vector<Vec3> rest = arc(0.14, 1.5);
            ElasticRod rod{kStiffness, rest};
            const RodGuide guide = pipe(0.008, 0.004, 0.6);
            const RodHold hold{.guide = &guide, .first = kBeforeGuide};
            rod.layAlong(hold, ElasticRod::kHeld, hold.first + rod.along(ElasticRod::kHeld));
            const Vec3 load{part(random), part(random), 0.0};
            for (int i = 0; i < 20; ++i)
                QVERIFY(rod.step(hold, load));
            QVERIFY(rod.step(hold));
            const double largest = energyOf(rod, rest);
            double before = largest;
            for (int i = 0; i < 60; ++i) {
                QVERIFY(rod.step(hold));
                const double energy = energyOf(rod, rest);
                QVERIFY2(energy <= before + kOfLargest * largest,
                         qPrintable(QStringLiteral("%1 %2 %3").arg(i).arg(energy).arg(before)));
                before = energy;
            }
        }
    }

    void isLostWhereItJumps()
    {
        const std::vector<Vec3> rest = straight(0.2);
        ElasticRod rod{kStiffness, rest};
        const RodGuide guide = pipe(0.005, 0.004, 0.6);
        RodHold hold{.guide = &guide, .first = kBeforeGuide};
        rod.layAlong(hold, ElasticRod::kHeld, hold.first + rod.along(ElasticRod::kHeld));
        QVERIFY(rod.step(hold));
        hold.first += 0.3;
        QVERIFY(!rod.step(hold));
    }

    void givesTheSameBits()
    {
        const auto run = [] {
            const std::vector<Vec3> rest = arc(0.14, 1.5);
            ElasticRod rod{kStiffness, rest};
            const RodGuide guide = pipe(0.004, 0.004, 0.6);
            RodHold hold{.guide = &guide, .first = kBeforeGuide};
            rod.layAlong(hold, ElasticRod::kHeld, hold.first + rod.along(ElasticRod::kHeld));
            for (int i = 0; i < 30; ++i) {
                hold.first += 0.001;
                static_cast<void>(rod.step(hold));
            }
            return std::vector<Vec3>{rod.nodes().begin(), rod.nodes().end()};
        };
        QVERIFY(run() == run());
    }
};

CARINA_TEST(TestElasticRod)

} // namespace carina::elastic_rod_test

#include "tst_elastic_rod.moc"
