#include "evaluation/intubation/bent_tube.h"

#include "engine/anatomy/airway/centreline.h"
#include "engine/geometry/rotation.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::bent_tube_test
{
namespace
{

constexpr double kMillimetre = 1e-3;
constexpr double kOutOfPieces = 0.05 * kMillimetre; ///< what a curve of pieces is off
constexpr double kWide = 0.5;                       ///< metres

/// A straight tube, or one that bends towards -y as an arc, in the frame of its connector.
std::vector<Vec3> restOf(double length, double curvature)
{
    constexpr int kPieces = 200;
    std::vector<Vec3> p_E;
    for (int i = 0; i <= kPieces; ++i) {
        const double along = length * i / kPieces;
        const double turn = curvature * along;
        p_E.push_back(curvature > 0.0 ? Vec3{0.0, (std::cos(turn) - 1.0) / curvature,
                                             -std::sin(turn) / curvature}
                                      : Vec3{0.0, 0.0, -along});
    }
    return p_E;
}

/// Straight along +y from the origin, as wide as that to each side.
TubeCorridor straightCorridor(double length, double wide)
{
    constexpr int kPieces = 50;
    TubeCorridor corridor;
    for (int i = 0; i <= kPieces; ++i)
        corridor.push_back({.p_A = length * i / kPieces * Vec3::UnitY(),
                            .axes = acrossAxesOf(Vec3::UnitY()).value(),
                            .least = {-wide, -wide},
                            .most = {wide, wide}});
    return corridor;
}

/// The way of the boy's trachea from the teeth to a place, with a tube of 9 mm and the jaw a
/// centimetre lower.
TubeCorridor corridorOfBoy(double tip)
{
    const auto boy = test::boyOfTubes();
    const TipWay& way = boy->way(TipTarget::Trachea);
    const TissueAroundWay tissue{RigidTransform::translation({0.0, 0.0, -0.01}) * boy->held};
    return tubeCorridor(
        *boy, way, tissue,
        {.held = way.teeth, .tip = tip, .p_A_tip = placeOnWay(*boy, way, tip, {tissue.X_AJ, {}})},
        millimetres(4.5));
}

double sharpestTurn(const std::vector<Vec3>& line)
{
    double most = 0.0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Vec3 before = (line[i] - line[i - 1]).normalized();
        const Vec3 behind = (line[i + 1] - line[i]).normalized();
        most =
            std::max(most, 2.0 * (behind - before).norm()
                               / ((line[i] - line[i - 1]).norm() + (line[i + 1] - line[i]).norm()));
    }
    return most;
}

} // namespace

