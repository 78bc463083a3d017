#include "engine/anatomy/detail.h"
#include "engine/geometry/mesh/mesh_winding.h"
#include "tests/engine/anatomy/shapes/surface_checks.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>
#include <numbers>

namespace carina::detail_test
{

class TestDetail : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void closednessIsJudgedByDirectedEdges_data();
    void closednessIsJudgedByDirectedEdges();
    void joinsVerticesOfEqualPosition();
    void leavesOutTrianglesThatRepeatACorner();
    void levelsHaveTheSharesAskedFor();
    void levelsOfAClosedSurfaceAreClosed();
    void normalsPointOutward();
    void smallPartsAreKeptWhole();
    void tellsHowFarALevelDeparts();
    void aMeshWithoutTrianglesStaysEmpty();
};

namespace
{

constexpr double kSphereRadius = 0.05;

TriangleMesh tetrahedron()
{
    TriangleMesh mesh;
    mesh.positions = {Vec3f::Zero(), Vec3f::UnitX(), Vec3f::UnitY(), Vec3f::UnitZ()};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

} // namespace

void TestDetail::closednessIsJudgedByDirectedEdges_data()
{
    QTest::addColumn<std::vector<Triangle>>("triangles");
    QTest::addColumn<bool>("closed");
    const std::vector<Triangle> whole = tetrahedron().triangles;
    QTest::newRow("tetrahedron") << whole << true;
    QTest::newRow("one triangle missing")
        << std::vector<Triangle>(whole.begin(), whole.end() - 1) << false;
    QTest::newRow("one triangle turned over")
        << std::vector<Triangle>{whole[0], whole[1], whole[2], {1, 3, 2}} << false;
    QTest::newRow("nothing") << std::vector<Triangle>{} << false;
    std::vector<Triangle> twice = whole;
    twice.insert(twice.end(), whole.begin(), whole.end());
    QTest::newRow("every triangle twice") << twice << true;
}

void TestDetail::closednessIsJudgedByDirectedEdges()
{
    QFETCH(std::vector<Triangle>, triangles);
    TriangleMesh mesh = tetrahedron();
    mesh.triangles = triangles;
    QTEST(isClosed(mesh), "closed");
}

void TestDetail::joinsVerticesOfEqualPosition()
{
    const TriangleMesh sphere = test::unweldedSphere(kSphereRadius, 3);
    QVERIFY(!isClosed(sphere));
    const std::vector<TriangleMesh> levels = levelsOfDetail(sphere, {}).meshes;
    QCOMPARE(levels.size(), std::size_t{1});
    // Euler: V = 2 + E - F with E = 3F/2, so a sphere of 512 triangles has 258 vertices.
    QCOMPARE(levels[0].triangles.size(), std::size_t{512});
    QCOMPARE(levels[0].positions.size(), std::size_t{258});
    QVERIFY(isClosed(levels[0]));
}

void TestDetail::leavesOutTrianglesThatRepeatACorner()
{
    TriangleMesh mesh = tetrahedron();
    mesh.positions.emplace_back(-0.0F, 0.0F, 0.0F); // the first vertex again, with a negative zero
    mesh.triangles.push_back({0, 1, 4});
    const std::vector<TriangleMesh> levels = levelsOfDetail(mesh, {}).meshes;
    QCOMPARE(levels[0].triangles.size(), std::size_t{4});
    QCOMPARE(levels[0].positions.size(), std::size_t{4});
}

void TestDetail::levelsHaveTheSharesAskedFor()
{
    constexpr double kShareTolerance = 0.1; // of the share
    const std::array shares{0.25, 0.0625};
    const auto levels = levelsOfDetail(test::unweldedSphere(kSphereRadius, 5), shares).meshes;
    QCOMPARE(levels.size(), std::size_t{3});
    QCOMPARE(levels[0].triangles.size(), std::size_t{8192});
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const double share = double(levels[k + 1].triangles.size()) / 8192.0;
        QVERIFY2(std::abs(share - shares[k]) < kShareTolerance * shares[k],
                 qPrintable(QString::number(share)));
    }
}

