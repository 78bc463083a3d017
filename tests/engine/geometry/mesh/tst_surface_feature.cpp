#include "engine/geometry/mesh/surface_feature.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace carina::surface_feature_test
{
namespace
{

using Height = std::function<double(double, double)>;

constexpr std::uint32_t kGrid = 61;
constexpr double kStep = 0.75e-3; // metres

/// A sheet of 45 mm to a side about the origin, its normals along z.
TriangleMesh sheet(const Height& height)
{
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < kGrid; ++i)
        for (std::uint32_t k = 0; k < kGrid; ++k) {
            const double x = kStep * (double(i) - kGrid / 2);
            const double y = kStep * (double(k) - kGrid / 2);
            mesh.positions.push_back(Vec3{x, y, height(x, y)}.cast<float>());
        }
    for (std::uint32_t i = 0; i + 1 < kGrid; ++i)
        for (std::uint32_t k = 0; k + 1 < kGrid; ++k) {
            const std::uint32_t corner = i * kGrid + k;
            mesh.triangles.push_back({corner, corner + kGrid, corner + kGrid + 1});
            mesh.triangles.push_back({corner, corner + kGrid + 1, corner + 1});
        }
    return mesh;
}

std::uint32_t middle() { return (kGrid / 2) * kGrid + kGrid / 2; }

/// A hill with its top at a place, of that height and width.
double hill(double x, double y, const Vec3& top, double width)
{
    return top.z()
           * std::exp(-(std::pow(x - top.x(), 2) + std::pow(y - top.y(), 2))
                      / (2.0 * width * width));
}

TriangleMesh turnedOver(TriangleMesh mesh)
{
    for (Triangle& t : mesh.triangles)
        std::swap(t[0], t[1]);
    return mesh;
}

/// The curvature that is fitted to the vertices within `scale` of one.
std::optional<Curvature> curvatureAt(const TriangleMesh& mesh, std::uint32_t vertex, Length scale)
{
    const auto at = [&](std::uint32_t v) { return mesh.positions[v].cast<double>().eval(); };
    std::vector<Vec3> offsets;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        if (const Vec3 offset = at(v) - at(vertex); offset.norm() <= scale.si)
            offsets.push_back(offset);
    Vec3 normal = Vec3::Zero();
    for (const Triangle& t : mesh.triangles)
        if (std::ranges::find(t, vertex) != t.end())
            normal += (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    return fittedCurvature(offsets, normal, scale);
}

} // namespace

class TestSurfaceFeature : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// w = f + d u + e v + ... is exact for these sheets.
    void tellsTheCurvatureOfAParaboloid()
    {
        const TriangleMesh mesh =
            sheet([](double x, double y) { return -0.5 * (40.0 * x * x + 10.0 * y * y); });
        const auto curvature = curvatureAt(mesh, middle(), millimetres(3.0));
        QVERIFY(curvature.has_value());
        QVERIFY(std::abs(curvature->most - 40.0) < 0.01);
        QVERIFY(std::abs(curvature->least - 10.0) < 0.01);
        QVERIFY(std::abs(std::abs(curvature->dir_most.x()) - 1.0) < 1e-6);
    }

    void tellsASaddleAndTheOtherSide()
    {
        const TriangleMesh mesh = sheet([](double x, double y) { return 30.0 * x * y; });
        const auto above = curvatureAt(mesh, middle(), millimetres(3.0));
        QVERIFY(above.has_value());
        QVERIFY(std::abs(above->most - 30.0) < 0.01);
        QVERIFY(std::abs(above->least + 30.0) < 0.01);
        const auto bowl =
            sheet([](double x, double y) { return 0.5 * (40.0 * x * x + 10.0 * y * y); });
        QVERIFY(std::abs(curvatureAt(bowl, middle(), millimetres(3.0))->most + 10.0) < 0.01);
        const auto below = curvatureAt(turnedOver(bowl), middle(), millimetres(3.0));
        QVERIFY(std::abs(below->most - 40.0) < 0.01);
        QVERIFY(std::abs(below->least - 10.0) < 0.01);
    }

    /// On a slope the curvature of z = f(x) is f'' / (1 + f'^2)^(3/2): a cylinder's is the same all
    /// over.
    void tellsTheCurvatureOnASlope()
    {
        constexpr double kRadius = 0.03;
        const TriangleMesh mesh =
            sheet([](double x, double) { return std::sqrt(kRadius * kRadius - x * x) - kRadius; });
        for (const std::uint32_t row : {kGrid / 2, kGrid / 2 + 8, kGrid / 2 - 16}) {
            const auto curvature = curvatureAt(mesh, row * kGrid + kGrid / 2, millimetres(2.0));
            QVERIFY(curvature.has_value());
            QVERIFY2(std::abs(curvature->most * kRadius - 1.0) < 0.02,
                     qPrintable(QString::number(curvature->most * kRadius)));
            QVERIFY(std::abs(curvature->least * kRadius) < 0.02);
            const Vec3 along{0.0, 1.0, 0.0};
            QVERIFY(std::abs(curvature->dir_most.dot(along)) < 1e-3);
        }
    }

    void knowsNoCurvatureWhereTooLittleIsSeen()
    {
        const TriangleMesh mesh = sheet([](double, double) { return 0.0; });
        // Four neighbours lie at one step, and four more across the diagonals.
        QVERIFY(!curvatureAt(mesh, middle(), metres(1.1 * kStep)));
        QVERIFY(curvatureAt(mesh, middle(), metres(1.5 * kStep)));
        const TriangleMesh corner{.positions = {{0, 0, 0}, {1e-3F, 0, 0}, {0, 1e-3F, 0}, {9, 9, 9}},
                                  .normals = {},
                                  .triangles = {{0, 1, 2}}};
        QVERIFY(!curvatureAt(corner, 0, millimetres(5.0)));
        QVERIFY(!curvatureAt(corner, 3, millimetres(5.0)));
    }

    void snapsToTheTipOfAHill_data()
    {
        QTest::addColumn<Vec3>("picked");
        QTest::addColumn<bool>("found");
        QTest::newRow("on it") << Vec3{6e-3, -3e-3, 4e-3} << true;
        QTest::newRow("beside it") << Vec3{0.0, 0.0, 0.0} << true;
        QTest::newRow("just within the radius") << Vec3{15.9e-3, -3e-3, 4e-3} << true;
        QTest::newRow("just beyond it") << Vec3{16.1e-3, -3e-3, 4e-3} << false;
    }

    void snapsToTheTipOfAHill()
    {
        QFETCH(Vec3, picked);
        QFETCH(bool, found);
        const Vec3 top{6e-3, -3e-3, 4e-3};
        const TriangleMesh mesh = sheet([&](double x, double y) { return hill(x, y, top, 3e-3); });
        const auto feature = nearestFeature(mesh, picked, SurfaceFeature::Tip);
        QCOMPARE(feature.has_value(), found);
        if (!feature)
            return;
        QVERIFY((feature->p - top).norm() < 1e-8);
        QCOMPARE(feature->p, mesh.positions[feature->vertex].cast<double>().eval());
        QVERIFY(feature->curvature.least > 100.0);
    }

    /// Of two hills the nearer, unless it is less than half as sharp as the other.
    void takesTheNearerOfTwoTips_data()
    {
        QTest::addColumn<double>("height_mm");
        QTest::addColumn<bool>("taken");
        QTest::addColumn<double>("side"); // on which the mesh begins
        for (const double side : {1.0, -1.0}) {
            const char* where = side > 0.0 ? "at the end" : "at the beginning";
            QTest::addRow("as high, %s", where) << 4.0 << true << side;
            QTest::addRow("somewhat lower, %s", where) << 2.4 << true << side;
            QTest::addRow("much lower, %s", where) << 1.2 << false << side;
        }
    }

    void takesTheNearerOfTwoTips()
    {
        QFETCH(double, height_mm);
        QFETCH(bool, taken);
        QFETCH(double, side);
        const Vec3 high{-9e-3 * side, 0.0, 4e-3};
        const Vec3 low{6e-3 * side, 0.0, height_mm * 1e-3};
        const TriangleMesh mesh = sheet(
            [&](double x, double y) { return hill(x, y, high, 2e-3) + hill(x, y, low, 2e-3); });
        const auto feature = nearestFeature(mesh, {3e-3 * side, 0.0, 0.0}, SurfaceFeature::Tip,
                                            {.radius = millimetres(14.0)});
        QVERIFY(feature.has_value());
        QVERIFY((feature->p - (taken ? low : high)).head<2>().norm() < 1e-8);
    }

    /// One that is half of a half is faint, though there is a half.
    void comparesWithTheStrongestOfAll()
    {
        const Vec3 high{-12e-3, 0.0, 4e-3};
        const Vec3 middle{0.0, 0.0, 2.6e-3};
        const Vec3 low{12e-3, 0.0, 1.6e-3};
        const TriangleMesh mesh = sheet([&](double x, double y) {
            return hill(x, y, high, 2e-3) + hill(x, y, middle, 2e-3) + hill(x, y, low, 2e-3);
        });
        const auto feature = nearestFeature(mesh, {9e-3, 0.0, 0.0}, SurfaceFeature::Tip,
                                            {.radius = millimetres(22.0)});
        QVERIFY(feature.has_value());
        QVERIFY((feature->p - middle).head<2>().norm() < 1e-8);
    }

    /// A roof along y, rounded to 2 mm: its ridge is met straight across from where it was picked.
    void snapsAcrossToARidge()
    {
        const TriangleMesh mesh =
            sheet([](double x, double) { return -0.8 * (std::sqrt(x * x + 4e-6) - 2e-3); });
        for (const double y : {-6e-3, 0.0, 7.5e-3}) {
            const auto feature = nearestFeature(mesh, {5e-3, y, -3e-3}, SurfaceFeature::Ridge);
            QVERIFY(feature.has_value());
            QVERIFY2((feature->p - Vec3{0.0, y, 0.0}).norm() < 1e-8,
                     qPrintable(QString::number(feature->p.x())));
            QVERIFY(std::abs(feature->curvature.dir_most.x()) > 0.99);
        }
        QVERIFY(!nearestFeature(mesh, {0.0, 0.0, 0.0}, SurfaceFeature::Tip));
    }

    void findsNothingWhereNothingStandsOut()
    {
        const TriangleMesh flat = sheet([](double, double) { return 0.0; });
        const TriangleMesh hollow = turnedOver(sheet([](double x, double y) {
            return hill(x, y, {0.0, 0.0, 4e-3}, 3e-3);
        }));
        for (const SurfaceFeature feature : {SurfaceFeature::Tip, SurfaceFeature::Ridge}) {
            QVERIFY(!nearestFeature(flat, Vec3::Zero(), feature));
            QVERIFY(!nearestFeature({}, Vec3::Zero(), feature));
        }
        const auto tip = nearestFeature(hollow, {0.0, 0.0, 4e-3}, SurfaceFeature::Tip,
                                        {.radius = millimetres(3.0)});
        QVERIFY(!tip);
    }

    /// A cone of 90 degrees: its apex, though a fit smooths it over.
    void findsASharpTip()
    {
        const TriangleMesh mesh = sheet([](double x, double y) { return -std::hypot(x, y); });
        const auto feature = nearestFeature(mesh, {4e-3, 3e-3, -5e-3}, SurfaceFeature::Tip);
        QVERIFY(feature.has_value());
        QCOMPARE(feature->vertex, middle());
    }

    /// A hill that bends by less than a tenth of a radian over the scale, and by more.
    void passesOverWhatIsHardlyCurved()
    {
        const auto cap = [](double curvature) {
            return sheet([curvature](double x, double y) {
                // Flattens outwards, so that the top is its most curved place.
                const double square = x * x + y * y;
                return -0.5 * curvature * square + 0.1 * curvature * square * square / 1e-4;
            });
        };
        const FeatureSettings settings{.radius = millimetres(4.0), .scale = millimetres(3.0)};
        QVERIFY(
            !nearestFeature(cap(0.85 * 0.1 / 3e-3), Vec3::Zero(), SurfaceFeature::Tip, settings));
        QVERIFY(
            nearestFeature(cap(1.25 * 0.1 / 3e-3), Vec3::Zero(), SurfaceFeature::Tip, settings));
    }
};

CARINA_TEST(TestSurfaceFeature)

} // namespace carina::surface_feature_test

#include "tst_surface_feature.moc"
