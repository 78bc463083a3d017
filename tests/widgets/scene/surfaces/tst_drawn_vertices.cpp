#include "engine/geometry/rotation.h"
#include "engine/lungs/mechanics/lung_pair.h"
#include "tests/engine/lungs/drawing/lung_like_mesh.h"
#include "tests/support/deformed_tissue.h"
#include "tests/support/test_class.h"
#include "widgets/scene/surfaces/drawn_vertices.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <cmath>
#include <numbers>

namespace carina::drawn_vertices_test
{

namespace
{

using test::deformed;

/// Two roundings of a coordinate of up to a quarter metre, in single precision.
constexpr double kPositionTolerance_m = 6e-8;
constexpr double kNormalTolerance = 1e-6;
constexpr double kTurnedTwiceTolerance = 2e-5;  ///< likewise, by the chest and by the jaw
constexpr double kPushedTolerance_m = 2e-7;     ///< a few more of them
constexpr double kPushedNormalTolerance = 2e-4; ///< where tissue is pressed thin
constexpr double kChangedTolerance_m = 4e-7;    ///< one deformation more
constexpr double kChangedNormalTolerance = 5e-4;
constexpr double kBentTolerance_m = 1e-6; ///< sines of a graphics card are good to some 1e-6
constexpr double kBentNormalTolerance = 5e-3;
constexpr double kVolumeTolerance_ml = 0.1;

TriangleMesh lung(double x, std::uint32_t rings)
{
    return test::lungLikeMesh({x, 0.0, -0.02}, {0.045, 0.065, 0.09}, rings, 2 * rings);
}

Anatomy patient()
{
    Anatomy anatomy;
    anatomy.parts = {{"Right lung", PartRole::RightLung, {}, {lung(-0.06, 40), lung(-0.06, 12)}},
                     {"Left lung", PartRole::LeftLung, {}, {lung(0.06, 40), lung(0.06, 12)}}};
    return anatomy;
}

/// A throat in the lungs' place, so that all of its ramps run through them.
ThroatField throat() { return {{0.0, 0.03, -0.2}, {0.0, 0.0, -0.06}, {0.0, -0.07, 0.0}}; }

/// Opened by 20 degrees, brought forward and aside.
RigidTransform openJaw()
{
    return {rotationFromVector(degrees(20.0).si * Vec3::UnitX()), {0.003, -0.012, 0.03}};
}

constexpr double kThroughBothLungs_m = 0.1;
constexpr double kInfantsBlade_m = 0.012; ///< its contact is that of a narrow one

/// A blade of this width through the lungs there, and a larynx in their place.
BladeField bladeInLungs(double width = kThroughBothLungs_m, double x = 0.0)
{
    BladeField blade{{.reach = 0.12, .rise = 0.01, .sag = 0.02, .width = width},
                     {rotationFromVector(degrees(30.0).si * Vec3::UnitX()), {x, -0.04, 0.05}}};
    blade.tiltLarynx({.p_A = {0.0, 0.02, -0.08}, .behind = millimetres(60.0), .slope = 0.4},
                     millimetres(9.0));
    return blade;
}

/// An airway that is changed in every way, as large as both lungs.
AirwayField changesInLungs()
{
    const Lumen lumen{.p_A_front = {0.0, -0.06, -0.02},
                      .toWidest = millimetres(60.0),
                      .halfInFront = millimetres(40.0),
                      .halfAtWidest = millimetres(55.0),
                      .outer = 2.0};
    AirwayField airway;
    airway.closeCords(lumen, 0.2);
    airway.joinCords(lumen, 0.15);
    airway.narrowVestibule(lumen, 0.1);
    airway.narrowPharynx(lumen, 0.3);
    airway.narrowWindpipe(lumen, 0.2);
    airway.flattenWindpipe(lumen, 0.25);
    airway.swell({.p_A_centre = {0.05, 0.01, -0.03},
                  .axis_A = Vec3{1.0, 2.0, 3.0}.normalized(),
                  .across = millimetres(60.0),
                  .along = millimetres(80.0),
                  .outward = millimetres(15.0),
                  .shift_A = {0.004, 0.008, -0.01},
                  .depth = millimetres(5.0)});
    airway.swell(
        {.p_A_centre = {-0.06, 0.0, 0.0},
         .axis_A = Vec3::UnitY(),
         .across = millimetres(70.0),
         .along = millimetres(50.0),
         .outward = millimetres(20.0),
         .depth = millimetres(8.0),
         .isFlat = true,
         .tissues = AirwayTissues(only(AirwayTissue::Throat) | only(AirwayTissue::Larynx))});
    for (std::size_t n = 2; n < kMostSwellings; ++n)
        airway.swell({.p_A_centre = {0.015 * (double(n) - 8.5), 0.0, -0.01},
                      .across = millimetres(40.0),
                      .along = millimetres(50.0),
                      .outward = millimetres(2.0),
                      .shift_A = {0.0, 0.001, 0.001},
                      .tissues = kAllAirwayTissues});
    return airway;
}

/// A neck as large as both lungs, with both bends in them.
NeckField bentNeck() { return {{0.0, -0.04, -0.01}, {0.0, -0.11, 0.04}, kSniffing}; }

} // namespace

class TestDrawnVertices : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsAsTheReferenceDeforms_data();
    void drawsAsTheReferenceDeforms();
    void drawsTheThroatAsTheReferenceFollows_data();
    void drawsTheThroatAsTheReferenceFollows();
    void drawsWhatABladePushesAsTheReference_data();
    void drawsWhatABladePushesAsTheReference();
    void drawsWhatEventsChangeAsTheReference_data();
    void drawsWhatEventsChangeAsTheReference();
    void drawsABentNeckAsTheReference_data();
    void drawsABentNeckAsTheReference();
    void movesAlikeInEveryForm_data();
    void movesAlikeInEveryForm();
    void leavesRestExactlyAsItIs();
    void keepsEveryOtherRegionFromTheJaw();
    void keepsEveryOtherRegionFromEvents();
    void bendsNoNeckWithoutItsShader();
    void followsTheCommandedVolume();
    void leavesTheContextThatWasCurrent();
    void movesWithItsUploadedMesh();
};