void TestDetail::levelsOfAClosedSurfaceAreClosed()
{
    constexpr double kVolumeTolerance = 0.03; // chords of the coarsest level cut this much off
    const std::array shares{0.25, 0.0625};
    const double ball = 4.0 / 3.0 * std::numbers::pi * std::pow(kSphereRadius, 3);
    const auto levels = levelsOfDetail(test::unweldedSphere(kSphereRadius, 5), shares);
    for (const TriangleMesh& level : levels.meshes) {
        QCOMPARE(test::edgesWithoutPartner(level), 0);
        QVERIFY(std::abs(signedVolume(level) / ball - 1.0) < kVolumeTolerance);
    }
}

void TestDetail::normalsPointOutward()
{
    constexpr double kMeanCosine = 0.995; // a mean of 6 degrees between normal and radius
    const std::array shares{0.25, 0.0625};
    const auto levels = levelsOfDetail(test::unweldedSphere(kSphereRadius, 5), shares);
    for (const TriangleMesh& level : levels.meshes) {
        QVERIFY(test::worstNormalLength(level) < 1e-6);
        double sum = 0.0;
        for (std::size_t i = 0; i < level.positions.size(); ++i) {
            const float cosine = level.normals[i].dot(level.positions[i].normalized());
            QVERIFY(cosine > 0.0F);
            sum += cosine;
        }
        QVERIFY(sum / double(level.positions.size()) > kMeanCosine);
    }
}

void TestDetail::smallPartsAreKeptWhole()
{
    const std::array shares{0.25, 0.0625};
    const auto fine = levelsOfDetail(test::unweldedSphere(kSphereRadius, 2), shares).meshes; // 128
    QCOMPARE(fine[1].triangles.size(), std::size_t{64});
    QCOMPARE(fine[2].triangles.size(), std::size_t{64});
    const auto few = levelsOfDetail(test::unweldedSphere(kSphereRadius, 1), shares).meshes; // 32
    QCOMPARE(few[2].triangles.size(), std::size_t{32});
}

void TestDetail::tellsHowFarALevelDeparts()
{
    // What a level departs from the sphere itself: its vertices stay near it, and the middles of
    // its triangles lie deepest inside.
    const std::array shares{0.25, 0.0625};
    const LevelsOfDetail levels = levelsOfDetail(test::unweldedSphere(kSphereRadius, 5), shares);
    QCOMPARE(levels.deviations.size(), std::size_t{3});
    QCOMPARE(levels.deviations[0], 0.0);
    for (std::size_t k = 1; k < levels.meshes.size(); ++k) {
        QVERIFY(levels.deviations[k] > levels.deviations[k - 1]);
        const TriangleMesh& mesh = levels.meshes[k];
        double deepest = 0.0;
        for (const Triangle& t : mesh.triangles) {
            const Vec3f sum = mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
            deepest = std::max(deepest, std::abs(kSphereRadius - double(sum.norm()) / 3.0));
        }
        QVERIFY2(
            levels.deviations[k] > 0.3 * deepest && levels.deviations[k] < 3.0 * deepest,
            qPrintable(
                QStringLiteral("%1 m told, %2 m deep").arg(levels.deviations[k]).arg(deepest)));
    }
}

void TestDetail::aMeshWithoutTrianglesStaysEmpty()
{
    const std::array shares{0.5};
    TriangleMesh dots;
    dots.positions = {Vec3f::Zero(), Vec3f::UnitX()};
    dots.triangles = {{0, 1, 1}};
    const LevelsOfDetail detail = levelsOfDetail(dots, shares);
    const std::vector<TriangleMesh>& levels = detail.meshes;
    QCOMPARE(detail.deviations, std::vector<double>(2, 0.0));
    QCOMPARE(levels.size(), std::size_t{2});
    QVERIFY(levels[0].empty());
    QVERIFY(levels[1].empty());
}

CARINA_TEST(TestDetail)

} // namespace carina::detail_test

#include "tst_detail.moc"
