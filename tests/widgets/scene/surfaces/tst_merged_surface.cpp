#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_shapes.h"
#include "widgets/scene/surfaces/merged_surface.h"

#include <array>

namespace carina::merged_surface_test
{

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

/// Where the first corners of the triangles drawn in these levels lie along x.
std::vector<float> drawnAt(const MergedSurface& surface, const std::vector<int>& levels)
{
    std::vector<float> places;
    for (const Triangle& t : trianglesAt(levels, surface.pieces, surface.triangles))
        places.push_back(surface.vertices[t[0]].position.x());
    return places;
}

} // namespace

class TestMergedSurface : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsLikePartsInOneGo();
    void saysOfEachCornerWhatItBelongsTo();
    void givesEachCornerItsOwnColour();
    void keepsUnlikePartsApart_data();
    void keepsUnlikePartsApart();
    void drawsEachPartInItsLevel();
    void turnsOverWhatIsSeenInto();
    void makesNoSurfaceOfNoParts();
};

void TestMergedSurface::drawsLikePartsInOneGo()
{
    const std::vector parts{part(7, MaterialGroup::Bone, {triangle(0)}),
                            part(300, MaterialGroup::SoftTissue, {triangle(5)})};
    const std::vector<MergedSurface> surfaces = mergedSurfaces(parts);
    QCOMPARE(surfaces.size(), std::size_t{1});
    const MergedSurface& surface = surfaces.front();
    QCOMPARE(surface.key, (SurfaceKey{DrawLayer::Closed, "", ChestRegion::Still}));
    QCOMPARE(surface.vertices.size(), std::size_t{6});
    QVERIFY(surface.triangles == (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
}

void TestMergedSurface::saysOfEachCornerWhatItBelongsTo()
{
    ScenePart lung = part(300, MaterialGroup::Lung, {triangle(5)});
    lung.region = ChestRegion::LeftLowerLung;
    const std::vector<MergedSurface> surfaces =
        mergedSurfaces(std::vector{part(7, MaterialGroup::Airway, {triangle(0)}), lung});
    QCOMPARE(surfaces.size(), std::size_t{1});
    const std::vector<SurfaceVertex>& vertices = surfaces.front().vertices;
    QVERIFY(vertices[2].part == Vec3f(7, 0, 3));
    QVERIFY(vertices[3].part == Vec3f(300, 4, 4));
    QVERIFY(vertices[4].position == Vec3f(6, 0, 0));
    QVERIFY(vertices[4].normal == Vec3f(0, 0, 1));
    QVERIFY((vertices[4].color - Vec3f(1.0F, 0.0F, 0.2F)).norm() < 1e-4F);
}

void TestMergedSurface::givesEachCornerItsOwnColour()
{
    ScenePart skin = part(7, MaterialGroup::Skin, {triangle(0), triangle(10)});
    skin.colors = {{{255, 0, 0}, {0, 255, 0}, {0, 0, 51}}, std::vector(3, Rgb{0, 0, 255})};
    const ScenePart plain = part(8, MaterialGroup::Skin, {triangle(20)});
    const std::vector<MergedSurface> surfaces = mergedSurfaces(std::vector{skin, plain});
    const std::array<Vec3f, 7> meant{Vec3f{1, 0, 0}, {0, 1, 0}, {0, 0, 0.2F}, {0, 0, 1},
                                     {0, 0, 1},      {0, 0, 1}, {1, 0, 0.2F}};
    for (std::size_t i = 0; i < meant.size(); ++i)
        QVERIFY((surfaces.front().vertices[i].color - meant[i]).norm() < 1e-4F);
}

void TestMergedSurface::keepsUnlikePartsApart_data()
{
    QTest::addColumn<MaterialGroup>("group");
    QTest::addColumn<MaterialGroup>("beside");
    QTest::addColumn<QString>("body");
    QTest::addColumn<ChestRegion>("region");
    QTest::addColumn<int>("draws");
    using G = MaterialGroup;
    using R = ChestRegion;
    QTest::newRow("opaque") << G::Bone << G::Lung << "" << R::Still << 2;
    QTest::newRow("a tool") << G::Tool << G::Lung << "" << R::Still << 2;
    QTest::newRow("body") << G::Lung << G::Lung << "tube" << R::Still << 2;
    QTest::newRow("another translucent one") << G::Ghost << G::Lung << "" << R::Still << 1;
    QTest::newRow("that breathes otherwise") << G::Lung << G::Lung << "" << R::Wall << 1;
    QTest::newRow("opaque alike") << G::Bone << G::SoftTissue << "" << R::Still << 1;
    QTest::newRow("opaque that breathes otherwise") << G::Bone << G::Bone << "" << R::Wall << 2;
}

void TestMergedSurface::keepsUnlikePartsApart()
{
    QFETCH(MaterialGroup, group);
    QFETCH(MaterialGroup, beside);
    QFETCH(QString, body);
    QFETCH(ChestRegion, region);
    ScenePart other = part(2, group, {triangle(0)});
    other.body = body.toStdString();
    other.region = region;
    const std::vector parts{part(1, beside, {triangle(0)}), other};
    QTEST(static_cast<int>(mergedSurfaces(parts).size()), "draws");
}

void TestMergedSurface::drawsEachPartInItsLevel()
{
    const std::vector parts{part(1, MaterialGroup::Bone, {triangle(0), triangle(10)}),
                            part(2, MaterialGroup::Airway, {triangle(20)}),
                            part(3, MaterialGroup::Bone, {triangle(30), triangle(40)})};
    const std::vector<MergedSurface> surfaces = mergedSurfaces(parts);
    QCOMPARE(surfaces.size(), std::size_t{2});
    using Places = std::vector<float>;
    QCOMPARE(drawnAt(surfaces[0], {0, 0, 0}), (Places{0, 30}));
    QCOMPARE(drawnAt(surfaces[0], {1, 0, 0}), (Places{10, 30}));
    QCOMPARE(drawnAt(surfaces[0], {0, 0, 1}), (Places{0, 40}));
    QCOMPARE(drawnAt(surfaces[1], {1, 0, 1}), (Places{20, 20})); // both of its faces
    QCOMPARE(drawnAt(surfaces[1], {1, 1, 1}), Places{});
}

void TestMergedSurface::turnsOverWhatIsSeenInto()
{
    const std::vector<MergedSurface> surfaces =
        mergedSurfaces(std::vector{part(1, MaterialGroup::Airway, {triangle(0)}),
                                   part(2, MaterialGroup::Lung, {triangle(10)})});
    const MergedSurface& both = surfaces.front();
    const std::vector levels{0, 0};
    using Triangles = std::vector<Triangle>;
    QVERIFY(trianglesAt(levels, both.pieces, both.triangles)
            == (Triangles{{0, 1, 2}, {0, 2, 1}, {3, 4, 5}}));
    QVERIFY(trianglesAt(levels, both.pieces, both.triangles, true)
            == (Triangles{{0, 1, 2}, {0, 2, 1}, {3, 4, 5}, {3, 5, 4}}));
}

void TestMergedSurface::makesNoSurfaceOfNoParts() { QVERIFY(mergedSurfaces({}).empty()); }

CARINA_TEST(TestMergedSurface)

} // namespace carina::merged_surface_test

#include "tst_merged_surface.moc"