void TestDrawnVertices::drawsAsTheReferenceDeforms_data()
{
    QTest::addColumn<ChestRegion>("region");
    QTest::addColumn<ChestPose>("pose");
    const auto both = [](const LungPose& lung) { return ChestPose{{lung, lung}, 0.0}; };
    QTest::newRow("below rest") << ChestRegion::RightUpperLung << both(-1.0 * kQuietBreath);
    QTest::newRow("an odd share") << ChestRegion::LeftLowerLung << both(1.2345678 * kQuietBreath);
    QTest::newRow("a deep breath") << ChestRegion::RightLowerLung << both(7.0 * kQuietBreath);
    const ChestPose unlike{{LungPose{1.0, 0.5, 0.3, 0.2}, LungPose{3.0, 1.0, -0.2, 0.1}}, 0.1};
    QTest::newRow("two lungs") << ChestRegion::Bronchi << unlike;
    QTest::newRow("ribs") << ChestRegion::Wall << unlike;
    QTest::newRow("heart") << ChestRegion::Mediastinum << unlike;
}

void TestDrawnVertices::drawsAsTheReferenceDeforms()
{
    QFETCH(ChestRegion, region);
    QFETCH(ChestPose, pose);
    const LungPair lungs = LungPair::of(patient()).value();
    const ChestMotion motion = motionOf(region, pose, lungs.field());
    for (const BreathingPart& part : lungs.parts()) {
        const TriangleMesh& mesh = part.levels.front();
        Result<DrawnVertices> drawn = DrawnVertices::of(mesh);
        QVERIFY2(drawn.has_value(), drawn ? "" : drawn.error().detail.c_str());
        const TriangleMesh reference = deformed(mesh, lungs.field(), motion);
        const auto [positions, normals] = drawn->at(lungs.field(), motion).value();
        QCOMPARE(positions.size(), reference.positions.size());
        QCOMPARE(normals.size(), reference.normals.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            QVERIFY((positions[i] - reference.positions[i]).cwiseAbs().maxCoeff()
                    < kPositionTolerance_m);
            QVERIFY((normals[i] - reference.normals[i]).norm() < kNormalTolerance);
        }
    }
}

