#include "tests/support/test_class.h"
#include "widgets/scene/figures/figure_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace carina::figure_shapes_test
{
namespace
{

constexpr double kSize = 1e-6; ///< metres, of a coordinate

std::array<FigureShapes::Mesh, 8> allShapes()
{
    const FigureShapes& shapes = figureShapes();
    return {shapes.head,
            shapes.visor,
            shapes.gaze,
            shapes.hand,
            shapes.stylus,
            shapes.ray,
            std::make_shared<const TriangleMesh>(bladeMesh({})),
            shapes.handle};
}

} // namespace

class TestFigureShapes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Of |x/a|^n + |y/b|^n + |z/c|^n = 1: 8 abc G(1 + 1/n)^3 / G(1 + 3/n), with Euler's G.
    void enclosesTheVolumeOfASuperellipsoid_data()
    {
        QTest::addColumn<double>("exponent");
        QTest::addColumn<double>("facets"); // share of the volume that they cut off at most
        QTest::newRow("ellipsoid") << 2.0 << 0.03;
        QTest::newRow("rounder box") << 3.0 << 0.03;
        QTest::newRow("box, whose edges are sharper") << 6.0 << 0.04;
    }
    void enclosesTheVolumeOfASuperellipsoid()
    {
        QFETCH(double, exponent);
        QFETCH(double, facets);
        const Vec3 radii{0.05, 0.12, 0.08};
        const TriangleMesh mesh = superellipsoid({0.3, -0.2, 0.1}, radii, exponent);
        const double expected = 8.0 * radii.prod()
                                * std::pow(std::tgamma(1.0 + 1.0 / exponent), 3.0)
                                / std::tgamma(1.0 + 3.0 / exponent);
        const double volume = signedVolume(mesh);
        QVERIFY(volume < expected);
        QVERIFY(volume > (1.0 - facets) * expected);
        const Box box = boundsOf(mesh);
        QVERIFY((box.centre() - Vec3(0.3, -0.2, 0.1)).norm() < kSize);
        QVERIFY((box.size().array() < 2.0 * radii.array() + kSize).all());
    }

    void endsABladeWhereItsTipWasTouched()
    {
        const TriangleMesh straight =
            bladeMesh({.reach = 0.155, .rise = 0.0, .sag = 0.0, .width = 0.014});
        const Box flat = boundsOf(straight);
        QVERIFY(std::abs(flat.min.z() + 0.155) < 1e-4 && std::abs(flat.max.z()) < 1e-4);
        QVERIFY(std::abs(flat.size().x() - 0.014) < 1e-3 && flat.size().y() < 0.006);
        const TriangleMesh curved = bladeMesh({.reach = 0.13, .rise = 0.012, .sag = 0.018});
        const Box bent = boundsOf(curved);
        // Half way the line from heel to tip is 6 mm up, the blade 18 mm below it.
        QVERIFY(bent.min.y() < -0.012 && bent.min.y() > -0.018);
        QVERIFY(std::abs(bent.max.y() - 0.012) < 3e-3);
    }

    void facesOutwardWithNormals()
    {
        for (const FigureShapes::Mesh& mesh : allShapes()) {
            QVERIFY(signedVolume(*mesh) > 0.0);
            QCOMPARE(mesh->normals.size(), mesh->positions.size());
        }
    }

    /// The eyes are at the origin, the face towards -z, the top of the head towards +y.
    void wearsTheVisorBeforeTheEyes()
    {
        const FigureShapes& shapes = figureShapes();
        const Box head = boundsOf(*shapes.head);
        const Box visor = boundsOf(*shapes.visor);
        QVERIFY(std::abs(head.max.y() - kHeadTop) < kSize);
        QVERIFY(head.centre().z() > 0.0 && std::abs(head.centre().x()) < kSize);
        QVERIFY(visor.min.z() < head.min.z());
        QVERIFY(visor.max.z() < head.centre().z());
        QVERIFY(visor.size().x() > visor.size().y());
        QVERIFY(visor.min.y() < 0.0 && visor.max.y() > 0.0);
    }

    /// 130 mm long, its tip towards the handle's side.
    void hasALaryngoscopeOfItsTrueSize()
    {
        const TriangleMesh mesh = bladeMesh({});
        const Box blade = boundsOf(mesh);
        QVERIFY(std::abs(blade.size().z() - 0.130) < 0.003);
        QVERIFY(blade.size().x() > 0.010 && blade.size().x() < 0.020);
        QVERIFY2(blade.max.z() < 0.005 && blade.min.y() < -0.01,
                 qPrintable(QStringLiteral("%1 %2").arg(blade.max.z()).arg(blade.min.y())));
        const auto& tip =
            *std::ranges::min_element(mesh.positions, {}, [](const auto& p) { return p.z(); });
        QVERIFY(tip.y() > 0.005F);
        const Box handle = boundsOf(*figureShapes().handle);
        QVERIFY(std::abs(handle.size().x() - 0.028) < 0.001 && handle.max.y() > 0.15);
    }

    void looksAndPointsAlongMinusZ()
    {
        const FigureShapes& shapes = figureShapes();
        const auto reach = [](const FigureShapes::Mesh& mesh) {
            const Box box = boundsOf(*mesh);
            return box.size().head<2>().maxCoeff() < 0.02 ? -box.min.z() : 0.0;
        };
        QVERIFY(std::abs(reach(shapes.gaze) - kGazeLength) < kSize);
        QVERIFY(std::abs(reach(shapes.ray) - kRayLength) < kSize);
        const Box stylus = boundsOf(*shapes.stylus);
        QVERIFY(std::abs(stylus.min.z()) < kSize && stylus.max.z() > 0.1);
        // The index finger is stretched out farther than all else of the hand.
        const Box hand = boundsOf(*shapes.hand);
        QVERIFY(hand.min.z() < -0.06 && hand.max.z() > 0.09);
    }
};

CARINA_TEST(TestFigureShapes)

} // namespace carina::figure_shapes_test

#include "tst_figure_shapes.moc"
