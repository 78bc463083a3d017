#include "engine/lungs/breathing_pattern.h"
#include "engine/lungs/lung_pair.h"
#include "tests/engine/lungs/lung_like_mesh.h"
#include "widgets/scene/drawn_vertices.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTest>

using namespace carina;

namespace
{

/// One rounding of a coordinate of up to a quarter metre, in single precision.
constexpr double kPositionTolerance_m = 3e-8;
constexpr double kNormalTolerance = 1e-6;
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

} // namespace

class TestDrawnVertices : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsAsTheReferenceDeforms_data();
    void drawsAsTheReferenceDeforms();
    void leavesRestExactlyAsItIs();
    void followsTheCommandedVolume();
    void leavesTheContextThatWasCurrent();
    void movesWithItsUploadedMesh();
};

void TestDrawnVertices::drawsAsTheReferenceDeforms_data()
{
    QTest::addColumn<float>("amplitude");
    QTest::newRow("below rest") << -1.0F;
    QTest::newRow("half a breath") << 0.5F;
    QTest::newRow("an odd share") << 1.2345678F;
    QTest::newRow("a deep breath") << 7.0F;
}

void TestDrawnVertices::drawsAsTheReferenceDeforms()
{
    QFETCH(float, amplitude);
    const LungPair lungs = LungPair::of(patient()).value();
    for (const BreathingPart& part : lungs.parts()) {
        const DeformableMesh& mesh = part.levels.front();
        Result<DrawnVertices> drawn = DrawnVertices::of(mesh);
        QVERIFY2(drawn.has_value(), drawn ? "" : drawn.error().detail.c_str());
        const TriangleMesh reference = deformed(mesh, amplitude);
        const std::vector<Vec3f> positions = drawn->positions(amplitude).value();
        const std::vector<Vec3f> normals = drawn->normals(amplitude).value();
        QCOMPARE(positions.size(), reference.positions.size());
        QCOMPARE(normals.size(), reference.normals.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            QVERIFY((positions[i] - reference.positions[i]).cwiseAbs().maxCoeff()
                    < kPositionTolerance_m);
            QVERIFY((normals[i] - reference.normals[i]).norm() < kNormalTolerance);
        }
    }
}

void TestDrawnVertices::leavesRestExactlyAsItIs()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const DeformableMesh& mesh = lungs.parts().front().levels.front();
    Result<DrawnVertices> drawn = DrawnVertices::of(mesh);
    QVERIFY(drawn.has_value());
    QVERIFY(drawn->positions(0.0F).value() == mesh.rest.positions);
}

// Two breaths of a child of 12 years, 19 per minute and 280 ml, at 60 frames per second.
void TestDrawnVertices::followsTheCommandedVolume()
{
    const BreathingPattern pattern;
    const LungPair lungs = LungPair::of(patient()).value();
    for (std::size_t level = 0; level < lungs.levelCount(); ++level) {
        for (const BreathingPart& part : lungs.parts()) {
            TriangleMesh surface = levelOf(part, level).rest;
            Result<DrawnVertices> drawn = DrawnVertices::of(levelOf(part, level));
            QVERIFY(drawn.has_value());
            for (int frame = 0; frame <= 379; ++frame) {
                const double breaths = frame / 60.0 * pattern.rate.si;
                const Volume inspired = inspiredVolume(pattern, breaths - std::floor(breaths));
                const LungAmplitudes s = lungs.amplitudes(inspired, level).value();
                surface.positions =
                    drawn->positions(part.side == Side::Right ? s.right : s.left).value();
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
        QVERIFY(drawn->positions(1.0F).has_value());
        QCOMPARE(QOpenGLContext::currentContext(), &viewer);
    }
    QCOMPARE(QOpenGLContext::currentContext(), &viewer);
    viewer.doneCurrent();
    const LungPair lungs = LungPair::of(patient()).value();
    QVERIFY(DrawnVertices::of(lungs.parts().front().levels.back())->positions(1.0F).has_value());
    QVERIFY(QOpenGLContext::currentContext() == nullptr);
}

void TestDrawnVertices::movesWithItsUploadedMesh()
{
    const LungPair lungs = LungPair::of(patient()).value();
    const DeformableMesh& right = lungs.parts()[0].levels.back();
    const DeformableMesh& left = lungs.parts()[1].levels.back();
    std::vector<DrawnVertices> both;
    both.push_back(DrawnVertices::of(right).value());
    both.push_back(DrawnVertices::of(left).value());
    QVERIFY(both[0].positions(0.0F).value() == right.rest.positions);
    QVERIFY(both[1].positions(0.0F).value() == left.rest.positions);
    both[0] = std::move(both[1]);
    QVERIFY(both[0].positions(0.0F).value() == left.rest.positions);
}

QTEST_MAIN(TestDrawnVertices)
#include "tst_drawn_vertices.moc"
