#include "engine/airway/tube/tube_in_lumen.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/airway/lumen/still_lumen.h"
#include "tests/engine/airway/tube/bent_lumen.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina::tube_in_lumen_test
{
namespace
{

using test::BentLumen;
using test::fed;
using test::restCurve;
using test::roundLumen;
using test::unmoved;

constexpr Length kOutside = millimetres(0.5);
constexpr double kFeed = 0.0015; ///< metres each step: 15 cm a second

TubeSize sizeOf(double inner_mm) { return *tubeOfSize(millimetres(inner_mm)); }
TubeInLumen tubeOf(const TubeSize& size) { return {size, restCurve(size)}; }

/// Distance of the tips of both shapes.
Length apart(const TubeInLumen& tube)
{
    return metres((tube.measured().back() - tube.constrained().back()).norm());
}

/// Feeds a tube until so much of it should be inside, and lets it come to rest.
void feed(TubeInLumen& tube, const MovedLumen& lumen, double inside)
{
    for (double now = -0.02; now < inside; now += kFeed)
        tube.step(fed(tube.size(), now), lumen);
    for (int i = 0; i < 60; ++i)
        tube.step(fed(tube.size(), inside), lumen);
}

/// A straight airway along +y with a branch that leaves it by 30 degrees behind 12 cm.
AirwayLumen forked(Length tubeRadius)
{
    std::array<std::vector<Vec3>, kAirwayWays> lines;
    std::array<std::vector<double>, kAirwayWays> radii;
    for (int i = -7; i <= 60; ++i) {
        lines[0].emplace_back(0.0, 0.004 * i, 0.0);
        radii[0].push_back(0.010);
    }
    const Vec3 aside{0.0, std::cos(degrees(30.0).si), std::sin(degrees(30.0).si)};
    for (int i = 0; i <= 25; ++i) {
        lines[3].push_back(Vec3{0.0, 0.12, 0.0} + 0.004 * i * aside);
        radii[3].push_back(0.010);
    }
    AirwayLumen lumen = roundLumen(lines, radii, tubeRadius);
    lumen.teeth = 7;
    lumen.glottis = 40;
    lumen.begins[3] = 4;
    return lumen;
}

/// Held so that its tip, as measured, is there: a straight tube that points at it from the teeth.
RigidTransform pointingAt(const TubeSize& size, const Vec3& p_A_tip)
{
    const Vec3 along = (p_A_tip - Vec3{0.0, 0.0, 0.0}).normalized();
    const Quat q = Quat::FromTwoVectors(-Vec3::UnitZ(), along);
    return {q, p_A_tip - size.length.si * along};
}

/// A ring in the trunk that is too narrow for a tube.
const LumenSection& narrowed(AirwayLumen& lumen, std::size_t ring, const TubeSize& size)
{
    LumenSection& narrow = lumen.ways.front()[ring];
    for (LumenLimit& limit : narrow.limits) {
        const Vec3 out = (limit.p_A_wall - narrow.p_A_centre).normalized();
        limit.p_A_wall = narrow.p_A_centre + (size.outerRadius().si - 0.0006) * out;
    }
    return narrow;
}

void sizes()
{
    QTest::addColumn<double>("inner_mm");
    for (const double inner_mm : {6.0, 7.0, 8.0})
        QTest::newRow(qPrintable(QString::number(inner_mm))) << inner_mm;
}

} // namespace

class TestTubeInLumen : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reachesTheDepthToWhichItIsPushed_data() { sizes(); }
    void reachesTheDepthToWhichItIsPushed();
    void staysInABentLumen_data() { sizes(); }
    void staysInABentLumen();
    void isStoppedByARing_data() { sizes(); }
    void isStoppedByARing();
    void isAsMeasuredOutside();
    void isApartFromWhatIsMeasured();
    void hasTheCurveAtRestOfTheMoment();
    void isLaidAnewWhereItWasLost();
    void takesTheWayToWhichItsTipIsNearest();
    void doesNotGoOverDeepInAWay();
    void isFoundAgainInTheSameWay();
    void liesInTheWayInWhichItIsFound();
    void isFoundBeforeWhatHoldsItUpOrBehind();
    void staysBehindAHandThatPushesItOn();
    void givesTheSameBits();
};

