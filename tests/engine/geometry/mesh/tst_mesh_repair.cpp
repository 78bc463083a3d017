#include "engine/geometry/mesh/mesh_repair.h"
#include "engine/geometry/mesh/mesh_weld.h"
#include "engine/geometry/mesh/mesh_winding.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <numbers>
#include <random>

namespace carina::mesh_repair_test
{
namespace
{

constexpr Length kTolerance = millimetres(0.01);
constexpr double kVolumeTolerance = 1e-6; // m^3 for solids of about one m^3 in single precision

/// Six squares of a unit cube, each corner of each square its own vertex; square 5 is the top.
TriangleMesh cubeOfSquares(const Vec3f& corner = Vec3f::Zero())
{
    TriangleMesh mesh;
    const auto square = [&](const Vec3f& origin, const Vec3f& u, const Vec3f& v) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Vec3f& p : {origin, Vec3f{origin + u}, Vec3f{origin + u + v}, Vec3f{origin + v}})
            mesh.positions.push_back(corner + p);
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    };
    const Vec3f x = Vec3f::UnitX();
    const Vec3f y = Vec3f::UnitY();
    const Vec3f z = Vec3f::UnitZ();
    square(Vec3f::Zero(), y, x); // bottom, seen from below
    square(Vec3f::Zero(), x, z);
    square(Vec3f::Zero(), z, y);
    square(x, y, z);
    square(y, z, x);
    square(z, x, y);
    return mesh;
}

/// The side of a prism over a regular polygon, radius 1, height 1, open at both ends.
TriangleMesh openPrism(std::uint32_t corners)
{
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        for (const double z : {0.0, 1.0})
            mesh.positions.push_back(Vec3{std::cos(angle), std::sin(angle), z}.cast<float>());
        const std::uint32_t a = 2 * i;
        const std::uint32_t b = 2 * ((i + 1) % corners);
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
    }
    return mesh;
}

void turn(Triangle& t) { std::swap(t[0], t[1]); }

} // namespace

