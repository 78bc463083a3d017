#include "engine/geometry/deformable_mesh.h"

#include <QTest>

#include <numbers>

namespace carina
{
namespace
{

constexpr float kPositionTolerance = 1e-6F; // m, single precision near one
constexpr double kNormalTolerance = 2e-6;   // of a unit vector, single precision

/// A displacement field that bends, shears and swells, with its gradient written out.
Vec3 fieldAt(const Vec3& p)
{
    return {0.3 * std::sin(p.y()) + 0.2 * p.x(), 0.25 * p.x() * p.z(),
            0.4 * p.z() * p.z() - 0.1 * p.x()};
}

Mat3 gradientAt(const Vec3& p)
{
    Mat3 gradient;
    gradient << 0.2, 0.3 * std::cos(p.y()), 0.0, //
        0.25 * p.z(), 0.0, 0.25 * p.x(),         //
        -0.1, 0.0, 0.8 * p.z();
    return gradient;
}

Vec3 onSphere(double longitude, double latitude)
{
    return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
            std::sin(latitude)};
}

/// The cofactor matrix from its definition, minor by minor.
Mat3 cofactorOf(const Mat3& m)
{
    Mat3 cofactor;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const int r0 = (i + 1) % 3;
            const int r1 = (i + 2) % 3;
            const int c0 = (j + 1) % 3;
            const int c1 = (j + 2) % 3;
            cofactor(i, j) = m(r0, c0) * m(r1, c1) - m(r0, c1) * m(r1, c0);
        }
    }
    return cofactor;
}

struct Place {
    double longitude = 0.0;
    double latitude = 0.0;
};

std::vector<Place> placesOnSphere()
{
    std::vector<Place> places;
    for (int i = 0; i < 24; ++i) {
        for (int j = -5; j <= 5; ++j)
            places.push_back({2.0 * std::numbers::pi * i / 24, 0.25 * j});
    }
    return places;
}

/// The sphere's places as a mesh, with the normal coefficients of the header's formula.
DeformableMesh deformableSphere()
{
    DeformableMesh mesh;
    for (const Place& place : placesOnSphere()) {
        const Vec3 p = onSphere(place.longitude, place.latitude);
        const Mat3 A = gradientAt(p);
        mesh.rest.positions.push_back(p.cast<float>());
        mesh.rest.normals.push_back(p.cast<float>());
        mesh.displacement.push_back(fieldAt(p).cast<float>());
        mesh.normalLinear.push_back((A.trace() * p - A.transpose() * p).cast<float>());
        mesh.normalQuadratic.push_back((cofactorOf(A) * p).cast<float>());
    }
    mesh.rest.triangles = {{0, 1, 2}, {1, 2, 3}};
    return mesh;
}

/// Where a place of the sphere comes to lie at amplitude s.
Vec3 movedTo(double longitude, double latitude, double s)
{
    const Vec3 p = onSphere(longitude, latitude);
    return p + s * fieldAt(p);
}

/// The normal of the moved surface, from differences of the surface itself.
Vec3 normalByDifferences(const Place& place, double s)
{
    constexpr double kStep = 1e-5; // rad; error about kStep^2
    const Vec3 east = movedTo(place.longitude + kStep, place.latitude, s)
                      - movedTo(place.longitude - kStep, place.latitude, s);
    const Vec3 north = movedTo(place.longitude, place.latitude + kStep, s)
                       - movedTo(place.longitude, place.latitude - kStep, s);
    return east.cross(north).normalized();
}

} // namespace

class DeformableMeshTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void movesPositionsAndTurnsNormalsExactly_data()
    {
        QTest::addColumn<double>("amplitude");
        for (const double amplitude : {0.0, 0.1, 0.5, 1.0, -0.4})
            QTest::addRow("amplitude %g", amplitude) << amplitude;
    }
    void movesPositionsAndTurnsNormalsExactly()
    {
        QFETCH(double, amplitude);
        const std::vector<Place> places = placesOnSphere();
        const TriangleMesh moved = deformed(deformableSphere(), static_cast<float>(amplitude));
        QCOMPARE(moved.positions.size(), places.size());
        QCOMPARE(moved.normals.size(), places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Vec3 expected = movedTo(places[i].longitude, places[i].latitude, amplitude);
            QVERIFY((moved.positions[i] - expected.cast<float>()).norm() < kPositionTolerance);
            const Vec3 normal = normalByDifferences(places[i], amplitude);
            QVERIFY((moved.normals[i].cast<double>() - normal).norm() < kNormalTolerance);
        }
    }

    void keepsItsTriangles()
    {
        const DeformableMesh mesh = deformableSphere();
        QCOMPARE(deformed(mesh, 0.3F).triangles, mesh.rest.triangles);
    }

    void deformsNothingIntoNothing() { QVERIFY(deformed({}, 1.0F).positions.empty()); }
};

} // namespace carina

QTEST_APPLESS_MAIN(carina::DeformableMeshTest)
#include "tst_deformable_mesh.moc"
