#include "engine/lungs/drawing/volume_tensor.h"
#include "tests/engine/lungs/drawing/lung_like_mesh.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <numbers>
#include <random>

namespace carina::volume_tensor_test
{

namespace
{

using Amplitudes = VolumeTensor::Amplitudes;
using Fields = VolumeTensor::Fields;

constexpr std::size_t kModes = VolumeTensor::kModes;

/// x -> A x + t at every vertex.
std::vector<Vec3> linearField(const TriangleMesh& mesh, const Mat3& a, const Vec3& t)
{
    std::vector<Vec3> field;
    for (const Vec3f& p : mesh.positions)
        field.emplace_back(a * p.cast<double>() + t);
    return field;
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

Mat3 randomMatrix(std::mt19937& random)
{
    std::uniform_real_distribution<double> number{-1.0, 1.0};
    Mat3 a;
    for (int i = 0; i < 9; ++i)
        a(i / 3, i % 3) = number(random);
    return a;
}

Amplitudes randomAmplitudes(std::mt19937& random)
{
    std::uniform_real_distribution<double> number{-1.0, 1.0};
    Amplitudes amplitudes{};
    for (double& s : amplitudes)
        s = number(random);
    return amplitudes;
}

/// The divergence theorem along z in double, over the vertices moved.
double movedVolume(const TriangleMesh& mesh, const Fields& fields, const Amplitudes& s)
{
    std::vector<Vec3> moved;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        moved.emplace_back(mesh.positions[i].cast<double>());
        for (std::size_t k = 0; k < kModes; ++k)
            moved.back() += s[k] * fields[k][i];
    }
    double volume = 0.0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3 u = moved[j] - moved[i];
        const Vec3 v = moved[k] - moved[i];
        volume += 0.5 * (u.x() * v.y() - u.y() * v.x())
                  * (moved[i].z() + moved[j].z() + moved[k].z()) / 3.0;
    }
    return volume;
}

Amplitudes sum(const Amplitudes& a, double s, const Amplitudes& b)
{
    Amplitudes c{};
    for (std::size_t k = 0; k < kModes; ++k)
        c[k] = a[k] + s * b[k];
    return c;
}

} // namespace

class TestVolumeTensor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsABoxUnderLinearFields();
    void knowsTheCharacteristicPolynomial();
    void ignoresTranslations();
    void keepsItsDigitsFarFromTheOrigin();
    void convergesToTheSphere();
    void followsARandomSurfaceAlongEveryLine();
    void hasNoVolumeWithoutTriangles();
    void addsVolumesOfSeveralMeshes();
};

// V(s) = V0 det(I + sum s_k A_k).
void TestVolumeTensor::knowsABoxUnderLinearFields()
{
    std::mt19937 random{3};
    std::array<Mat3, kModes> a;
    Fields fields;
    for (std::size_t k = 0; k < kModes; ++k) {
        a[k] = randomMatrix(random);
        fields[k] = linearField(box(), a[k], Vec3{2.0, -1.0, 0.5});
    }
    VolumeTensor tensor;
    tensor.add(box(), fields);
    for (int n = 0; n < 50; ++n) {
        const Amplitudes given = randomAmplitudes(random);
        const Amplitudes along = randomAmplitudes(random);
        const VolumeCubic cubic = tensor.along(given, along);
        for (const double s : {-1.0, 0.0, 0.4, 2.0}) {
            Mat3 j = Mat3::Identity();
            for (std::size_t k = 0; k < kModes; ++k)
                j += (given[k] + s * along[k]) * a[k];
            QVERIFY(std::abs(cubic.at(s).si - 24.0 * j.determinant()) < 1e-9);
        }
    }
}

// det(I + s A) = 1 + s tr A + s^2 (sum of principal minors of A) + s^3 det A.
void TestVolumeTensor::knowsTheCharacteristicPolynomial()
{
    std::mt19937 random{5};
    const Mat3 a = randomMatrix(random);
    Fields fields;
    fields.fill(linearField(box(), Mat3::Zero(), Vec3::Zero()));
    fields[3] = linearField(box(), a, Vec3::Zero());
    VolumeTensor tensor;
    tensor.add(box(), fields);
    const double minors = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0) + a(0, 0) * a(2, 2)
                          - a(0, 2) * a(2, 0) + a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1);
    const std::array<double, 4> expected{24.0, 24.0 * a.trace(), 24.0 * minors,
                                         24.0 * a.determinant()};
    const VolumeCubic cubic = tensor.along({}, {0.0, 0.0, 0.0, 1.0, 0.0});
    for (std::size_t k = 0; k < 4; ++k)
        QVERIFY(std::abs(cubic.c[k] - expected[k]) < 1e-10);
}

