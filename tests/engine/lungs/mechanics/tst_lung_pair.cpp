#include "engine/lungs/mechanics/lung_pair.h"
#include "tests/engine/lungs/drawing/lung_like_mesh.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::lung_pair_test
{

namespace
{

constexpr double kTolerance_ml = 1e-3;

AnatomyPart partOf(const char* name, PartRole role, std::vector<TriangleMesh> levels)
{
    return {name, role, {}, std::move(levels)};
}

TriangleMesh lung(double x, double halfHeight, std::uint32_t rings)
{
    return test::lungLikeMesh({x, 0.0, -0.02}, {0.055, 0.08, halfHeight}, rings, 2 * rings);
}

/// A right lung of two lobes in three levels, a left lung whole in two, and a trachea between.
Anatomy patient()
{
    const auto lobe = [](double z, std::uint32_t rings) {
        return test::lungLikeMesh({-0.07, 0.0, z}, {0.055, 0.08, 0.06}, rings, 2 * rings);
    };
    Anatomy anatomy;
    anatomy.parts = {
        partOf("Upper lobe", PartRole::RightUpperLobe,
               {lobe(0.045, 24), lobe(0.045, 12), lobe(0.045, 8)}),
        partOf("Trachea", PartRole::Trachea, {lung(0.0, 0.02, 8)}),
        partOf("Left lung", PartRole::LeftLung, {lung(0.07, 0.11, 24), lung(0.07, 0.11, 12)}),
        partOf("Lower lobe", PartRole::RightLowerLobe,
               {lobe(-0.075, 24), lobe(-0.075, 12), lobe(-0.075, 8)}),
    };
    return anatomy;
}

/// Volume of one lung as its deformed vertices enclose it.
double drawnVolume_ml(const LungPair& lungs, Side side, std::size_t level, const ChestPose& pose)
{
    double volume = 0.0;
    for (const BreathingPart& part : lungs.parts()) {
        if (part.side == side)
            volume += test::volumeByColumns(deformed(levelOf(part, level), lungs.field(),
                                                     motionOf(part.region, pose, lungs.field())));
    }
    return 1e6 * volume;
}

} // namespace

class TestLungPair : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesOnlyTheLungsOfAnAnatomy();
    void restsAtTheVolumeOfItsFinestLevel();
    void drawsTheVolumeAskedForAtEveryLevel_data();
    void drawsTheVolumeAskedForAtEveryLevel();
    void dividesGasAsTheLungsDivideTheVolumeAtRest();
    void isAtRestWithoutInspiredGas();
    void reachesNoVolumeBeyondWhatAnatomyAllows();
    void namesAPartThatIsOpen_data();
    void namesAPartThatIsOpen();
    void breathesWithTheOneLungThereIs();
    void hasNothingToBreatheWithWithoutLungs();
    void drawsVolumesInAnyPoseThatIsGiven_data();
    void drawsVolumesInAnyPoseThatIsGiven();
    void refusesPosesOutsideTheRange();
    void holdsTheHilumStill();
};

void TestLungPair::takesOnlyTheLungsOfAnAnatomy()
{
    const LungPair lungs = LungPair::of(patient()).value();
    QCOMPARE(lungs.parts().size(), std::size_t(3));
    QCOMPARE(lungs.levelCount(), std::size_t(3));
    const std::array<std::pair<std::size_t, Side>, 3> expected{
        {{0, Side::Right}, {3, Side::Right}, {2, Side::Left}}};
    for (std::size_t n = 0; n < expected.size(); ++n) {
        QCOMPARE(lungs.parts()[n].index, expected[n].first);
        QCOMPARE(lungs.parts()[n].side, expected[n].second);
    }
    const BreathingPart& left = lungs.parts()[2];
    QCOMPARE(&levelOf(left, 0), &left.levels[0]);
    QCOMPARE(&levelOf(left, 1), &left.levels[1]);
    QCOMPARE(&levelOf(left, 2), &left.levels[1]);
}

void TestLungPair::restsAtTheVolumeOfItsFinestLevel()
{
    const LungPair lungs = LungPair::of(patient()).value();
    for (const Side side : {Side::Right, Side::Left}) {
        const double rest_ml = inMillilitres(lungs.restVolume(side));
        QVERIFY(rest_ml > 500.0);
        QVERIFY(std::abs(rest_ml - drawnVolume_ml(lungs, side, 0, {})) < kTolerance_ml);
    }
}

void TestLungPair::drawsTheVolumeAskedForAtEveryLevel_data()
{
    QTest::addColumn<double>("inspired_ml");
    QTest::newRow("at rest") << 0.0;
    QTest::newRow("child") << 280.0;
    QTest::newRow("adult") << 540.0;
    QTest::newRow("three breaths of a child") << 840.0;
    QTest::newRow("below rest") << -60.0;
}