class TestBentTube : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// In the corridor 100 of 300 mm, and the connector 200 mm in front of it.
    void goesStraightOnInFrontOfAStraightCorridor()
    {
        const auto tube = bentTube(straightCorridor(0.1, kWide), restOf(0.3, 0.0), {});
        QVERIFY(tube);
        QVERIFY((tube->X_AE.translation() - Vec3{0.0, -0.2, 0.0}).norm() < 1e-9);
        QVERIFY((tube->X_AE.rotation() * Vec3::UnitZ() + Vec3::UnitY()).norm() < 1e-9);
        QVERIFY((tube->X_AE.rotation() * Vec3::UnitX() - Vec3::UnitX()).norm() < 1e-9);
        QVERIFY(std::abs(tube->outside.si - 0.2) < 1e-9);
    }

    /// The arc through both ends of a corridor without walls, continued to the connector: its
    /// chord of 100 mm takes 2 r asin(c / 2 r) of the tube.
    void liesAsAtRestWhereNothingTouchesIt()
    {
        constexpr double kRadius = 0.14;
        const double inside = 2.0 * kRadius * std::asin(0.05 / kRadius);
        const std::vector<Vec3> rest = restOf(0.3, 1.0 / kRadius);
        const auto tube = bentTube(straightCorridor(0.1, kWide), rest, {});
        QVERIFY(tube);
        QVERIFY(std::abs(tube->outside.si - (0.3 - inside)) < kOutOfPieces);
        QVERIFY((tube->X_AE * rest.back() - 0.1 * Vec3::UnitY()).norm() < kOutOfPieces);
        for (const Vec3& p_A : tube->p_A_inside) {
            double least = kWide;
            for (const Vec3& p_E : rest)
                least = std::min(least, (tube->X_AE * p_E - p_A).norm());
            QVERIFY(least < 1.0 * kMillimetre); // half a piece of the curve at rest
        }
        // In the plane x = 0, and bent to the feet.
        QVERIFY((tube->X_AE.rotation() * Vec3::UnitX() - Vec3::UnitX()).norm() < 1e-9);
        QVERIFY(tube->X_AE.translation().z() < -0.05);
    }

    void turnsWithTheRoll()
    {
        const std::vector<Vec3> rest = restOf(0.3, 5.0);
        const TubeCorridor wide = straightCorridor(0.1, kWide);
        const auto plain = bentTube(wide, rest, {});
        const auto rolled = bentTube(wide, rest, degrees(40.0));
        QVERIFY(plain && rolled);
        const RigidTransform turn{rotationFromVector(degrees(40.0).si * Vec3::UnitY()),
                                  Vec3::Zero()};
        QVERIFY(((turn * plain->X_AE).translation() - rolled->X_AE.translation()).norm()
                < kOutOfPieces);
    }

    /// A beam on two supports that is held aside by d in its middle has w = d (3 x / l - 4 x^3 /
    /// l^3) up to there, and leaves its support with the slope 3 d / l.
    void bendsAsABeamOverOneWall()
    {
        constexpr double kAside = 1.0 * kMillimetre;
        constexpr double kLength = 0.1;
        TubeCorridor corridor = straightCorridor(kLength, kWide);
        CorridorPlace& middle = corridor[corridor.size() / 2];
        middle.p_A += kAside * Vec3::UnitX();
        middle.least = middle.most = {0.0, 0.0};
        const auto tube = bentTube(corridor, restOf(0.3, 0.0), {});
        QVERIFY(tube);
        for (std::size_t i = 0; i <= corridor.size() / 2; ++i) {
            const double x = tube->p_A_inside[i].y() / kLength;
            const double w = kAside * (3.0 * x - 4.0 * x * x * x);
            QVERIFY(std::abs(tube->p_A_inside[i].x() - w) < 0.01 * kMillimetre);
        }
        const Vec3 outwards = tube->X_AE.rotation() * Vec3::UnitZ();
        const double slope = outwards.x() / outwards.y();
        QVERIFY(std::abs(slope - 3.0 * kAside / kLength) < 0.001);
    }

    void staysBetweenTheWallsOfItsWay()
    {
        const TipWay& way = test::boyOfTubes()->way(TipTarget::Trachea);
        const std::vector<Vec3> rest = restOf(0.3, 0.0);
        for (double tip = way.teeth + 0.04; tip < way.carina; tip += 0.007) {
            const TubeCorridor corridor = corridorOfBoy(tip);
            const auto tube = bentTube(corridor, rest, {});
            QVERIFY(tube);
            QCOMPARE(tube->p_A_inside.size(), corridor.size());
            for (std::size_t i = 0; i < corridor.size(); ++i) {
                const Vec3 aside =
                    corridor[i].axes.transpose() * (tube->p_A_inside[i] - corridor[i].p_A);
                for (const int c : {0, 1}) {
                    QVERIFY(aside[c] >= corridor[i].least[std::size_t(c)] - 1e-9);
                    QVERIFY(aside[c] <= corridor[i].most[std::size_t(c)] + 1e-9);
                }
            }
            QVERIFY((tube->p_A_inside.front() - corridor.front().p_A).norm() < 1e-12);
            QVERIFY((tube->p_A_inside.back() - corridor.back().p_A).norm() < 1e-12);
        }
    }

    /// The least energy of bending: no place of it is as sharply bent as the way, and what is in
    /// front of the teeth goes on without a bend.
    void isBentLessThanItsWay()
    {
        const TipWay& way = test::boyOfTubes()->way(TipTarget::Trachea);
        const std::vector<Vec3> rest = restOf(0.3, 0.0);
        const TubeCorridor corridor = corridorOfBoy(way.carina - 0.03);
        std::vector<Vec3> middle;
        for (const CorridorPlace& place : corridor)
            middle.push_back(place.p_A);
        const auto tube = bentTube(corridor, rest, {});
        QVERIFY(tube);
        QVERIFY(sharpestTurn(tube->p_A_inside) < sharpestTurn(middle));
        QVERIFY(lengthOf(tube->p_A_inside) < lengthOf(middle));
        const Vec3 first = (tube->p_A_inside[1] - tube->p_A_inside[0]).normalized();
        QVERIFY((tube->X_AE.rotation() * -Vec3::UnitZ() - first).norm() < 1e-9);
    }

    void isAsLongAsAtRest()
    {
        const TipWay& way = test::boyOfTubes()->way(TipTarget::Trachea);
        const std::vector<Vec3> rest = restOf(0.3, 7.0);
        for (double tip = way.teeth + 0.04; tip < way.carina; tip += 0.02) {
            const auto tube = bentTube(corridorOfBoy(tip), rest, {});
            QVERIFY(tube);
            const std::vector<Vec3> line = tube->line(rest);
            QVERIFY(std::abs(lengthOf(line).si - lengthOf(rest).si) < 1e-6);
            QVERIFY((line.front() - tube->X_AE.translation()).norm() < 1e-12);
        }
    }

    void refusesATubeThatIsShorterThanItsWay()
    {
        QVERIFY(bentTube(straightCorridor(0.1, kWide), restOf(0.101, 0.0), {}));
        QVERIFY(!bentTube(straightCorridor(0.1, kWide), restOf(0.099, 0.0), {}));
    }
};

CARINA_TEST(TestBentTube)

} // namespace carina::bent_tube_test

#include "tst_bent_tube.moc"