void TestDrawnVertices::drawsTheThroatAsTheReferenceFollows_data()
{
    QTest::addColumn<ChestRegion>("region");
    QTest::newRow("trachea and heart") << ChestRegion::Mediastinum;
    QTest::newRow("tongue and larynx") << ChestRegion::Throat;
    QTest::newRow("pharynx") << ChestRegion::Pharynx;
}

void TestDrawnVertices::drawsTheThroatAsTheReferenceFollows()
{
    constexpr float kMoved_m = 0.005F;
    QFETCH(ChestRegion, region);
    const ChestPose breath{{LungPose{1.0, 0.5, 0.3, 0.2}, LungPose{3.0, 1.0, -0.2, 0.1}}, 0.1};
    const LungPair lungs = LungPair::of(patient()).value();
    const ChestMotion motion = motionOf(region, breath, lungs.field());
    const FollowingThroat following{throat(), openJaw()};
    for (const BreathingPart& part : lungs.parts()) {
        const TriangleMesh& mesh = part.levels.front();
        DrawnVertices drawn = DrawnVertices::of(mesh, region).value();
        const TriangleMesh reference =
            deformed(deformed(mesh, lungs.field(), motion), following, *tissueOf(region));
        const auto [positions, normals] = drawn.at(lungs.field(), motion, following).value();
        float furthest = 0.0F;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            QVERIFY((positions[i] - reference.positions[i]).cwiseAbs().maxCoeff()
                    < kPositionTolerance_m);
            QVERIFY((normals[i] - reference.normals[i]).norm() < kTurnedTwiceTolerance);
            furthest = std::max(furthest, (positions[i] - mesh.positions[i]).norm());
        }
        QVERIFY(furthest > kMoved_m);
    }
}

void TestDrawnVertices::drawsWhatABladePushesAsTheReference_data()
{
    QTest::addColumn<ChestRegion>("region");
    QTest::addColumn<double>("width");
    QTest::newRow("tongue") << ChestRegion::Throat << kThroughBothLungs_m;
    QTest::newRow("tongue of an infant") << ChestRegion::Throat << kInfantsBlade_m;
    QTest::newRow("pharynx") << ChestRegion::Pharynx << kThroughBothLungs_m;
    QTest::newRow("larynx and epiglottis") << ChestRegion::Larynx << kThroughBothLungs_m;
}

void TestDrawnVertices::drawsWhatABladePushesAsTheReference()
{
    constexpr float kMoved_m = 0.005F;
    QFETCH(ChestRegion, region);
    QFETCH(double, width);
    const LungPair lungs = LungPair::of(patient()).value();
    const FollowingThroat following{throat(), openJaw()};
    for (const BreathingPart& part : lungs.parts()) {
        const double middle = boundsOf(part.levels.front()).centre().x();
        const BladeField blade = bladeInLungs(width, width < kThroughBothLungs_m ? middle : 0.0);
        const TriangleMesh& mesh = part.levels.front();
        DrawnVertices drawn = DrawnVertices::of(mesh, region).value();
        const TriangleMesh followed = deformed(mesh, following, *tissueOf(region));
        const TriangleMesh reference = deformed(followed, blade, *airwayTissueOf(region));
        const auto [positions, normals] = drawn.at(lungs.field(), {}, following, blade).value();
        float furthest = 0.0F;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            QVERIFY((positions[i] - reference.positions[i]).cwiseAbs().maxCoeff()
                    < kPushedTolerance_m);
            QVERIFY((normals[i] - reference.normals[i]).norm() < kPushedNormalTolerance);
            furthest = std::max(furthest, (positions[i] - followed.positions[i]).norm());
        }
        QVERIFY(furthest > kMoved_m);
    }
}

