#include "engine/lungs/displacement_mode.h"
#include "engine/lungs/lung_pair.h"
#include "tests/engine/lungs/lung_like_mesh.h"

#include <QTest>

using namespace carina;

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
double drawnVolume_ml(const LungPair& lungs, Side side, std::size_t level, float amplitude)
{
    double volume = 0.0;
    for (const BreathingPart& part : lungs.parts()) {
        if (part.side == side)
            volume += test::volumeByColumns(deformed(levelOf(part, level), amplitude));
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
    void boundsEverythingThatIsDrawn();
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
        QVERIFY(std::abs(rest_ml - drawnVolume_ml(lungs, side, 0, 0.0F)) < kTolerance_ml);
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
        const Result<LungAmplitudes> s = lungs.amplitudes(inspired, level);
        QVERIFY(s.has_value());
        const double right_ml = drawnVolume_ml(lungs, Side::Right, level, s->right);
        const double left_ml = drawnVolume_ml(lungs, Side::Left, level, s->left);
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
    const LungAmplitudes s = lungs.amplitudes(Volume{}, 0).value();
    QVERIFY(std::abs(s.right) < 1e-9F);
    QVERIFY(std::abs(s.left) < 1e-9F);
}

void TestLungPair::reachesNoVolumeBeyondWhatAnatomyAllows()
{
    const LungPair lungs = LungPair::of(patient()).value();
    for (const double inspired_ml : {20000.0, -20000.0}) {
        const Result<LungAmplitudes> s = lungs.amplitudes(millilitres(inspired_ml), 0);
        QVERIFY(!s);
        QCOMPARE(s.error().code, Errc::VolumeUnreachable);
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
    const LungAmplitudes s = lungs.amplitudes(millilitres(100.0), 0).value();
    QCOMPARE(s.left, 0.0F);
    const double gain_ml = drawnVolume_ml(lungs, Side::Right, 0, s.right)
                           - drawnVolume_ml(lungs, Side::Right, 0, 0.0F);
    QVERIFY(std::abs(gain_ml - 100.0) < kTolerance_ml);
    QVERIFY(lungs.bounds(Side::Left).empty());
}

void TestLungPair::hasNothingToBreatheWithWithoutLungs()
{
    const LungPair lungs = LungPair::of(Anatomy{}).value();
    QVERIFY(lungs.parts().empty());
    QCOMPARE(lungs.levelCount(), std::size_t(0));
    QCOMPARE(lungs.restVolume(Side::Right).si, 0.0);
    QCOMPARE(lungs.volumeWith(millilitres(300.0), Side::Left).si, 0.0);
    const LungAmplitudes s = lungs.amplitudes(millilitres(300.0), 0).value();
    QCOMPARE(s.right, 0.0F);
    QCOMPARE(s.left, 0.0F);
}

void TestLungPair::boundsEverythingThatIsDrawn()
{
    const LungPair lungs = LungPair::of(patient()).value();
    for (const BreathingPart& part : lungs.parts()) {
        const Box bounds_A = lungs.bounds(part.side);
        for (const DeformableMesh& mesh : part.levels) {
            for (const double s : {kLeastAmplitude, 0.0, 2.0, kGreatestAmplitude}) {
                Box drawn_A = boundsOf(deformed(mesh, float(s)));
                const Vec3 slack = Vec3::Constant(1e-7);
                QVERIFY((drawn_A.min.array() >= (bounds_A.min - slack).array()).all());
                QVERIFY((drawn_A.max.array() <= (bounds_A.max + slack).array()).all());
            }
        }
    }
}

void TestLungPair::holdsTheHilumStill()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const DeformableMesh& left = lungs.parts()[2].levels.front();
    std::size_t hilum = 0;
    for (std::size_t i = 1; i < left.rest.positions.size(); ++i) {
        if (left.rest.positions[i].norm() < left.rest.positions[hilum].norm())
            hilum = i;
    }
    QCOMPARE(left.displacement[hilum].norm(), 0.0F);
}

QTEST_APPLESS_MAIN(TestLungPair)
#include "tst_lung_pair.moc"