void TestLungPair::drawsTheVolumeAskedForAtEveryLevel()
{
    QFETCH(double, inspired_ml);
    const LungPair lungs = LungPair::of(patient()).value();
    const Volume inspired = millilitres(inspired_ml);
    double both_ml = 0.0;
    for (std::size_t level = 0; level < lungs.levelCount(); ++level) {
        const Result<ChestPose> pose = lungs.pose(inspired, level);
        QVERIFY(pose.has_value());
        const double right_ml = drawnVolume_ml(lungs, Side::Right, level, *pose);
        const double left_ml = drawnVolume_ml(lungs, Side::Left, level, *pose);
        QVERIFY(std::abs(right_ml - inMillilitres(lungs.volumeWith(inspired, Side::Right)))
                < kTolerance_ml);
        QVERIFY(std::abs(left_ml - inMillilitres(lungs.volumeWith(inspired, Side::Left)))
                < kTolerance_ml);
        both_ml = right_ml + left_ml;
    }
    const Volume frc = lungs.restVolume(Side::Right) + lungs.restVolume(Side::Left);
    QVERIFY(std::abs(both_ml - inMillilitres(frc) - inspired_ml) < 2.0 * kTolerance_ml);
}

void TestLungPair::dividesGasAsTheLungsDivideTheVolumeAtRest()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const Volume inspired = millilitres(300.0);
    const double right = (lungs.volumeWith(inspired, Side::Right) - lungs.restVolume(Side::Right))
                         / lungs.restVolume(Side::Right);
    const double left = (lungs.volumeWith(inspired, Side::Left) - lungs.restVolume(Side::Left))
                        / lungs.restVolume(Side::Left);
    QVERIFY(right > 0.0);
    QVERIFY(std::abs(right - left) < 1e-12);
}

void TestLungPair::isAtRestWithoutInspiredGas()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const ChestPose pose = lungs.pose(Volume{}, 0).value();
    QVERIFY(std::abs(pose.lungs[0].diaphragm) < 1e-9);
    QVERIFY(std::abs(pose.lungs[1].diaphragm) < 1e-9);
}

void TestLungPair::reachesNoVolumeBeyondWhatAnatomyAllows()
{
    const LungPair lungs = LungPair::of(patient()).value();
    for (const double inspired_ml : {20000.0, -20000.0}) {
        const Result<ChestPose> pose = lungs.pose(millilitres(inspired_ml), 0);
        QVERIFY(!pose);
        QCOMPARE(pose.error().code, Errc::VolumeUnreachable);
    }
}

void TestLungPair::namesAPartThatIsOpen_data()
{
    QTest::addColumn<TriangleMesh>("level");
    TriangleMesh holed = lung(0.07, 0.11, 12);
    holed.triangles.pop_back();
    QTest::newRow("with a hole") << holed;
    TriangleMesh inward = lung(0.07, 0.11, 12);
    for (Triangle& t : inward.triangles)
        std::swap(t[0], t[1]);
    QTest::newRow("facing inward") << inward;
    TriangleMesh flat;
    flat.positions = {{0.0F, 0.0F, 0.0F}, {0.1F, 0.0F, 0.0F}, {0.0F, 0.1F, 0.0F}};
    flat.triangles = {{0, 1, 2}, {0, 2, 1}};
    QTest::newRow("flat, both sides of a sheet") << flat;
    QTest::newRow("empty") << TriangleMesh{};
}

void TestLungPair::namesAPartThatIsOpen()
{
    QFETCH(TriangleMesh, level);
    Anatomy anatomy = patient();
    anatomy.parts[2].levels[1] = level;
    const Result<LungPair> lungs = LungPair::of(anatomy);
    QVERIFY(!lungs);
    QCOMPARE(lungs.error(), (Error{Errc::MeshNotClosed, "Left lung"}));
}

void TestLungPair::breathesWithTheOneLungThereIs()
{
    Anatomy anatomy = patient();
    anatomy.parts.resize(2);
    const LungPair lungs = LungPair::of(anatomy).value();
    QCOMPARE(lungs.restVolume(Side::Left).si, 0.0);
    const ChestPose pose = lungs.pose(millilitres(100.0), 0).value();
    QCOMPARE(pose.lungs[1], LungPose{});
    const double gain_ml =
        drawnVolume_ml(lungs, Side::Right, 0, pose) - drawnVolume_ml(lungs, Side::Right, 0, {});
    QVERIFY(std::abs(gain_ml - 100.0) < kTolerance_ml);
}

