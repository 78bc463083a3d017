#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

namespace carina::triangle_mesh_test
{
namespace
{

constexpr double kVolumeTolerance = 1e-6; // m^3, single precision on solids of about one m^3
constexpr float kNormalTolerance = 1e-6F; // of a unit vector

/// A box with a corner at `corner`: eight vertices, twelve triangles facing outward, with every
/// square cut along a diagonal of its own choice.
TriangleMesh boxAt(const Vec3f& corner, const Vec3f& size)
{
    TriangleMesh mesh;
    for (unsigned i = 0; i < 8; ++i) {
        const Vec3f bits(float(i & 1U), float((i >> 1U) & 1U), float(i >> 2U));
        mesh.positions.push_back(corner + bits.cwiseProduct(size));
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TriangleMesh unitBox() { return boxAt(Vec3f::Zero(), Vec3f::Ones()); }

TriangleMesh tetrahedron()
{
    TriangleMesh mesh;
    mesh.positions = {Vec3f::Zero(), Vec3f::UnitX(), Vec3f::UnitY(), Vec3f::UnitZ()};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

TriangleMesh turnedInsideOut(TriangleMesh mesh)
{
    for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

} // namespace

class TriangleMeshTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsTheVolumeItEncloses_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::addColumn<double>("volume");
        QTest::newRow("nothing") << TriangleMesh{} << 0.0;
        QTest::newRow("unit cube") << unitBox() << 1.0;
        QTest::newRow("box") << boxAt({-1.0F, 2.0F, 0.5F}, {2.0F, 3.0F, 0.25F}) << 1.5;
        QTest::newRow("cube far away") << boxAt(Vec3f::Constant(1024.0F), Vec3f::Ones()) << 1.0;
        QTest::newRow("corner of a cube") << tetrahedron() << 1.0 / 6.0;
        QTest::newRow("inside out") << turnedInsideOut(unitBox()) << -1.0;
    }
    void knowsTheVolumeItEncloses()
    {
        QFETCH(TriangleMesh, mesh);
        QFETCH(double, volume);
        QVERIFY(std::abs(signedVolume(mesh) - volume) < kVolumeTolerance);
    }

    void givesTheCornersOfACubeNormalsAlongItsDiagonals()
    {
        // Weighted by angle, each of the three squares counts a right angle however it is cut.
        TriangleMesh mesh = unitBox();
        computeNormals(mesh);
        QCOMPARE(mesh.normals.size(), std::size_t{8});
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3f outward = (mesh.positions[i] - Vec3f::Constant(0.5F)).normalized();
            QVERIFY((mesh.normals[i] - outward).norm() < kNormalTolerance);
        }
    }

    void weighsNormalsByAngle()
    {
        TriangleMesh mesh = tetrahedron();
        computeNormals(mesh);
        // At (1,0,0): 45 degrees of -z and of -y, 60 degrees of (1,1,1)/sqrt 3.
        const double third = degrees(60.0).si / std::sqrt(3.0);
        const Vec3 sum{third, third - degrees(45.0).si, third - degrees(45.0).si};
        QVERIFY((mesh.normals[1] - sum.normalized().cast<float>()).norm() < kNormalTolerance);
    }

    void replacesNormalsAndGivesPlusZWhereThereIsNoTriangle()
    {
        TriangleMesh mesh;
        mesh.positions = {Vec3f::Zero(), Vec3f::UnitX(), 2.0F * Vec3f::UnitX(), Vec3f::UnitY()};
        mesh.normals = {Vec3f::UnitX()};
        mesh.triangles = {{0, 1, 2}}; // without area
        computeNormals(mesh);
        QCOMPARE(mesh.normals.size(), std::size_t{4});
        for (const Vec3f& normal : mesh.normals)
            QCOMPARE(normal, Vec3f(0.0F, 0.0F, 1.0F));
    }

    void appendsAPartWithItsNormals()
    {
        TriangleMesh whole = unitBox();
        TriangleMesh part = tetrahedron();
        computeNormals(whole);
        computeNormals(part);
        append(whole, part);
        QCOMPARE(whole.positions.size(), std::size_t{12});
        QCOMPARE(whole.normals.size(), std::size_t{12});
        QCOMPARE(whole.normals[9], part.normals[1]);
        QCOMPARE(whole.positions[9], part.positions[1]);
        QCOMPARE(whole.triangles.size(), std::size_t{16});
        QCOMPARE(whole.triangles[11], (Triangle{3, 7, 5}));
        QCOMPARE(whole.triangles[12], (Triangle{8, 10, 9}));
        QVERIFY(std::abs(signedVolume(whole) - (1.0 + 1.0 / 6.0)) < kVolumeTolerance);
    }

    void dropsNormalsThatOneOfTheTwoLacks_data()
    {
        QTest::addColumn<bool>("wholeHas");
        QTest::addColumn<bool>("partHas");
        QTest::newRow("the whole lacks them") << false << true;
        QTest::newRow("the part lacks them") << true << false;
        QTest::newRow("both lack them") << false << false;
    }
    void dropsNormalsThatOneOfTheTwoLacks()
    {
        QFETCH(bool, wholeHas);
        QFETCH(bool, partHas);
        TriangleMesh whole = unitBox();
        TriangleMesh part = tetrahedron();
        if (wholeHas)
            computeNormals(whole);
        if (partHas)
            computeNormals(part);
        append(whole, part);
        QVERIFY(whole.normals.empty());
    }

    void appendsToNothing()
    {
        TriangleMesh whole;
        QVERIFY(whole.empty());
        TriangleMesh part = tetrahedron();
        computeNormals(part);
        append(whole, part);
        QVERIFY(!whole.empty());
        QCOMPARE(whole.normals.size(), std::size_t{4});
        QCOMPARE(whole.triangles.front(), part.triangles.front());
    }

    void boundsWhatItHolds()
    {
        const Box box = boundsOf(boxAt({-1.0F, 2.0F, 0.5F}, {2.0F, 3.0F, 0.25F}));
        QVERIFY(!box.empty());
        QCOMPARE(box.min, Vec3(-1.0, 2.0, 0.5));
        QCOMPARE(box.max, Vec3(1.0, 5.0, 0.75));
        QCOMPARE(box.centre(), Vec3(0.0, 3.5, 0.625));
        QCOMPARE(box.size(), Vec3(2.0, 3.0, 0.25));
        QVERIFY(boundsOf(TriangleMesh{}).empty());
    }

    void growsABoxByPointsAndBoxes()
    {
        Box box;
        QVERIFY(box.empty());
        box.include(Vec3{1.0, 2.0, 3.0});
        QVERIFY(!box.empty());
        QCOMPARE(box.size(), Vec3(0.0, 0.0, 0.0));
        Box other;
        other.include(Vec3{-1.0, 5.0, 3.0});
        box.include(other);
        QCOMPARE(box.min, Vec3(-1.0, 2.0, 3.0));
        QCOMPARE(box.max, Vec3(1.0, 5.0, 3.0));
        box.include(Box{});
        QCOMPARE(box.max, Vec3(1.0, 5.0, 3.0));
        Box flat = box;
        flat.max.z() = 2.0; // below its minimum in one direction alone
        QVERIFY(flat.empty());
    }
};

CARINA_TEST(TriangleMeshTest)

} // namespace carina::triangle_mesh_test

#include "tst_triangle_mesh.moc"