void TestTubeInLumen::reachesTheDepthToWhichItIsPushed()
{
    QFETCH(double, inner_mm);
    constexpr Length kDepth = millimetres(2.0);
    const BentLumen airway{.bend = 0.0};
    const TubeSize size = sizeOf(inner_mm);
    // As with a stylet that keeps it straight: its curve at rest is a line.
    const std::vector<Vec3> line{Vec3::Zero(), -size.length.si * Vec3::UnitZ()};
    TubeInLumen tube{size, line};
    const MovedLumen lumen = unmoved(airway.lumenFor(size.outerRadius()));
    Mat3 R;
    R << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    const double inside = 0.18;
    for (double now = -0.02; now < inside; now += kFeed)
        tube.step({Quat{R}, {0.0, now - size.length.si, 0.003}}, lumen);
    for (int i = 0; i < 20; ++i)
        tube.step({Quat{R}, {0.0, inside - size.length.si, 0.003}}, lumen);
    QVERIFY(std::abs(tube.tip().p_A.y() - inside) < kDepth.si);
    QVERIFY(std::abs(tube.tip().depth.si - inside) < kDepth.si);
    QCOMPARE(tube.tip().seat, TubeSeat::Trachea);
}

void TestTubeInLumen::staysInABentLumen()
{
    QFETCH(double, inner_mm);
    const BentLumen airway;
    const TubeSize size = sizeOf(inner_mm);
    TubeInLumen tube = tubeOf(size);
    feed(tube, unmoved(airway.lumenFor(size.outerRadius())), 0.2);
    // The walls are those of the formula, not of the sections.
    const double room = airway.radius - size.outerRadius().si;
    for (const Vec3& p_A : tube.constrained())
        if (p_A.y() > 0.0)
            QVERIFY(airway.fromMiddle(p_A) < room + kOutside.si);
    constexpr Length kDepth = millimetres(2.0);
    QVERIFY(std::abs(tube.tip().depth.si - 0.2) < kDepth.si);
    // It is at the least as far as along the shortest way, at the inner side of the bend.
    const double shortest = airway.mouth + 0.5 * std::numbers::pi * (airway.bend - room);
    const double tip = -airway.bend - tube.tip().p_A.z();
    QVERIFY(tip > 0.2 - airway.mouth - 0.5 * std::numbers::pi * airway.bend - kDepth.si);
    QVERIFY(tip < 0.2 - shortest + kDepth.si);
}

void TestTubeInLumen::isStoppedByARing()
{
    QFETCH(double, inner_mm);
    const BentLumen airway;
    const TubeSize size = sizeOf(inner_mm);
    AirwayLumen lumen = airway.lumenFor(size.outerRadius());
    const std::size_t ring = lumen.glottis + 5;
    const LumenSection& narrow = narrowed(lumen, ring, size);
    TubeInLumen tube = tubeOf(size);
    feed(tube, unmoved(lumen), 0.22);
    QVERIFY(tube.tip().p_A.z() > narrow.p_A_centre.z());
    QVERIFY(tube.tip().p_A.z() < narrow.p_A_centre.z() + 0.006);
    QVERIFY(tube.tip().isStopped);
}

void TestTubeInLumen::isAsMeasuredOutside()
{
    constexpr double kSame = 1e-9; // metres
    const BentLumen airway;
    const TubeSize size = sizeOf(7.0);
    TubeInLumen tube = tubeOf(size);
    tube.step(fed(size, -0.05), unmoved(airway.lumenFor(size.outerRadius())));
    for (std::size_t i = 0; i < tube.measured().size(); ++i)
        QVERIFY((tube.constrained()[i] - tube.measured()[i]).norm() < kSame);
    QVERIFY(!tube.tip().isPastTeeth);
    QCOMPARE(tube.tip().seat, TubeSeat::None);
}

void TestTubeInLumen::isApartFromWhatIsMeasured()
{
    const BentLumen airway;
    const TubeSize size = sizeOf(7.0);
    TubeInLumen tube = tubeOf(size);
    feed(tube, unmoved(airway.lumenFor(size.outerRadius())), 0.2);
    QVERIFY(apart(tube) > millimetres(5.0));
}

