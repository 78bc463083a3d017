#include "engine/geometry/mesh/surface_query.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace carina::surface_tree_test
{
namespace
{

/// A torus round z: `around` by `across` quads, each cut in two.
TriangleMesh torus(double ring, double tube, std::uint32_t around, std::uint32_t across)
{
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < across; ++k) {
            const double a = 2.0 * std::numbers::pi * i / around;
            const double b = 2.0 * std::numbers::pi * k / across;
            const double r = ring + tube * std::cos(b);
            mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
            const auto at = [&](std::uint32_t u, std::uint32_t v) {
                return (u % around) * across + v % across;
            };
            mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return mesh;
}

/// Two triangles: one in the plane z = 0, one upright that comes down to `lowest`.
TriangleMesh crossing(float lowest)
{
    return {
        .positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0.5F, 1, 1}, {1.5F, 1, 1}, {1, 1, lowest}},
        .normals = {},
        .triangles = {{0, 1, 2}, {3, 4, 5}}};
}

} // namespace

class TestSurfaceTree : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheDistanceThatATriangleByTriangleSearchFinds()
    {
        const TriangleMesh mesh = torus(3.0, 1.0, 24, 12);
        const SurfaceTree tree{mesh};
        std::mt19937 random{5};
        std::uniform_real_distribution<double> anywhere{-6.0, 6.0};
        for (int i = 0; i < 300; ++i) {
            const Vec3 p{anywhere(random), anywhere(random), anywhere(random)};
            QCOMPARE(tree.distanceTo(p), distanceTo(mesh, p));
        }
    }

    void findsTheNearestPointAndItsNormal()
    {
        const SurfaceTree tree{torus(3.0, 1.0, 60, 40)};
        std::mt19937 random{7};
        std::uniform_real_distribution<double> anywhere{-6.0, 6.0};
        for (int i = 0; i < 300; ++i) {
            const Vec3 p{anywhere(random), anywhere(random), anywhere(random)};
            const auto nearest = tree.nearestTo(p);
            QVERIFY(nearest.has_value());
            QVERIFY(std::abs((p - nearest->p).norm() - tree.distanceTo(p)) < 1e-12);
            QVERIFY(std::abs(nearest->normal.norm() - 1.0) < 1e-12);
            // The torus itself: normals point away from its ring or to it, and the facets lean by
            // less than their size.
            const Vec3 flat{nearest->p.x(), nearest->p.y(), 0.0};
            const Vec3 outward = (nearest->p - 3.0 * flat.normalized()).normalized();
            QVERIFY(std::abs(nearest->normal.dot(outward)) > 0.97);
        }
    }

    void isInfinitelyFarFromNothing()
    {
        QVERIFY(!SurfaceTree{{}}.nearestTo(Vec3::Zero()));
        QCOMPARE(SurfaceTree{{}}.distanceTo(Vec3::Zero()), std::numeric_limits<double>::infinity());
        QCOMPARE(SurfaceTree{{}}.selfIntersections(), std::size_t{0});
    }

    void countsTrianglesThatRunThroughEachOther()
    {
        QCOMPARE(SurfaceTree{crossing(-1.0F)}.selfIntersections(), std::size_t{1});
        QCOMPARE(SurfaceTree{crossing(0.0F)}.selfIntersections(), std::size_t{0}); // touching
        QCOMPARE(SurfaceTree{crossing(0.5F)}.selfIntersections(), std::size_t{0});
    }

    void countsWhatRunsThroughTwiceOnce()
    {
        // Two edges of the upright triangle run through the other: one pair.
        TriangleMesh many = crossing(-1.0F);
        many.triangles.push_back({3, 4, 5});
        QCOMPARE(SurfaceTree{many}.selfIntersections(), std::size_t{2});
    }

    void leavesNeighboursInPeaceUnlessTheyFold()
    {
        // Triangles with a corner in common, of which the far edge of the second runs through the
        // first or past it.
        const auto beside = [](float height) {
            return TriangleMesh{
                .positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 2, 1}, {2, 1, height}},
                .normals = {},
                .triangles = {{0, 1, 2}, {0, 3, 4}}};
        };
        QCOMPARE(SurfaceTree{beside(1)}.selfIntersections(), std::size_t{0});
        QCOMPARE(SurfaceTree{beside(-1)}.selfIntersections(), std::size_t{1});
        // With an edge in common: never.
        const TriangleMesh hinge{.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0.1F}},
                                 .normals = {},
                                 .triangles = {{0, 1, 2}, {0, 3, 1}}};
        QCOMPARE(SurfaceTree{hinge}.selfIntersections(), std::size_t{0});
    }

    void findsNoneOnATorusAndManyOnASpindle()
    {
        QCOMPARE(SurfaceTree{torus(3.0, 1.0, 40, 20)}.selfIntersections(), std::size_t{0});
        QVERIFY(SurfaceTree{torus(1.0, 1.5, 40, 21)}.selfIntersections() > 40);
    }

    void findsWhatASearchOfAllPairsFinds()
    {
        // Two tori through each other, whose triangles share no corner.
        TriangleMesh both = torus(3.0, 1.0, 20, 10);
        const auto first = both.triangles.size();
        TriangleMesh other = torus(3.0, 1.0, 20, 10);
        for (Vec3f& p : other.positions)
            p += Vec3f{2.53F, 0.31F, 0.22F};
        append(both, other);
        std::size_t pairs = 0;
        for (std::size_t i = 0; i < first; ++i) {
            for (std::size_t j = first; j < both.triangles.size(); ++j) {
                const Corners a = cornersOf(both, both.triangles[i]);
                const Corners b = cornersOf(both, both.triangles[j]);
                if (runsThrough(a, b.a, b.b) || runsThrough(a, b.b, b.c) || runsThrough(a, b.c, b.a)
                    || runsThrough(b, a.a, a.b) || runsThrough(b, a.b, a.c)
                    || runsThrough(b, a.c, a.a))
                    ++pairs;
            }
        }
        QVERIFY(pairs > 20);
        QCOMPARE(SurfaceTree{both}.selfIntersections(), pairs);
    }
};

CARINA_TEST(TestSurfaceTree)

} // namespace carina::surface_tree_test

#include "tst_surface_tree.moc"
