#include "evaluation/intubation/way_walls.h"

#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/shapes/swept_surface.h"
#include "evaluation/intubation/tube_corridor.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::way_walls_test
{
namespace
{

constexpr double kMillimetre = 1e-3;
constexpr double kRod = 4.0 * kMillimetre; ///< radius
constexpr double kNear = 0.3 * kMillimetre;
constexpr Length kMost = millimetres(20.0);

/// Downwards, as the way in a pharynx: the front is -y.
const std::vector<Vec3> kLine{{0.0, 0.0, 0.1}, {0.0, 0.0, 0.0}};

AnatomyPart rodAt(const Vec3& beside, PartRole role)
{
    const std::array ends{Vec3{beside + 0.15 * Vec3::UnitZ()}, Vec3{beside - 0.05 * Vec3::UnitZ()}};
    std::vector<Ring> rings;
    for (int i = 0; i <= 20; ++i)
        rings.push_back({0.01 * i, kRod});
    return {"Rod", role, {}, {sweptSurface(sweptLine(ends), rings)}};
}

double distanceTo(const WallsAround& walls, WallSide side)
{
    return (walls.at(side) - pointAlong(kLine, metres(walls.along))).norm();
}

} // namespace

class TestWayWalls : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheNearestOnEachSide()
    {
        Anatomy anatomy;
        anatomy.parts = {rodAt({0.010, 0.0, 0.0}, PartRole::Mucosa),
                         rodAt({-0.012, 0.0, 0.0}, PartRole::Tooth),
                         rodAt({0.0, -0.014, 0.0}, PartRole::Tongue)};
        const auto walls = wallsAlong(anatomy, kLine, metres(0.01), metres(0.0905), kMost);
        QCOMPARE(walls.size(), std::size_t(21));
        for (const WallsAround& around : walls) {
            QVERIFY(std::abs(distanceTo(around, WallSide::Left) - 0.006) < kNear);
            QVERIFY(std::abs(distanceTo(around, WallSide::Right) - 0.008) < kNear);
            QVERIFY(std::abs(distanceTo(around, WallSide::Front) - 0.010) < kNear);
            QVERIFY(std::abs(distanceTo(around, WallSide::Back) - kMost.si) < 1e-12);
            QVERIFY(around.at(WallSide::Left).x() > 0.0);
            QVERIFY(around.at(WallSide::Front).y() < 0.0);
        }
    }

    void passesBonesBehindAndPlacesInside()
    {
        Anatomy anatomy;
        anatomy.parts = {rodAt({0.010, 0.0, 0.0}, PartRole::Spine)};
        for (const WallsAround& around :
             wallsAlong(anatomy, kLine, metres(0.0), metres(0.1), kMost))
            QVERIFY(std::abs(distanceTo(around, WallSide::Left) - kMost.si) < 1e-12);
        anatomy.parts = {rodAt({0.002, 0.0, 0.0}, PartRole::Pharynx)}; // around the line itself
        QVERIFY(wallsAlong(anatomy, kLine, metres(0.0), metres(0.1), kMost).empty());
    }

    void isRoundWhereATubeOpensItsWay()
    {
        for (const WallsAround& around :
             roundWalls(kLine, metres(0.02), metres(0.08), metres(0.007)))
            for (const WallSide side : kWallSides)
                QVERIFY(std::abs(distanceTo(around, side) - 0.007) < 1e-12);
    }

    /// Of the boy, in whom nothing lies in the way: the tongue's side goes with the jaw, and a
    /// corridor is narrower by the tube's radius.
    void leavesTheTubeMoreRoomAsTheJawOpens()
    {
        const auto boy = test::boyOfTubes();
        const TipWay& way = boy->way(TipTarget::Trachea);
        QVERIFY(!way.walls.empty());
        const auto corridor = [&](const RigidTransform& X_AJ, Length radius) {
            return tubeCorridor(*boy, way, {X_AJ},
                                {.held = way.teeth,
                                 .tip = way.fork,
                                 .p_A_tip = placeOnWay(*boy, way, way.fork, {X_AJ, {}})},
                                radius);
        };
        const RigidTransform open = RigidTransform::translation({0.0, 0.0, -0.01});
        const TubeCorridor shut = corridor({}, millimetres(4.0));
        const TubeCorridor thick = corridor({}, millimetres(5.0));
        const TubeCorridor opened = corridor(open, millimetres(4.0));
        QCOMPARE(shut.size(), opened.size());
        const std::size_t inMouth = shut.size() / 4;
        QVERIFY(opened[inMouth].most[1] - opened[inMouth].least[1]
                > shut[inMouth].most[1] - shut[inMouth].least[1] + 2.0 * kMillimetre);
        for (std::size_t i = 1; i + 1 < shut.size(); ++i)
            for (const std::size_t c : {0U, 1U}) {
                QVERIFY(shut[i].least[c] <= 0.0 && shut[i].most[c] >= 0.0);
                QVERIFY(thick[i].most[c] <= shut[i].most[c]);
            }
        QVERIFY(std::abs(shut[inMouth].most[0] - thick[inMouth].most[0] - kMillimetre) < 1e-9);
    }
};

CARINA_TEST(TestWayWalls)

} // namespace carina::way_walls_test

#include "tst_way_walls.moc"