void TestDrawnVertices::drawsWhatEventsChangeAsTheReference_data()
{
    QTest::addColumn<ChestRegion>("region");
    QTest::newRow("loose tooth") << ChestRegion::LooseTooth;
    QTest::newRow("teeth") << ChestRegion::Teeth;
    QTest::newRow("skin") << ChestRegion::Skin;
    QTest::newRow("trachea") << ChestRegion::Mediastinum;
    QTest::newRow("tongue") << ChestRegion::Throat;
    QTest::newRow("pharynx") << ChestRegion::Pharynx;
    QTest::newRow("larynx and epiglottis") << ChestRegion::Larynx;
}

// Changed first, then moved by the jaw and by a blade, where these move it.
void TestDrawnVertices::drawsWhatEventsChangeAsTheReference()
{
    constexpr float kMoved_m = 0.005F;
    QFETCH(ChestRegion, region);
    const LungPair lungs = LungPair::of(patient()).value();
    const FollowingThroat following{throat(), openJaw()};
    const BladeField blade = bladeInLungs();
    const AirwayField airway = changesInLungs();
    for (const BreathingPart& part : lungs.parts()) {
        const TriangleMesh& mesh = part.levels.front();
        DrawnVertices drawn = DrawnVertices::of(mesh, region).value();
        const AirwayTissue tissue = *airwayTissueOf(region);
        const TriangleMesh changed = deformed(mesh, airway, tissue);
        const auto ofJaw = tissueOf(region);
        const TriangleMesh followed = ofJaw ? deformed(changed, following, *ofJaw) : changed;
        const TriangleMesh reference = deformed(followed, blade, tissue);
        const auto [positions, normals] =
            drawn.at(lungs.field(), {}, following, blade, airway).value();
        float furthest = 0.0F;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            QVERIFY((positions[i] - reference.positions[i]).cwiseAbs().maxCoeff()
                    < kChangedTolerance_m);
            QVERIFY((normals[i] - reference.normals[i]).norm() < kChangedNormalTolerance);
            furthest = std::max(furthest, (changed.positions[i] - mesh.positions[i]).norm());
        }
        QVERIFY(furthest > kMoved_m);
    }
}

void TestDrawnVertices::drawsABentNeckAsTheReference_data()
{
    QTest::addColumn<ChestRegion>("region");
    QTest::newRow("spine and skull") << ChestRegion::Still;
    QTest::newRow("skin") << ChestRegion::Wall;
    QTest::newRow("trachea") << ChestRegion::Mediastinum;
    QTest::newRow("tongue") << ChestRegion::Throat;
    QTest::newRow("pharynx") << ChestRegion::Pharynx;
    QTest::newRow("larynx and epiglottis") << ChestRegion::Larynx;
}

// Changed by events, bent, then moved by the jaw in the frame of the head and by a blade in A.
void TestDrawnVertices::drawsABentNeckAsTheReference()
{
    constexpr float kMoved_m = 0.005F;
    QFETCH(ChestRegion, region);
    const LungPair lungs = LungPair::of(patient()).value();
    // Opened by little: the jaw's shares are not where this neck has its head.
    const RigidTransform X_UJ{rotationFromVector(degrees(5.0).si * Vec3::UnitX()),
                              {0.001, -0.004, 0.003}};
    const FollowingThroat following{throat(), X_UJ, bentNeck()};
    const BladeField blade = bladeInLungs();
    const AirwayField airway = changesInLungs();
    const auto tissue = airwayTissueOf(region);
    for (const BreathingPart& part : lungs.parts()) {
        const TriangleMesh& mesh = part.levels.front();
        DrawnVertices drawn = DrawnVertices::of(mesh, region).value();
        const TriangleMesh changed = tissue ? deformed(mesh, airway, *tissue) : mesh;
        const TriangleMesh bent = deformed(changed, following.neck);
        const auto follows = tissueOf(region);
        const TriangleMesh followed = follows ? deformed(bent, following, *follows) : bent;
        const TriangleMesh reference = tissue ? deformed(followed, blade, *tissue) : followed;
        const auto [positions, normals] =
            drawn.at(lungs.field(), {}, following, blade, airway).value();
        float furthest = 0.0F;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            QVERIFY((positions[i] - reference.positions[i]).cwiseAbs().maxCoeff()
                    < kBentTolerance_m);
            QVERIFY((normals[i] - reference.normals[i]).norm() < kBentNormalTolerance);
            furthest = std::max(furthest, (bent.positions[i] - changed.positions[i]).norm());
        }
        QVERIFY(furthest > kMoved_m);
    }
}