void TestLungPair::hasNothingToBreatheWithWithoutLungs()
{
    const LungPair lungs = LungPair::of(Anatomy{}).value();
    QVERIFY(lungs.parts().empty());
    QCOMPARE(lungs.levelCount(), std::size_t(0));
    QCOMPARE(lungs.restVolume(Side::Right).si, 0.0);
    QCOMPARE(lungs.volumeWith(millilitres(300.0), Side::Left).si, 0.0);
    const ChestPose pose = lungs.pose(millilitres(300.0), 0).value();
    QCOMPARE(pose, ChestPose{});
}

void TestLungPair::drawsVolumesInAnyPoseThatIsGiven_data()
{
    QTest::addColumn<LungPose>("given");
    QTest::addColumn<LungPose>("along");
    QTest::addColumn<double>("shift");
    QTest::addColumn<double>("inspired_ml");
    constexpr LungPose kDown{.diaphragm = 1.0};
    QTest::newRow("by the diaphragm alone") << LungPose{} << kDown << 0.0 << 150.0;
    QTest::newRow("with ribs as given") << LungPose{.ribs = 2.0} << kDown << 0.0 << 300.0;
    QTest::newRow("face down") << LungPose{.gravity = -1.5} << kDown << 0.0 << 100.0;
    QTest::newRow("with air trapped") << LungPose{.collapse = -0.05} << kDown << 0.0 << 850.0;
    QTest::newRow("collapsed") << LungPose{.ribs = 0.2} << LungPose{.collapse = 1.0} << 0.0
                               << -900.0;
    QTest::newRow("beside a shifted heart") << LungPose{.ribs = 0.5} << kDown << 0.1 << 100.0;
}

void TestLungPair::drawsVolumesInAnyPoseThatIsGiven()
{
    QFETCH(LungPose, given);
    QFETCH(LungPose, along);
    QFETCH(double, shift);
    QFETCH(double, inspired_ml);
    const LungPair lungs = LungPair::of(patient()).value();
    std::array<LungDemand, 2> demands;
    for (const Side side : {Side::Right, Side::Left})
        demands[indexOf(side)] = {lungs.volumeWith(millilitres(inspired_ml), side), given, along};
    const Result<ChestPose> pose = lungs.pose(demands, shift, 1);
    QVERIFY2(pose.has_value(), pose ? "" : pose.error().detail.c_str());
    QCOMPARE(pose->mediastinalShift, shift);
    QVERIFY(rangeTaken(*pose) <= 1.0);
    for (const Side side : {Side::Right, Side::Left}) {
        const double drawn_ml = drawnVolume_ml(lungs, side, 1, *pose);
        QVERIFY(std::abs(drawn_ml - inMillilitres(demands[indexOf(side)].volume)) < kTolerance_ml);
        const LungPose& lung = pose->lungs[indexOf(side)];
        QCOMPARE(lung.ribs, given.ribs);
        QCOMPARE(lung.gravity, given.gravity);
        if (along.collapse == 0.0)
            QCOMPARE(lung.collapse, given.collapse);
        else
            QCOMPARE(lung.diaphragm, given.diaphragm);
    }
}

void TestLungPair::refusesPosesOutsideTheRange()
{
    const LungPair lungs = LungPair::of(patient()).value();
    std::array<LungDemand, 2> demands;
    for (const Side side : {Side::Right, Side::Left})
        demands[indexOf(side)].volume = lungs.restVolume(side);
    demands[1].given.ribs = 9.0;
    QCOMPARE(lungs.pose(demands, 0.0, 0).error().code, Errc::VolumeUnreachable);
    demands[1].given.ribs = 0.0;
    QVERIFY(lungs.pose(demands, 0.0, 0).has_value());
    QCOMPARE(lungs.pose(demands, 0.41, 0).error().code, Errc::VolumeUnreachable);
    demands[0].volume.si = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(lungs.pose(demands, 0.0, 0).error().code, Errc::NotFinite);
}

// The vertex nearest to the carina, in the deepest breath there is.
void TestLungPair::holdsTheHilumStill()
{
    constexpr double kStill_m = 5e-4;
    const LungPair lungs = LungPair::of(patient()).value();
    const ChestPose pose{{8.0 * kQuietBreath, 8.0 * kQuietBreath}};
    const std::vector<Vec3f>& left = lungs.parts()[2].levels.front().positions;
    const Vec3f& hilum = *std::ranges::min_element(left, {}, &Vec3f::squaredNorm);
    const ChestMotion motion = motionOf(ChestRegion::LeftUpperLung, pose, lungs.field());
    QVERIFY(lungs.field().at(hilum.cast<double>(), motion).d_A.norm() < kStill_m);
}

CARINA_TEST(TestLungPair)

} // namespace carina::lung_pair_test

#include "tst_lung_pair.moc"