void TestVolumeTensor::ignoresTranslations()
{
    Fields fields;
    fields.fill(linearField(box(), Mat3::Zero(), Vec3{1.0, 2.0, 3.0}));
    VolumeTensor tensor;
    tensor.add(box(), fields);
    const VolumeCubic cubic = tensor.along({1.0, -2.0, 0.5, 0.0, 3.0}, {1.0, 1.0, 1.0, 1.0, 1.0});
    QVERIFY(std::abs(cubic.c[0] - 24.0) < 1e-12);
    for (std::size_t k = 1; k < 4; ++k)
        QVERIFY(std::abs(cubic.c[k]) < 1e-10);
}

// Tetrahedra from the frame's origin would be a million times the volume that they sum up to.
void TestVolumeTensor::keepsItsDigitsFarFromTheOrigin()
{
    const TriangleMesh far = test::lungLikeMesh({4e3, 4e3, 4e3}, {0.06, 0.09, 0.12}, 20, 30);
    Fields fields;
    fields.fill(linearField(far, Mat3::Zero(), Vec3::Zero()));
    VolumeTensor tensor;
    tensor.add(far, fields);
    QVERIFY(std::abs(tensor.along({}, {}).c[0] - test::volumeByColumns(far)) < 1e-12);
}

// A sphere that grows by s r: 4/3 pi r^3 (1 + s)^3, less what the chords of n patches cut off.
void TestVolumeTensor::convergesToTheSphere()
{
    constexpr std::uint32_t kRings = 100;
    TriangleMesh sphere = test::lungLikeMesh(Vec3::Zero(), Vec3::Constant(0.1), kRings, 2 * kRings);
    for (Vec3f& p : sphere.positions)
        p = 0.1F * p.normalized();
    Fields fields;
    fields.fill(linearField(sphere, Mat3::Zero(), Vec3::Zero()));
    fields[1] = linearField(sphere, Mat3::Identity(), Vec3::Zero());
    VolumeTensor tensor;
    tensor.add(sphere, fields);
    const VolumeCubic cubic = tensor.along({}, {0.0, 1.0, 0.0, 0.0, 0.0});
    const double volume = 4.0 / 3.0 * std::numbers::pi * 1e-3;
    constexpr double kChords = 10.0 / (kRings * kRings);
    const std::array<double, 4> binomial{1.0, 3.0, 3.0, 1.0};
    for (std::size_t k = 0; k < 4; ++k) {
        QVERIFY(cubic.c[k] < binomial[k] * volume);
        QVERIFY(cubic.c[k] > binomial[k] * volume * (1.0 - kChords));
    }
}

void TestVolumeTensor::followsARandomSurfaceAlongEveryLine()
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> offset{-0.01, 0.01};
    const auto jitter = [&] { return Vec3{offset(random), offset(random), offset(random)}; };
    TriangleMesh mesh = test::lungLikeMesh({0.07, 0.0, -0.02}, {0.06, 0.09, 0.12}, 20, 30);
    Fields fields;
    for (Vec3f& p : mesh.positions) {
        p += jitter().cast<float>();
        for (std::vector<Vec3>& field : fields)
            field.push_back(jitter());
    }
    VolumeTensor tensor;
    tensor.add(mesh, fields);
    for (int n = 0; n < 20; ++n) {
        const Amplitudes given = randomAmplitudes(random);
        const Amplitudes along = randomAmplitudes(random);
        const VolumeCubic cubic = tensor.along(given, along);
        for (const double s : {-1.0, 0.0, 0.7, 2.5}) {
            const double volume = movedVolume(mesh, fields, sum(given, s, along));
            QVERIFY(std::abs(cubic.at(s).si - volume) < 1e-15);
        }
    }
}

void TestVolumeTensor::hasNoVolumeWithoutTriangles()
{
    VolumeTensor tensor;
    QCOMPARE(tensor.along({}, {}).c, (std::array<double, 4>{}));
    tensor.add({}, {});
    QCOMPARE(tensor.along({1.0}, {1.0}).c, (std::array<double, 4>{}));
}

void TestVolumeTensor::addsVolumesOfSeveralMeshes()
{
    Fields fields;
    fields.fill(linearField(box(), Mat3::Identity(), Vec3::Zero()));
    VolumeTensor tensor;
    tensor.add(box(), fields);
    tensor.add(box(), fields);
    // Twice 24 (1 + 1 / 2)^3.
    QVERIFY(std::abs(tensor.along({0.5}, {}).c[0] - 162.0) < 1e-10);
}

CARINA_TEST(TestVolumeTensor)

} // namespace carina::volume_tensor_test

#include "tst_volume_tensor.moc"