void TestDrawnVertices::movesAlikeInEveryForm_data()
{
    QTest::addColumn<bool>("many");
    QTest::addColumn<bool>("movesJaw");
    QTest::newRow("many regions, no jaw") << true << false;
    QTest::newRow("one region") << false << true;
    QTest::newRow("one region, no jaw") << false << false;
}

void TestDrawnVertices::movesAlikeInEveryForm()
{
    QFETCH(bool, many);
    QFETCH(bool, movesJaw);
    const ChestPose breath{{LungPose{1.0, 0.5, 0.3, 0.2}, LungPose{3.0, 1.0, -0.2, 0.1}}, 0.1};
    const LungPair lungs = LungPair::of(patient()).value();
    const TriangleMesh& mesh = lungs.parts().front().levels.front();
    const FollowingThroat throats{throat(), movesJaw ? openJaw() : RigidTransform{}};
    for (const ChestRegion region : {ChestRegion::RightUpperLung, ChestRegion::Pharynx}) {
        const ChestMotion motion = motionOf(region, breath, lungs.field());
        DrawnVertices full = DrawnVertices::of(mesh, region).value();
        DrawnVertices form =
            DrawnVertices::of(mesh, region, {.hasManyRegions = many, .movesJaw = movesJaw}).value();
        const auto [wanted, wantedNormals] = full.at(lungs.field(), motion, throats).value();
        const auto [drawn, normals] = form.at(lungs.field(), motion, throats).value();
        QCOMPARE(wanted != mesh.positions, movesJaw || region == ChestRegion::RightUpperLung);
        QVERIFY(drawn == wanted);
        QVERIFY(normals == wantedNormals);
    }
}

void TestDrawnVertices::leavesRestExactlyAsItIs()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const TriangleMesh& mesh = lungs.parts().front().levels.front();
    Result<DrawnVertices> drawn = DrawnVertices::of(mesh);
    QVERIFY(drawn.has_value());
    QVERIFY(drawn->at(lungs.field(), {}).value().positions == mesh.positions);
    for (const ChestRegion region :
         {ChestRegion::Mediastinum, ChestRegion::Throat, ChestRegion::Pharynx}) {
        DrawnVertices closed = DrawnVertices::of(mesh, region).value();
        QVERIFY(closed.at(lungs.field(), {}, {throat(), {}}).value().positions == mesh.positions);
        QVERIFY(closed.at(lungs.field(), {}, {throat(), {}}).value().normals
                == drawn->at(lungs.field(), {}).value().normals);
    }
}

// So their volumes are what they are while the mouth is closed.
void TestDrawnVertices::keepsEveryOtherRegionFromTheJaw()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const ChestPose breath = lungs.pose(millilitres(300.0), 0).value();
    const TriangleMesh& mesh = lungs.parts().front().levels.front();
    for (std::size_t n = 0; n < kChestRegions; ++n) {
        const auto region = static_cast<ChestRegion>(n);
        if (tissueOf(region))
            continue;
        DrawnVertices drawn = DrawnVertices::of(mesh, region).value();
        const ChestMotion motion = motionOf(region, breath, lungs.field());
        QVERIFY(drawn.at(lungs.field(), motion, {throat(), openJaw()}).value().positions
                == drawn.at(lungs.field(), motion).value().positions);
    }
}

void TestDrawnVertices::keepsEveryOtherRegionFromEvents()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const TriangleMesh& mesh = lungs.parts().front().levels.front();
    for (std::size_t n = 0; n < kChestRegions; ++n) {
        const auto region = static_cast<ChestRegion>(n);
        DrawnVertices drawn = DrawnVertices::of(mesh, region).value();
        const auto changed = drawn.at(lungs.field(), {}, {}, {}, changesInLungs()).value();
        QCOMPARE(changed.positions != mesh.positions, airwayTissueOf(region).has_value());
        DrawnVertices without = DrawnVertices::of(mesh, region, {.changesAirway = false}).value();
        QVERIFY(without.at(lungs.field(), {}, {}, {}, changesInLungs()).value().positions
                == mesh.positions);
    }
}

