#include "engine/airway/tube/elastic_rod.h"
#include "engine/core/units.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>
#include <random>

namespace carina::elastic_rod_test
{
namespace
{

constexpr double kStiffness = 5e-3; // N m^2
constexpr int kSegments = 64;
constexpr double kOfSolution = 0.05; // share

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

Vec3 deflected(ElasticRod& rod, const Vec3& load)
{
    const Vec3 before = rod.nodes().back();
    for (int i = 0; i < 60; ++i)
        rod.step({}, FreeSpace{}, load);
    return rod.nodes().back() - before;
}

/// A straight pipe along -z.
class Pipe final : public RodWall
{
public:
    explicit Pipe(double radius) : m_radius(radius) {}
    WallTouch at(std::size_t /*node*/, const Vec3& p_A) const override
    {
        const double r = std::hypot(p_A.x(), p_A.y());
        const Vec3 out = r > 0.0 ? Vec3{p_A.x() / r, p_A.y() / r, 0.0} : Vec3{Vec3::Zero()};
        // Round: the depth's second derivative along it is 1 / r.
        const Vec3 round =
            r > 0.0 ? Vec3{Vec3::UnitZ().cross(out) / std::sqrt(r)} : Vec3{Vec3::Zero()};
        return {.depth = r - m_radius, .out = out, .round = round};
    }

private:
    double m_radius;
};

} // namespace

class TestElasticRod : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bendsAsACantilever();
    void bendsFarAsAnElastica();
    void bendsACurvedBeamInItsPlane();
    void bendsACurvedBeamOutOfItsPlane();
    void takesTheEnergyOfAnotherRadius();
    void isAsLongAsAtRest();
    void followsItsClampInFreeSpace();
    void turnsWithItsClamp();
    void slidesIntoAPipe();
    void comesToRestWithoutFriction();
    void gainsNoEnergyWhileItsClampRests();
    void givesTheSameBits();
};

void TestElasticRod::bendsAsACantilever()
{
    const double length = 0.3;
    ElasticRod rod{{.stiffness = kStiffness}, straight(length)};
    const double load = 0.002;
    const double free = length * (kSegments - 1) / kSegments;
    const double truth = load * std::pow(free, 3) / (3.0 * kStiffness); // Euler and Bernoulli
    const double found = deflected(rod, {load, 0.0, 0.0}).x();
    QVERIFY2(std::abs(found - truth) < kOfSolution * truth, qPrintable(QString::number(found)));
}

void TestElasticRod::bendsFarAsAnElastica()
{
    // P L^2 / (E I) = 2: deflection 0.49346 L, shortening 0.16064 L (Bisshopp and Drucker 1945).
    const double length = 0.3;
    ElasticRod rod{{.stiffness = kStiffness}, straight(length)};
    const double free = length * (kSegments - 1) / kSegments;
    const Vec3 found = deflected(rod, {2.0 * kStiffness / (free * free), 0.0, 0.0});
    QVERIFY(std::abs(found.x() / free - 0.49346) < kOfSolution * 0.49346);
    QVERIFY(std::abs(found.z() / free - 0.16064) < kOfSolution * 0.16064);
}

void TestElasticRod::bendsACurvedBeamInItsPlane()
{
    // A quarter of a circle, clamped at one end, loaded at the other across its direction there, by
    // Castigliano: pi P R^3 / (4 E I) along the load and P R^3 / (2 E I) across it.
    const double radius = 0.14;
    ElasticRod rod{{.stiffness = kStiffness}, arc(radius, 0.5 * std::numbers::pi)};
    const double load = 0.001;
    const double unit = load * std::pow(radius, 3) / kStiffness;
    const Vec3 found = deflected(rod, {0.0, 0.0, load});
    const double along = 0.25 * std::numbers::pi * unit;
    QVERIFY(std::abs(found.z() - along) < kOfSolution * along);
    QVERIFY(std::abs(-found.y() - 0.5 * unit) < kOfSolution * 0.5 * unit);
}

void TestElasticRod::bendsACurvedBeamOutOfItsPlane()
{
    // The same by Castigliano with torsion: P R^3 (pi / (4 E I) + (3 pi / 4 - 2) / (G J)).
    const double radius = 0.14;
    ElasticRod rod{{.stiffness = kStiffness}, arc(radius, 0.5 * std::numbers::pi)};
    const double load = 0.001;
    const double share =
        0.25 * std::numbers::pi + (0.75 * std::numbers::pi - 2.0) / ElasticRod::kTorsionToBending;
    const double truth = share * load * std::pow(radius, 3) / kStiffness;
    const double found = deflected(rod, {load, 0.0, 0.0}).x();
    QVERIFY2(std::abs(found - truth) < kOfSolution * truth, qPrintable(QString::number(found)));
}

void TestElasticRod::takesTheEnergyOfAnotherRadius()
{
    // E I L (1 / R - 1 / R0)^2 / 2, R infinite in a pipe so narrow that the rod is straight in it.
    const double radius = 0.14;
    const double angle = 1.5;
    ElasticRod rod{{.stiffness = kStiffness}, arc(radius, angle)};
    const std::vector<Vec3> line = straight(radius * angle * kSegments / (kSegments - 1));
    rod.lay({}, line);
    for (int i = 0; i < 60; ++i)
        rod.step({}, Pipe{1e-5});
    const double truth = 0.5 * kStiffness * angle / radius;
    QVERIFY2(std::abs(rod.energy() - truth) < kOfSolution * truth,
             qPrintable(QString::number(rod.energy() / truth)));
}