/// As a tube that was made with that curve.
void TestTubeInLumen::hasTheCurveAtRestOfTheMoment()
{
    constexpr double kSame_m = 1e-6;
    const BentLumen airway;
    const MovedLumen lumen = unmoved(airway.lumenFor(sizeOf(7.0).outerRadius()));
    const TubeSize size = sizeOf(7.0);
    std::vector<Vec3> aside = restCurve(size);
    const Quat turn = rotationFromVector(Vec3{0.0, 0.0, 0.4});
    for (Vec3& p_E : aside)
        p_E = turn * p_E;
    TubeInLumen made{size, aside};
    TubeInLumen told = tubeOf(size);
    for (double inside = -0.02; inside < 0.2; inside += kFeed) {
        made.step(fed(size, inside), lumen);
        told.step(fed(size, inside), lumen, aside);
    }
    QVERIFY((told.measured().back() - made.measured().back()).norm() < kSame_m);
    QVERIFY((told.constrained().back() - made.constrained().back()).norm() < kSame_m);
    TubeInLumen other = tubeOf(size);
    feed(other, lumen, 0.2);
    QVERIFY((told.measured().back() - other.measured().back()).norm() > 0.01);
}

void TestTubeInLumen::isLaidAnewWhereItWasLost()
{
    // A tube in the shape of its airway that is first seen at its place.
    constexpr Length kNear = millimetres(3.0);
    const BentLumen airway;
    const TubeSize size = sizeOf(7.0);
    const AirwayLumen lumen = airway.lumenFor(size.outerRadius());
    std::vector<Vec3> p_E;
    const RigidTransform X_AE = RigidTransform::translation({0.0, -0.05, 0.0});
    p_E.push_back(Vec3::Zero());
    for (const LumenSection& section : lumen.ways.front())
        if (const Vec3 p = X_AE.inverse() * section.p_A_centre; p.y() > 0.02)
            p_E.push_back(p);
    TubeInLumen tube{size, p_E};
    for (int i = 0; i < 50; ++i)
        tube.step(X_AE, unmoved(lumen));
    QVERIFY(apart(tube) < kNear);
    QCOMPARE(tube.tip().seat, TubeSeat::Trachea);
}

void TestTubeInLumen::takesTheWayToWhichItsTipIsNearest()
{
    const TubeSize size = sizeOf(7.0);
    const std::vector<Vec3> line{Vec3::Zero(), -size.length.si * Vec3::UnitZ()};
    const MovedLumen lumen = unmoved(forked(size.outerRadius()));
    for (const bool isAside : {false, true}) {
        TubeInLumen tube{size, line};
        for (int i = 0; i <= 130; ++i) {
            const double y = -0.02 + 0.0015 * i;
            const double z = isAside ? 0.5 * std::max(y - 0.12, 0.0) : 0.0;
            tube.step(pointingAt(size, {0.0, std::max(y, 0.001), z}), lumen);
        }
        QCOMPARE(tube.tip().way, isAside ? AirwayWay::Oesophagus : AirwayWay::Trunk);
        QCOMPARE(tube.tip().seat, isAside ? TubeSeat::Oesophagus : TubeSeat::Trachea);
    }
}

void TestTubeInLumen::doesNotGoOverDeepInAWay()
{
    // In the trunk, and then its tip as measured is 2 cm beside it, where the branch is.
    const TubeSize size = sizeOf(7.0);
    const std::vector<Vec3> line{Vec3::Zero(), -size.length.si * Vec3::UnitZ()};
    const MovedLumen lumen = unmoved(forked(size.outerRadius()));
    TubeInLumen tube{size, line};
    for (int i = 0; i <= 150; ++i)
        tube.step(pointingAt(size, {0.0, std::max(-0.02 + 0.0015 * i, 0.001), 0.0}), lumen);
    for (int i = 0; i <= 20; ++i)
        tube.step(pointingAt(size, {0.0, 0.2, 0.001 * i}), lumen);
    QCOMPARE(tube.tip().way, AirwayWay::Trunk);
    QVERIFY(std::abs(tube.tip().p_A.z()) < 0.010 - size.outerRadius().si + kOutside.si);
}

