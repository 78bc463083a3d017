#include "engine/anatomy/airway/airway_path.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <cmath>
#include <fstream>
#include <sstream>

namespace carina::real_airway_test
{

class TestRealAirway : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheAirwayOfARealPatient();
};

namespace
{

constexpr double kMillimetre = 1e-3;

AnatomyPart part(std::string name, PartRole role, TriangleMesh mesh)
{
    return {std::move(name), role, {}, {std::move(mesh)}};
}

double distance(const Vec3& a, const Vec3& b) { return (a - b).norm(); }

/// Reads `v` and `f` lines, the first index of each corner, millimetres.
TriangleMesh obj(const std::filesystem::path& file)
{
    TriangleMesh mesh;
    std::ifstream stream{file};
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words{line};
        std::string key;
        words >> key;
        if (key == "v") {
            Vec3f p;
            words >> p.x() >> p.y() >> p.z();
            mesh.positions.push_back(1e-3F * p);
        } else if (key == "f") {
            Triangle t{};
            for (std::uint32_t& index : t) {
                std::string corner;
                words >> corner;
                index = std::uint32_t(std::stoul(corner)) - 1;
            }
            mesh.triangles.push_back(t);
        }
    }
    return mesh;
}

} // namespace

void TestRealAirway::findsTheAirwayOfARealPatient()
{
    const auto folder = test::testData("anatomy/bodyparts3d");
    if (!folder)
        QSKIP("anatomy/bodyparts3d is not here");
    constexpr double kCarinaTolerance = 3.0 * kMillimetre;
    constexpr double kPublishedTolerance = 2.0 * kMillimetre; // against the manifest's bounds
    const TriangleMesh trachea = obj(*folder / "airway/FJ2541.obj");
    std::vector<AnatomyPart> parts;
    parts.push_back(part("Trachea", PartRole::Trachea, trachea));
    parts.push_back(part("Right main bronchus proper", PartRole::RightMainBronchus,
                         obj(*folder / "airway/FJ2539.obj")));
    parts.push_back(
        part("Left main bronchus", PartRole::LeftMainBronchus, obj(*folder / "airway/FJ2450.obj")));
    parts.push_back(
        part("Left vocal ligament", PartRole::Larynx, obj(*folder / "larynx/FJ2787.obj")));
    parts.push_back(
        part("Right vocal ligament", PartRole::Larynx, obj(*folder / "larynx/FJ2805.obj")));
    parts.push_back(part("Left upper central secondary incisor tooth", PartRole::Tooth,
                         obj(*folder / "mouth_pharynx/FJ1265.obj")));
    parts.push_back(part("Right upper central secondary incisor tooth", PartRole::Tooth,
                         obj(*folder / "mouth_pharynx/FJ1279.obj")));
    const auto found = findAirway(parts);
    QVERIFY(found.has_value());

    // This trachea ends in a wedge between the bronchi: the carina is its lowest edge.
    Vec3 edge = Vec3::Zero();
    int count = 0;
    for (const Vec3f& p : trachea.positions) {
        if (p.z() < boundsOf(trachea).min.z() + 0.3 * kMillimetre) {
            edge += p.cast<double>();
            ++count;
        }
    }
    QVERIFY2(distance(found->p_A_carina, edge / count) < kCarinaTolerance,
             qPrintable(QString::number(distance(found->p_A_carina, edge / count))));
    QVERIFY(distance(found->p_A_glottis, {-0.00065, -0.1084, 1.4042}) < kPublishedTolerance);
    QVERIFY(std::abs(found->p_A_incisors.x() + 0.00065) < kPublishedTolerance);
    QVERIFY(std::abs(found->p_A_incisors.z() - 1.4523) < kPublishedTolerance);
    const Box box = boundsOf(trachea);
    for (const Vec3& p : found->path_A) {
        if (p.z() < box.max.z() - 3.0 * kMillimetre && p.z() > box.min.z() + 3.0 * kMillimetre)
            QVERIFY(test::windingNumber(trachea, p) > 0.5);
    }
}

CARINA_TEST(TestRealAirway)

} // namespace carina::real_airway_test

#include "tst_real_airway.moc"