class TestMeshRepair : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void joinsVerticesWithinTheTolerance()
    {
        const TriangleMesh split = cubeOfSquares();
        QVERIFY(!isClosed(split));
        const TriangleMesh exact = welded(split, millimetres(0.0));
        QCOMPARE(exact.positions.size(), std::size_t{8});
        QCOMPARE(exact.triangles.size(), std::size_t{12});
        QVERIFY(isClosed(exact));

        TriangleMesh shaken = split;
        for (std::size_t i = 0; i < shaken.positions.size(); ++i)
            shaken.positions[i].x() += i % 2 == 0 ? 4e-6F : -4e-6F;
        QCOMPARE(welded(shaken, kTolerance).positions.size(), std::size_t{8});
        QVERIFY(welded(shaken, millimetres(0.002)).positions.size() > 8);
    }

    void dropsDegenerateAndRepeatedTriangles()
    {
        TriangleMesh mesh = cubeOfSquares();
        mesh.positions.push_back({5.0F, 5.0F, 5.0F});
        mesh.triangles.push_back({0, 0, 24});
        const Triangle t = mesh.triangles[3];
        mesh.triangles.push_back({t[1], t[2], t[0]});
        mesh.triangles.insert(mesh.triangles.begin(), {t[0], t[2], t[1]}); // outvoted, two to one
        const TriangleMesh clean = welded(mesh, kTolerance);
        QCOMPARE(clean.positions.size(), std::size_t{8});
        QCOMPARE(clean.triangles.size(), std::size_t{12});
        QVERIFY(isClosed(clean));
    }

    void dropsBothFacesOfAFold()
    {
        TriangleMesh mesh = cubeOfSquares();
        mesh.positions.push_back({0.5F, 0.5F, 2.0F});
        mesh.triangles.push_back({20, 22, 24}); // on the diagonal of the top
        mesh.triangles.push_back({22, 20, 24});
        const TriangleMesh clean = welded(mesh, kTolerance);
        QCOMPARE(clean.positions.size(), std::size_t{8});
        QCOMPARE(clean.triangles.size(), std::size_t{12});
        QVERIFY(isClosed(clean));
    }

    void keepsOneSideOfATwoSidedSurface()
    {
        TriangleMesh mesh = cubeOfSquares();
        for (std::size_t i = 0; i < 12; ++i) {
            mesh.triangles.push_back(mesh.triangles[i]);
            turn(mesh.triangles.back());
        }
        const TriangleMesh clean = welded(mesh, kTolerance);
        QCOMPARE(clean.triangles.size(), std::size_t{12});
        QVERIFY(std::abs(signedVolume(clean) - 1.0) < kVolumeTolerance);
    }

    void callsAnEmptyMeshOpen()
    {
        QVERIFY(!isClosed({}));
        QVERIFY(closedSurface({}, kTolerance).empty());
    }

    void findsTheLoopAroundAHole()
    {
        TriangleMesh mesh = welded(cubeOfSquares(), kTolerance);
        mesh.triangles.resize(10); // without the top
        QVERIFY(!isClosed(mesh));
        const std::vector<BoundaryLoop> loops = boundaryLoops(mesh);
        QCOMPARE(loops.size(), std::size_t{1});
        QCOMPARE(loops[0].size(), std::size_t{4});
        for (const std::uint32_t v : loops[0])
            QCOMPARE(mesh.positions[v].z(), 1.0F);
    }

    void separatesHolesThatMeetAtAVertex()
    {
        TriangleMesh mesh = welded(cubeOfSquares(), kTolerance);
        // Two triangles that share the corner (1, 1, 1) and no edge: one of the top, one of x = 1.
        const auto touches = [&](const Triangle& t, int axis) {
            return std::all_of(t.begin(), t.end(),
                               [&](auto v) { return mesh.positions[v][axis] == 1.0F; })
                   && std::any_of(t.begin(), t.end(),
                                  [&](auto v) { return mesh.positions[v] == Vec3f::Ones(); });
        };
        const auto sharesEdge = [](const Triangle& a, const Triangle& b) {
            return std::count_if(
                       a.begin(), a.end(),
                       [&](auto v) { return std::find(b.begin(), b.end(), v) != b.end(); })
                   == 2;
        };
        std::vector<Triangle> removed;
        for (const Triangle& top : mesh.triangles)
            for (const Triangle& side : mesh.triangles)
                if (removed.empty() && touches(top, 2) && touches(side, 0)
                    && !sharesEdge(top, side))
                    removed = {top, side};
        QCOMPARE(removed.size(), std::size_t{2});
        std::erase_if(mesh.triangles, [&](const Triangle& t) {
            return std::find(removed.begin(), removed.end(), t) != removed.end();
        });
        const std::vector<BoundaryLoop> loops = boundaryLoops(mesh);
        QCOMPARE(loops.size(), std::size_t{2});
        QCOMPARE(loops[0].size(), std::size_t{3});
        QCOMPARE(loops[1].size(), std::size_t{3});
        QVERIFY(std::abs(signedVolume(capped(mesh)) - 1.0) < kVolumeTolerance);
    }

    void capsALoopThatLiesInNoPlane()
    {
        // The rim of two adjacent squares of a cube; their own two squares (area 2) are the least
        // area over it, the roof between their far edges has 1 + sqrt 2.
        TriangleMesh mesh = cubeOfSquares();
        mesh.triangles.erase(mesh.triangles.begin() + 8, mesh.triangles.end());
        mesh = welded(mesh, kTolerance);
        QCOMPARE(boundaryLoops(mesh).at(0).size(), std::size_t{6});
        const TriangleMesh closed = capped(mesh);
        QVERIFY(isClosed(closed));
        QCOMPARE(closed.positions.size(), std::size_t{8});
        QVERIFY(std::abs(signedVolume(closed) - 1.0) < kVolumeTolerance);
    }

    void capsLongLoopsAboutANewVertex_data()
    {
        QTest::addColumn<int>("corners");
        QTest::addColumn<int>("newVertices");
        QTest::newRow("short loops need none") << 3 << 0;
        QTest::newRow("the longest triangulated") << 256 << 0;
        QTest::newRow("one longer") << 257 << 2;
    }

    void capsLongLoopsAboutANewVertex()
    {
        QFETCH(int, corners);
        QFETCH(int, newVertices);
        const TriangleMesh open = openPrism(static_cast<std::uint32_t>(corners));
        const TriangleMesh closed = capped(open);
        QVERIFY(isClosed(closed));
        QCOMPARE(closed.positions.size(), open.positions.size() + newVertices);
        const double area = 0.5 * corners * std::sin(2.0 * std::numbers::pi / corners);
        QVERIFY(std::abs(signedVolume(closed) - area) < kVolumeTolerance);
    }

    void makesMixedWindingAgree()
    {
        TriangleMesh mesh = welded(cubeOfSquares(), kTolerance);
        for (const std::size_t i : {1, 4, 5, 9})
            turn(mesh.triangles[i]);
        QVERIFY(!isClosed(mesh));
        const TriangleMesh agreed = consistentlyWound(mesh);
        QVERIFY(isClosed(agreed));
        QVERIFY(signedVolume(agreed) > 0.0); // the winding of the eight, not of the four
    }

    void turnsEachPartOutward()
    {
        TriangleMesh mesh = welded(cubeOfSquares(), kTolerance);
        for (Triangle& t : mesh.triangles)
            turn(t);
        append(mesh, welded(cubeOfSquares({3.0F, 0.0F, 0.0F}), kTolerance));
        QVERIFY(std::abs(signedVolume(mesh)) < kVolumeTolerance);
        QVERIFY(std::abs(signedVolume(facingOutward(mesh)) - 2.0) < kVolumeTolerance);
    }

    void closesSolidsThatTouchAlongAnEdge()
    {
        TriangleMesh mesh = cubeOfSquares();
        append(mesh, cubeOfSquares({1.0F, 1.0F, 0.0F}));
        const TriangleMesh closed = closedSurface(mesh, kTolerance);
        QCOMPARE(closed.positions.size(), std::size_t{14});
        QCOMPARE(closed.triangles.size(), std::size_t{24});
        QVERIFY(isClosed(closed));
        QVERIFY(std::abs(signedVolume(closed) - 2.0) < kVolumeTolerance);
    }

    void coversAFinWithItsOtherFace()
    {
        TriangleMesh mesh = cubeOfSquares();
        mesh.positions.push_back({0.5F, 0.5F, 2.0F});
        mesh.triangles.push_back({20, 22, 24}); // on the diagonal of the top
        const TriangleMesh closed = closedSurface(mesh, kTolerance);
        QCOMPARE(closed.triangles.size(), std::size_t{14});
        QVERIFY(isClosed(closed));
        QVERIFY(std::abs(signedVolume(closed) - 1.0) < kVolumeTolerance);
    }

    void closesAnySoupOfTriangles()
    {
        std::mt19937 random{7};
        for (int round = 0; round < 50; ++round) {
            TriangleMesh soup;
            for (int i = 0; i < 30; ++i)
                soup.positions.push_back(
                    1e-3F
                    * Vec3f{float(random() % 100), float(random() % 100), float(random() % 9)});
            for (int i = 0; i < 60; ++i)
                soup.triangles.push_back({std::uint32_t(random() % 30),
                                          std::uint32_t(random() % 30),
                                          std::uint32_t(random() % 30)});
            const TriangleMesh closed = closedSurface(soup, kTolerance);
            QVERIFY(isClosed(closed));
            QVERIFY(signedVolume(closed) > -1e-12);
        }
    }
};

CARINA_TEST(TestMeshRepair)

} // namespace carina::mesh_repair_test

#include "tst_mesh_repair.moc"
