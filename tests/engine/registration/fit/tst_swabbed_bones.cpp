#include "engine/geometry/mesh/surface_feature.h"
#include "engine/registration/fit/surface_refinement.h"

#include "tests/engine/geometry/mesh/plain_obj.h"
#include "tests/engine/registration/fit/swabbed_shapes.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <algorithm>

namespace carina::swabbed_bones_test
{
namespace
{

constexpr double kNoise = 0.5e-3; // metres, of each coordinate
const RigidTransform kX_AM{rotationFromVector({0.2, -0.4, 1.5}), {0.3, -0.2, 1.1}};

/// Bones of the adult man of BodyParts3D in one mesh.
TriangleMesh bones(const std::filesystem::path& folder, std::initializer_list<const char*> names)
{
    TriangleMesh mesh;
    for (const char* name : names)
        append(mesh, test::plainObj(folder / name));
    return mesh;
}

} // namespace

/// Refinement and snapping on real bones.
class TestSwabbedBones : public QObject
{
    Q_OBJECT

private:
    std::optional<std::filesystem::path> m_folder;

private Q_SLOTS:
    void init()
    {
        m_folder = test::testData("anatomy/bodyparts3d");
        if (!m_folder)
            QSKIP("anatomy/bodyparts3d is not there");
    }

    /// 150 points with 0.5 mm of noise, from a start that lies 4 mm and 3 degrees off.
    void refinesOnRealBones_data()
    {
        QTest::addColumn<bool>("thorax");
        QTest::newRow("mandible") << false;
        QTest::newRow("sternum and fifth ribs") << true;
    }

    void refinesOnRealBones()
    {
        QFETCH(bool, thorax);
        const TriangleMesh mesh = thorax
                                      ? bones(*m_folder, {"thorax/FJ3290.obj", "thorax/FJ3178.obj",
                                                          "thorax/FJ3232.obj", "thorax/FJ3342.obj"})
                                      : bones(*m_folder, {"skull/FJ3289.obj"});
        const SurfaceTree tree{mesh};
        const Vec3 centre = boundsOf(mesh).centre();
        double worstStart = 0.0;
        double worst = 0.0;
        for (unsigned seed = 1; seed <= 10; ++seed) {
            std::mt19937 random{seed};
            std::vector<Vec3> p_MQ;
            for (const Vec3& p_A : test::swabbed(mesh, 150, random))
                p_MQ.push_back(kX_AM.inverse() * (p_A + test::anyStep(kNoise, random)));
            const Vec3 turn = degrees(3.0).si * test::anyStep(1.0, random).normalized();
            const Vec3 shift = 4e-3 * test::anyStep(1.0, random).normalized();
            const Quat R = rotationFromVector(turn);
            const RigidTransform start = RigidTransform{R, centre - R * centre + shift} * kX_AM;
            const auto fit = refineOnSurface(tree, p_MQ, start);
            QVERIFY2(fit.has_value(), fit ? "" : fit.error().detail.c_str());
            QVERIFY(fit->loose.empty());
            double squares = 0.0;
            double before = 0.0;
            for (const Vec3& p_M : p_MQ) {
                squares += (fit->X_AM * p_M - kX_AM * p_M).squaredNorm() / 150.0;
                before += (start * p_M - kX_AM * p_M).squaredNorm() / 150.0;
            }
            worst = std::max(worst, std::sqrt(squares));
            worstStart = std::max(worstStart, std::sqrt(before));
        }
        qInfo("RMS over the swab, worst of 10: %.2f mm before, %.2f mm after", worstStart * 1e3,
              worst * 1e3);
        QVERIFY(worstStart > 4e-3);
        QVERIFY(worst < 0.5e-3);
    }

    /// The process ends bluntly: one corner of its end is sharper than its lowest point. Picked
    /// from wherever near the end, it is always the same.
    void snapsToTheEndOfTheXiphoidProcess()
    {
        const TriangleMesh xiphoid = bones(*m_folder, {"thorax/FJ3153.obj"});
        const Vec3 lowest = std::ranges::min(xiphoid.positions, {}, [](const Vec3f& p) {
                                return p.z();
                            }).cast<double>();
        const FeatureSettings settings{.radius = millimetres(12.0)};
        const auto end = nearestFeature(xiphoid, lowest, SurfaceFeature::Tip, settings);
        QVERIFY(end.has_value());
        QVERIFY((end->p - lowest).norm() < 5e-3);
        QVERIFY(end->p.z() - lowest.z() < 3e-3);
        for (const Vec3& beside : {Vec3{0.0, -5e-3, 7e-3}, Vec3{-4e-3, 0.0, 4e-3}}) {
            const auto again =
                nearestFeature(xiphoid, lowest + beside, SurfaceFeature::Tip, settings);
            QVERIFY(again.has_value());
            QCOMPARE(again->vertex, end->vertex);
        }
        QCOMPARE(nearestFeature(xiphoid, end->p, SurfaceFeature::Tip, settings)->vertex,
                 end->vertex);
    }
};

CARINA_TEST(TestSwabbedBones)

} // namespace carina::swabbed_bones_test

#include "tst_swabbed_bones.moc"