void TestElasticRod::isAsLongAsAtRest()
{
    constexpr double kStretch = 1e-9; // share
    ElasticRod rod{{.stiffness = kStiffness}, straight(0.3)};
    static_cast<void>(deflected(rod, {0.2, 0.0, 0.1}));
    for (std::size_t i = 0; i + 1 < rod.nodes().size(); ++i) {
        const double length = (rod.nodes()[i + 1] - rod.nodes()[i]).norm();
        QVERIFY(std::abs(length / (0.3 / kSegments) - 1.0) < kStretch);
    }
}

void TestElasticRod::followsItsClampInFreeSpace()
{
    // Without any load it is as at rest, wherever it is held: after a single step.
    constexpr double kNear = 1e-7; // metres
    ElasticRod rod{{.stiffness = kStiffness}, arc(0.14, 1.5)};
    const Quat turn{Eigen::AngleAxisd{0.07, Vec3{1.0, -2.0, 0.5}.normalized()}};
    RigidTransform X_AE;
    for (int i = 0; i < 10; ++i) {
        X_AE = RigidTransform{turn, {0.003, -0.001, 0.002}} * X_AE;
        rod.step(X_AE, FreeSpace{});
        const std::vector<Vec3> rest = rod.nodesAtRest();
        for (std::size_t k = 0; k < rest.size(); ++k)
            QVERIFY((rod.nodes()[k] - rest[k]).norm() < kNear);
    }
}

void TestElasticRod::turnsWithItsClamp()
{
    // About its first segment, so that its curve goes round: the frame is carried along all of it.
    constexpr double kNear = 1e-7; // metres
    ElasticRod rod{{.stiffness = kStiffness}, arc(0.14, 1.5)};
    for (int degree = 0; degree <= 180; degree += 4)
        rod.step({Quat{Eigen::AngleAxisd{degrees(degree).si, Vec3::UnitZ()}}, Vec3::Zero()},
                 FreeSpace{});
    QVERIFY((rod.nodes().back() - rod.nodesAtRest().back()).norm() < kNear);
}

void TestElasticRod::slidesIntoAPipe()
{
    // A curved rod that is pushed along a pipe is straight in it, with play, and goes as far as it
    // is pushed, in each of the steps.
    constexpr double kOutside = 1e-4; // metres
    constexpr double kBehind = 1e-3;
    constexpr double kRadius = 0.002;
    ElasticRod rod{{.stiffness = kStiffness}, arc(0.14, 1.5)};
    rod.lay({}, straight(0.14 * 1.5 * kSegments / (kSegments - 1)));
    const Pipe pipe{kRadius};
    rod.comeToRest(pipe);
    const double tip = rod.nodes().back().z();
    for (int i = 1; i <= 100; ++i) {
        rod.step(RigidTransform::translation({0.0, 0.0, -0.0015 * i}), pipe);
        for (const Vec3& p : rod.nodes())
            QVERIFY(std::hypot(p.x(), p.y()) < kRadius + kOutside);
        QVERIFY(std::abs(rod.nodes().back().z() - tip + 0.0015 * i) < kBehind);
    }
}

void TestElasticRod::comesToRestWithoutFriction()
{
    // The same as that which has no friction comes to in many steps.
    constexpr double kNear = 2e-5; // metres
    const std::vector<Vec3> line = straight(0.14 * 1.5 * kSegments / (kSegments - 1));
    ElasticRod rod{{.stiffness = kStiffness}, arc(0.14, 1.5)};
    rod.lay({}, line);
    rod.comeToRest(Pipe{0.01});
    ElasticRod smooth{{.stiffness = kStiffness, .friction = 0.0}, arc(0.14, 1.5)};
    smooth.lay({}, line);
    for (int i = 0; i < 100; ++i)
        smooth.step({}, Pipe{0.01});
    for (std::size_t i = 0; i < line.size(); ++i)
        QVERIFY((rod.nodes()[i] - smooth.nodes()[i]).norm() < kNear);
    const Vec3 before = rod.nodes().back();
    rod.step({}, Pipe{0.01});
    QVERIFY((rod.nodes().back() - before).norm() < kNear);
}

void TestElasticRod::gainsNoEnergyWhileItsClampRests()
{
    constexpr double kRounding = 1e-12; // joules
    std::mt19937 random{25};
    std::normal_distribution<double> part{0.0, 0.003};
    for (int trial = 0; trial < 10; ++trial) {
        ElasticRod rod{{.stiffness = kStiffness, .friction = 0.0}, arc(0.14, 1.5)};
        std::vector<Vec3> nodes = rod.nodesAtRest();
        for (std::size_t i = ElasticRod::kHeld; i < nodes.size(); ++i)
            nodes[i] += Vec3{part(random), part(random), part(random)};
        rod.lay({}, nodes);
        double before = rod.energy();
        for (int i = 0; i < 40; ++i) {
            rod.step({}, FreeSpace{});
            QVERIFY(rod.energy() <= before + kRounding);
            before = rod.energy();
        }
    }
}

void TestElasticRod::givesTheSameBits()
{
    const auto run = [] {
        ElasticRod rod{{.stiffness = kStiffness}, arc(0.14, 1.5)};
        for (int i = 0; i < 30; ++i)
            rod.step(RigidTransform::translation({0.0, 0.001 * i, 0.0}), Pipe{0.02});
        return std::vector<Vec3>{rod.nodes().begin(), rod.nodes().end()};
    };
    const std::vector<Vec3> once = run();
    const std::vector<Vec3> again = run();
    for (std::size_t i = 0; i < once.size(); ++i)
        QVERIFY(once[i] == again[i]);
}

CARINA_TEST(TestElasticRod)

} // namespace carina::elastic_rod_test

#include "tst_elastic_rod.moc"