void TestTubeInLumen::isFoundAgainInTheSameWay()
{
    // One pose beside the patient, as of a tracker that took another marker for it.
    const TubeSize size = sizeOf(7.0);
    const std::vector<Vec3> line{Vec3::Zero(), -size.length.si * Vec3::UnitZ()};
    const MovedLumen lumen = unmoved(forked(size.outerRadius()));
    TubeInLumen tube{size, line};
    const auto aside = [&](double y) {
        return pointingAt(size, {0.0, std::max(y, 0.001), 0.5 * std::max(y - 0.12, 0.0)});
    };
    for (int i = 0; i <= 120; ++i)
        tube.step(aside(-0.02 + 0.0015 * i), lumen);
    QCOMPARE(tube.tip().way, AirwayWay::Oesophagus);
    tube.step(RigidTransform::translation({0.3, 0.0, 0.0}) * aside(0.16), lumen);
    QVERIFY(!tube.tip().isPastTeeth);
    tube.step(aside(0.16), lumen);
    QCOMPARE(tube.tip().way, AirwayWay::Oesophagus);
}

/// Whatever its curve as measured says.
void TestTubeInLumen::liesInTheWayInWhichItIsFound()
{
    const TubeSize size = sizeOf(7.0);
    const std::vector<Vec3> line{Vec3::Zero(), -size.length.si * Vec3::UnitZ()};
    const MovedLumen lumen = unmoved(forked(size.outerRadius()));
    const Vec3 p_A_trunk{0.0, 0.16, 0.0};
    const Vec3 p_A_branch{0.0, 0.16, 0.02};
    TubeInLumen tube{size, line};
    tube.found(pointingAt(size, p_A_trunk), p_A_branch, false, lumen);
    QCOMPARE(tube.tip().way, AirwayWay::Oesophagus);
    tube.found(pointingAt(size, p_A_branch), p_A_trunk, false, lumen);
    QCOMPARE(tube.tip().way, AirwayWay::Trunk);
}

/// Also where its tip is known to a few millimetres.
void TestTubeInLumen::isFoundBeforeWhatHoldsItUpOrBehind()
{
    const TubeSize size = sizeOf(7.0);
    AirwayLumen lumen = BentLumen{}.lumenFor(size.outerRadius());
    const std::size_t ring = lumen.glottis + 5;
    const double z = narrowed(lumen, ring, size).p_A_centre.z();
    const Vec3 p_A_behind = lumen.ways.front()[ring + 1].p_A_centre; // by 4 mm
    for (const bool isHeldUp : {true, false}) {
        TubeInLumen tube = tubeOf(size);
        tube.found(fed(size, 0.21), p_A_behind, isHeldUp, unmoved(lumen));
        for (int i = 0; i < 60; ++i)
            tube.step(fed(size, 0.21), unmoved(lumen));
        QCOMPARE(tube.tip().isStopped, isHeldUp);
        QCOMPARE(tube.tip().p_A.z() > z, isHeldUp);
    }
}

void TestTubeInLumen::staysBehindAHandThatPushesItOn()
{
    constexpr Length kNear = millimetres(3.0);
    const BentLumen airway;
    const TubeSize size = sizeOf(7.0);
    AirwayLumen lumen = airway.lumenFor(size.outerRadius());
    narrowed(lumen, lumen.glottis + 5, size);
    TubeInLumen tube = tubeOf(size);
    feed(tube, unmoved(lumen), 0.19);
    const Length depth = tube.tip().depth;
    const Length back = tube.heldBack();
    feed(tube, unmoved(lumen), 0.21);
    QVERIFY(std::abs((tube.tip().depth - depth).si) < kNear.si);
    QVERIFY(std::abs((tube.heldBack() - back).si - 0.02) < kNear.si);
}

void TestTubeInLumen::givesTheSameBits()
{
    const BentLumen airway;
    const TubeSize size = sizeOf(7.0);
    const MovedLumen lumen = unmoved(airway.lumenFor(size.outerRadius()));
    TubeInLumen one = tubeOf(size);
    TubeInLumen other = tubeOf(size);
    feed(one, lumen, 0.15);
    feed(other, lumen, 0.15);
    for (std::size_t i = 0; i < one.constrained().size(); ++i)
        QVERIFY(one.constrained()[i] == other.constrained()[i]);
}

CARINA_TEST(TestTubeInLumen)

} // namespace carina::tube_in_lumen_test

#include "tst_tube_in_lumen.moc"
