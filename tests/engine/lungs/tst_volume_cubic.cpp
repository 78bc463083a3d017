#include "engine/lungs/displacement_mode.h"
#include "engine/lungs/volume_cubic.h"
#include "tests/engine/lungs/lung_like_mesh.h"

#include <Eigen/LU>
#include <QTest>

#include <random>

using namespace carina;

namespace
{

/// The mesh under x -> x + s (A x + t), whose volume is V0 det(I + s A).
DeformableMesh underLinearField(const TriangleMesh& rest, const Mat3& a, const Vec3& t)
{
    DeformableMesh mesh;
    mesh.rest = rest;
    for (const Vec3f& p : rest.positions)
        mesh.displacement.emplace_back((a * p.cast<double>() + t).cast<float>());
    return mesh;
}

/// det(I + s A) = 1 + s tr A + s^2 (sum of principal minors of A) + s^3 det A.
std::array<double, 4> characteristic(const Mat3& a)
{
    const double minors = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0) + a(0, 0) * a(2, 2)
                          - a(0, 2) * a(2, 0) + a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1);
    return {1.0, a.trace(), minors, a.determinant()};
}

TriangleMesh tetrahedron()
{
    TriangleMesh mesh;
    mesh.positions = {{1, 1, 1}, {3, 1, 1}, {1, 4, 1}, {1, 1, 6}}; // volume 2 * 3 * 5 / 6
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

TriangleMesh box()
{
    TriangleMesh mesh; // 2 x 3 x 4, away from the origin
    for (const float z : {8.0F, 12.0F}) {
        for (const float y : {-1.0F, 2.0F}) {
            for (const float x : {5.0F, 7.0F})
                mesh.positions.emplace_back(x, y, z);
        }
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// Coefficients that single precision holds exactly.
Mat3 someField()
{
    Mat3 a;
    a << 0.5, 0.25, -0.125, 0.75, -0.5, 1.0, 0.0, 0.375, 0.25;
    return a;
}

/// k (s - r0)(s - r1)(s - r2).
VolumeCubic withRoots(double k, double r0, double r1, double r2)
{
    return {{-k * r0 * r1 * r2, k * (r0 * r1 + r1 * r2 + r2 * r0), -k * (r0 + r1 + r2), k}};
}

constexpr double kAmplitudeTolerance = 1e-9;

} // namespace

class TestVolumeCubic : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsBodiesUnderLinearFields_data();
    void knowsBodiesUnderLinearFields();
    void ignoresATranslationOfTheBody();
    void keepsItsDigitsFarFromTheOrigin();
    void convergesToTheSphere();
    void followsARandomSurfaceAtEveryAmplitude();
    void hasNoVolumeWithoutTriangles();
    void addsVolumesOfSeveralMeshes();
    void findsTheRootNearestToTheLast_data();
    void findsTheRootNearestToTheLast();
    void reachesBothEndsOfTheRangeAndNothingBeyond();
    void findsRootsWhereThereIsNoCubicTerm_data();
    void findsRootsWhereThereIsNoCubicTerm();
    void touchesATurningPoint();
    void findsTheVolumeOfALungToAThousandthOfAMillilitre();
    void refusesWhatIsNotANumber();
};

void TestVolumeCubic::knowsBodiesUnderLinearFields_data()
{
    QTest::addColumn<TriangleMesh>("body");
    QTest::addColumn<double>("volume");
    QTest::addColumn<Mat3>("field");
    QTest::newRow("box at rest") << box() << 24.0 << Mat3{Mat3::Zero()};
    QTest::newRow("box that grows") << box() << 24.0 << Mat3{Mat3::Identity()};
    QTest::newRow("box that shears") << box() << 24.0 << someField();
    QTest::newRow("tetrahedron that grows") << tetrahedron() << 5.0 << Mat3{Mat3::Identity()};
    QTest::newRow("tetrahedron that shears") << tetrahedron() << 5.0 << someField();
}

void TestVolumeCubic::knowsBodiesUnderLinearFields()
{
    QFETCH(TriangleMesh, body);
    QFETCH(double, volume);
    QFETCH(Mat3, field);
    const VolumeCubic cubic = volumeCubic(underLinearField(body, field, Vec3{2.0, -1.0, 0.5}));
    const std::array<double, 4> expected = characteristic(field);
    for (std::size_t k = 0; k < 4; ++k)
        QVERIFY(std::abs(cubic.c[k] - volume * expected[k]) < 1e-12 * volume);
    for (const double s : {-1.0, 0.0, 0.5, 2.0}) {
        const double v = volume * (Mat3::Identity() + s * field).determinant();
        QVERIFY(std::abs(cubic.at(s).si - v) < 1e-12 * volume);
    }
}

void TestVolumeCubic::ignoresATranslationOfTheBody()
{
    DeformableMesh mesh = underLinearField(box(), Mat3::Zero(), Vec3{1.0, 2.0, 3.0});
    const VolumeCubic cubic = volumeCubic(mesh);
    QCOMPARE(cubic.c, (std::array<double, 4>{24.0, 0.0, 0.0, 0.0}));
}

// Tetrahedra from the frame's origin would be a million times the volume that they sum up to.
void TestVolumeCubic::keepsItsDigitsFarFromTheOrigin()
{
    const TriangleMesh far = test::lungLikeMesh({4e3, 4e3, 4e3}, {0.06, 0.09, 0.12}, 20, 30);
    const VolumeCubic cubic = volumeCubic(underLinearField(far, Mat3::Zero(), Vec3::Zero()));
    QVERIFY(std::abs(cubic.c[0] - test::volumeByColumns(far)) < 1e-12);
}

// A sphere that grows by s r: 4/3 pi r^3 (1 + s)^3, less what the chords of n patches cut off.
void TestVolumeCubic::convergesToTheSphere()
{
    constexpr std::uint32_t kRings = 200;
    TriangleMesh sphere;
    sphere = test::lungLikeMesh(Vec3::Zero(), Vec3::Constant(0.1), kRings, 2 * kRings);
    for (Vec3f& p : sphere.positions)
        p = 0.1F * p.normalized();
    const VolumeCubic cubic = volumeCubic(underLinearField(sphere, Mat3::Identity(), Vec3::Zero()));
    const double volume = 4.0 / 3.0 * std::numbers::pi * 1e-3;
    constexpr double kChords = 10.0 / (kRings * kRings);
    const std::array<double, 4> binomial{1.0, 3.0, 3.0, 1.0};
    for (std::size_t k = 0; k < 4; ++k) {
        QVERIFY(cubic.c[k] < binomial[k] * volume);
        QVERIFY(cubic.c[k] > binomial[k] * volume * (1.0 - kChords));
    }
}

void TestVolumeCubic::followsARandomSurfaceAtEveryAmplitude()
{
    std::mt19937 random{7};
    std::uniform_real_distribution<float> offset{-0.01F, 0.01F};
    const auto jitter = [&] { return Vec3f{offset(random), offset(random), offset(random)}; };
    DeformableMesh mesh;
    mesh.rest = test::lungLikeMesh({0.07, 0.0, -0.02}, {0.06, 0.09, 0.12}, 20, 30);
    for (Vec3f& p : mesh.rest.positions) {
        p += jitter();
        mesh.displacement.push_back(jitter());
    }
    const VolumeCubic cubic = volumeCubic(mesh);
    for (const double s : {-1.0, -0.3, 0.0, 0.7, 1.0, 2.5, 7.0}) {
        double sixfold = 0.0;
        for (const Triangle& t : mesh.rest.triangles) {
            std::array<Vec3, 3> x;
            for (std::size_t k = 0; k < 3; ++k) {
                x[k] = mesh.rest.positions[t[k]].cast<double>()
                       + s * mesh.displacement[t[k]].cast<double>();
            }
            sixfold += x[0].cross(x[1]).dot(x[2]);
        }
        QVERIFY(std::abs(cubic.at(s).si - sixfold / 6.0) < 1e-15);
    }
}

void TestVolumeCubic::hasNoVolumeWithoutTriangles()
{
    QCOMPARE(volumeCubic(DeformableMesh{}).c, (std::array<double, 4>{}));
}

void TestVolumeCubic::addsVolumesOfSeveralMeshes()
{
    VolumeCubic sum{{1.0, 2.0, 3.0, 4.0}};
    sum += VolumeCubic{{10.0, 20.0, 30.0, 40.0}};
    QCOMPARE(sum.c, (std::array<double, 4>{11.0, 22.0, 33.0, 44.0}));
    QCOMPARE(sum.at(2.0).si, 11.0 + 44.0 + 132.0 + 352.0);
}

void TestVolumeCubic::findsTheRootNearestToTheLast_data()
{
    QTest::addColumn<VolumeCubic>("cubic");
    QTest::addColumn<double>("nearest");
    QTest::addColumn<double>("root");
    const VolumeCubic wide = withRoots(1.0, 1.0, 2.0, 4.0);
    QTest::newRow("below all") << wide << -1.0 << 1.0;
    QTest::newRow("nearly in the middle of two, lower") << wide << 1.49 << 1.0;
    QTest::newRow("nearly in the middle of two, upper") << wide << 1.51 << 2.0;
    QTest::newRow("upper two, lower") << wide << 2.99 << 2.0;
    QTest::newRow("upper two, upper") << wide << 3.01 << 4.0;
    QTest::newRow("above all") << wide << 100.0 << 4.0;
    const VolumeCubic narrow = withRoots(-3.0, 1.0, 1.1, 1.2);
    QTest::newRow("narrow and falling, first") << narrow << 0.0 << 1.0;
    QTest::newRow("narrow and falling, second") << narrow << 1.11 << 1.1;
    QTest::newRow("narrow and falling, third") << narrow << 1.16 << 1.2;
    const VolumeCubic aroundRest = withRoots(2.0, -0.5, 0.0, 0.5);
    QTest::newRow("no square term, first") << aroundRest << -0.3 << -0.5;
    QTest::newRow("no square term, second") << aroundRest << 0.1 << 0.0;
    QTest::newRow("no square term, third") << aroundRest << 0.3 << 0.5;
    QTest::newRow("others outside the range") << withRoots(1.0, -2.0, 3.0, 8.0) << -1.0 << 3.0;
    QTest::newRow("two below the range") << withRoots(1.0, -3.0, -2.0, 6.0) << -1.0 << 6.0;
    QTest::newRow("two above the range") << withRoots(1.0, 0.5, 8.0, 9.0) << 7.0 << 0.5;
    QTest::newRow("one real root") << VolumeCubic{{-8.0, 0.0, 0.0, 1.0}} << 0.0 << 2.0;
    QTest::newRow("one real root, no turning point")
        << VolumeCubic{{-14.0, 3.0, 0.0, 1.0}} << 0.0 << 2.0;
}

void TestVolumeCubic::findsTheRootNearestToTheLast()
{
    QFETCH(VolumeCubic, cubic);
    QFETCH(double, nearest);
    QFETCH(double, root);
    const Result<double> s = amplitudeFor(cubic, cubicMetres(0.0), nearest);
    QVERIFY(s.has_value());
    QVERIFY2(std::abs(*s - root) < kAmplitudeTolerance, qPrintable(QString::number(*s, 'g', 15)));
    // The same cubic raised, asked for a volume raised as much.
    VolumeCubic raised = cubic;
    raised.c[0] += 0.25;
    const Result<double> same = amplitudeFor(raised, cubicMetres(0.25), nearest);
    QVERIFY(same && std::abs(*same - root) < kAmplitudeTolerance);
}

void TestVolumeCubic::reachesBothEndsOfTheRangeAndNothingBeyond()
{
    const VolumeCubic rising{{0.0, 1.0, 0.0, 0.0}};
    QCOMPARE(amplitudeFor(rising, cubicMetres(-1.0), 0.0).value(), -1.0);
    QCOMPARE(amplitudeFor(rising, cubicMetres(7.0), 0.0).value(), 7.0);
    for (const double beyond : {-1.000001, 7.000001}) {
        const Result<double> s = amplitudeFor(rising, cubicMetres(beyond), 0.0);
        QVERIFY(!s);
        QCOMPARE(s.error().code, Errc::VolumeUnreachable);
    }
    const Result<double> tooMuch = amplitudeFor(rising, cubicMetres(9.0), 0.0);
    QVERIFY(tooMuch.error().detail.find("9000000.0") != std::string::npos);
}

void TestVolumeCubic::findsRootsWhereThereIsNoCubicTerm_data()
{
    QTest::addColumn<VolumeCubic>("cubic");
    QTest::addColumn<double>("nearest");
    QTest::addColumn<double>("root");
    QTest::newRow("falling line") << VolumeCubic{{6.0, -2.0, 0.0, 0.0}} << 0.0 << 3.0;
    QTest::newRow("parabola, left") << VolumeCubic{{5.0, -6.0, 1.0, 0.0}} << 2.9 << 1.0;
    QTest::newRow("parabola, right") << VolumeCubic{{5.0, -6.0, 1.0, 0.0}} << 3.1 << 5.0;
    QTest::newRow("parabola at rest, left") << VolumeCubic{{-0.25, 0.0, 1.0, 0.0}} << -0.1 << -0.5;
    QTest::newRow("parabola at rest, right") << VolumeCubic{{0.25, 0.0, -1.0, 0.0}} << 0.1 << 0.5;
}

void TestVolumeCubic::findsRootsWhereThereIsNoCubicTerm() { findsTheRootNearestToTheLast(); }

void TestVolumeCubic::touchesATurningPoint()
{
    const VolumeCubic parabola{{4.0, -4.0, 1.0, 0.0}}; // (s - 2)^2
    QCOMPARE(amplitudeFor(parabola, cubicMetres(0.0), 0.0).value(), 2.0);
    QVERIFY(!amplitudeFor(parabola, cubicMetres(-1e-9), 0.0));
}

void TestVolumeCubic::findsTheVolumeOfALungToAThousandthOfAMillilitre()
{
    const TriangleMesh rest = test::lungLikeMesh({0.07, 0.0, -0.02}, {0.06, 0.09, 0.12}, 30, 40);
    const DeformableMesh mesh =
        makeDeformable(rest, DisplacementMode{boundsOf(rest), Side::Left, Vec3{0.02, 0.0, 0.0}});
    const VolumeCubic cubic = volumeCubic(mesh);
    QVERIFY(std::abs(cubic.at(0.0).si - test::volumeByColumns(rest)) < 1e-12);
    for (const double inspired_ml : {-50.0, -0.001, 0.0, 0.001, 133.0, 280.0, 600.0}) {
        const Volume asked = cubic.at(0.0) + millilitres(inspired_ml);
        const Result<double> s = amplitudeFor(cubic, asked, 0.0);
        QVERIFY(s.has_value());
        const double drawn = test::volumeByColumns(deformed(mesh, float(*s)));
        QVERIFY(std::abs(inMillilitres(cubicMetres(drawn) - asked)) < 1e-3);
    }
}

void TestVolumeCubic::refusesWhatIsNotANumber()
{
    const VolumeCubic rising{{0.0, 1.0, 0.0, 0.0}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const auto& [volume, nearest] : {std::pair{nan, 0.0}, {inf, 0.0}, {1.0, nan}, {1.0, inf}})
        QCOMPARE(amplitudeFor(rising, cubicMetres(volume), nearest).error().code, Errc::NotFinite);
}

QTEST_APPLESS_MAIN(TestVolumeCubic)
#include "tst_volume_cubic.moc"