void TestDrawnVertices::bendsNoNeckWithoutItsShader()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const TriangleMesh& mesh = lungs.parts().front().levels.front();
    const FollowingThroat bent{throat(), {}, bentNeck()};
    DrawnVertices with = DrawnVertices::of(mesh).value();
    QVERIFY(with.at(lungs.field(), {}, bent).value().positions != mesh.positions);
    QVERIFY(with.at(lungs.field(), {}, {throat(), {}}).value().positions == mesh.positions);
    DrawnVertices without =
        DrawnVertices::of(mesh, ChestRegion::Still, {.bendsNeck = false}).value();
    QVERIFY(without.at(lungs.field(), {}, bent).value().positions == mesh.positions);
}

// Two breaths of 280 ml, in 380 frames.
void TestDrawnVertices::followsTheCommandedVolume()
{
    const LungPair lungs = LungPair::of(patient()).value();
    for (std::size_t level = 0; level < lungs.levelCount(); ++level) {
        for (const BreathingPart& part : lungs.parts()) {
            TriangleMesh surface = levelOf(part, level);
            Result<DrawnVertices> drawn = DrawnVertices::of(surface);
            QVERIFY(drawn.has_value());
            for (int frame = 0; frame <= 379; ++frame) {
                const double phase = 2.0 * std::numbers::pi * frame / 190.0;
                const Volume inspired = millilitres(140.0 * (1.0 - std::cos(phase)));
                const ChestPose pose = lungs.pose(inspired, level).value();
                surface.positions =
                    drawn->at(lungs.field(), motionOf(part.region, pose, lungs.field()))
                        .value()
                        .positions;
                const double error_ml = 1e6 * test::volumeByColumns(surface)
                                        - inMillilitres(lungs.volumeWith(inspired, part.side));
                QVERIFY(std::abs(error_ml) < kVolumeTolerance_ml);
            }
        }
    }
}

void TestDrawnVertices::leavesTheContextThatWasCurrent()
{
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext viewer;
    QVERIFY(viewer.create() && viewer.makeCurrent(&surface));
    {
        const LungPair lungs = LungPair::of(patient()).value();
        Result<DrawnVertices> drawn = DrawnVertices::of(lungs.parts().front().levels.back());
        QVERIFY(drawn.has_value());
        QCOMPARE(QOpenGLContext::currentContext(), &viewer);
        QVERIFY(drawn->at(lungs.field(), {}).has_value());
        QCOMPARE(QOpenGLContext::currentContext(), &viewer);
    }
    QCOMPARE(QOpenGLContext::currentContext(), &viewer);
    viewer.doneCurrent();
    const LungPair lungs = LungPair::of(patient()).value();
    QVERIFY(
        DrawnVertices::of(lungs.parts().front().levels.back())->at(lungs.field(), {}).has_value());
    QVERIFY(QOpenGLContext::currentContext() == nullptr);
}

void TestDrawnVertices::movesWithItsUploadedMesh()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const TriangleMesh& right = lungs.parts()[0].levels.back();
    const TriangleMesh& left = lungs.parts()[1].levels.back();
    std::vector<DrawnVertices> both;
    both.push_back(DrawnVertices::of(right).value());
    both.push_back(DrawnVertices::of(left).value());
    QVERIFY(both[0].at(lungs.field(), {}).value().positions == right.positions);
    QVERIFY(both[1].at(lungs.field(), {}).value().positions == left.positions);
    both[0] = std::move(both[1]);
    QVERIFY(both[0].at(lungs.field(), {}).value().positions == left.positions);
}

CARINA_SCREEN_TEST(TestDrawnVertices)

} // namespace carina::drawn_vertices_test

#include "tst_drawn_vertices.moc"
