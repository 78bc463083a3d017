#include "tests/widgets/scene/scene_shapes.h"
#include "widgets/scene/merged_surface.h"

#include <QTest>

using namespace carina;

namespace
{

/// One triangle, moved by an offset along x, so that corners can be told apart.
std::shared_ptr<const TriangleMesh> triangle(float x)
{
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->positions = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}};
    mesh->normals.assign(3, Vec3f(0, 0, 1));
    mesh->triangles = {{0, 1, 2}};
    return mesh;
}

ScenePart part(std::uint16_t id, MaterialGroup group,
               std::vector<std::shared_ptr<const TriangleMesh>> levels)
{
    ScenePart made;
    made.id = id;
    made.group = group;
    made.color = QColor(255, 0, 51);
    made.levels = std::move(levels);
    return made;
}

} // namespace

class TestMergedSurface : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsLikePartsInOneGo();
    void keepsUnlikePartsApart_data();
    void keepsUnlikePartsApart();
    void storesACoarsestLevelOnceForAllFurtherLevels();
    void countsTheTrianglesOfEachLevel();
    void hasOneLevelOfNothing();
};

void TestMergedSurface::drawsLikePartsInOneGo()
{
    const std::vector parts{part(7, MaterialGroup::Bone, {triangle(0)}),
                            part(300, MaterialGroup::Bone, {triangle(5)})};
    const std::vector<MergedSurface> surfaces = mergedSurfaces(parts);
    QCOMPARE(surfaces.size(), std::size_t{1});
    const MergedSurface& surface = surfaces.front();
    QCOMPARE(surface.key, (SurfaceKey{MaterialGroup::Bone, ChestRegion::Still, "", 0, 0}));
    QCOMPARE(surface.vertices.size(), std::size_t{6});
    QVERIFY(surface.triangles == (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
    QCOMPARE(surface.vertices[2].partId, 7.0F);
    QCOMPARE(surface.vertices[3].partId, 300.0F);
    QVERIFY(surface.vertices[4].position == Vec3f(6, 0, 0));
    QVERIFY(surface.vertices[4].normal == Vec3f(0, 0, 1));
    QVERIFY((surface.vertices[4].color - Vec3f(1.0F, 0.0F, 0.2F)).norm() < 1e-4F);
}

void TestMergedSurface::keepsUnlikePartsApart_data()
{
    QTest::addColumn<MaterialGroup>("group");
    QTest::addColumn<ChestRegion>("region");
    QTest::addColumn<QString>("body");
    QTest::newRow("material") << MaterialGroup::Skin << ChestRegion::Still << "";
    QTest::newRow("region") << MaterialGroup::Lung << ChestRegion::LeftUpperLung << "";
    QTest::newRow("body") << MaterialGroup::Lung << ChestRegion::Still << "tube";
}

void TestMergedSurface::keepsUnlikePartsApart()
{
    QFETCH(MaterialGroup, group);
    QFETCH(ChestRegion, region);
    QFETCH(QString, body);
    ScenePart other = part(2, group, {triangle(0)});
    other.region = region;
    other.body = body.toStdString();
    const std::vector parts{part(1, MaterialGroup::Lung, {triangle(0)}), other};
    QCOMPARE(mergedSurfaces(parts).size(), std::size_t{2});
}

void TestMergedSurface::storesACoarsestLevelOnceForAllFurtherLevels()
{
    const std::vector parts{part(1, MaterialGroup::Bone, {triangle(0)}),
                            part(2, MaterialGroup::Bone, {triangle(1), triangle(2), triangle(3)}),
                            part(3, MaterialGroup::Bone, {triangle(4), triangle(5)})};
    QCOMPARE(levelCount(parts), 3);
    const std::vector<MergedSurface> surfaces = mergedSurfaces(parts);
    // Which parts' corners lie in which levels: (first, last) -> ids.
    std::map<std::pair<int, int>, std::vector<float>> held;
    for (const MergedSurface& surface : surfaces)
        for (std::size_t corner = 0; corner < surface.vertices.size(); corner += 3)
            held[{surface.key.firstLevel, surface.key.lastLevel}].push_back(
                surface.vertices[corner].partId);
    const std::map<std::pair<int, int>, std::vector<float>> expected{
        {{0, 0}, {2, 3}}, {{0, 2}, {1}}, {{1, 1}, {2}}, {{1, 2}, {3}}, {{2, 2}, {2}}};
    QVERIFY(held == expected);
}

void TestMergedSurface::countsTheTrianglesOfEachLevel()
{
    const auto fine = test::sphere(Vec3::Zero(), 0.1);
    const std::size_t many = fine->triangles.size();
    const std::vector parts{part(1, MaterialGroup::Bone, {fine, triangle(0)}),
                            part(2, MaterialGroup::Lung, {fine})};
    QCOMPARE(trianglesPerLevel(parts), (std::vector<std::size_t>{2 * many, 1 + many}));
}

void TestMergedSurface::hasOneLevelOfNothing()
{
    QCOMPARE(levelCount({}), 1);
    QVERIFY(mergedSurfaces({}).empty());
    QCOMPARE(trianglesPerLevel({}), std::vector<std::size_t>{0});
}

QTEST_GUILESS_MAIN(TestMergedSurface)
#include "tst_merged_surface.moc"
