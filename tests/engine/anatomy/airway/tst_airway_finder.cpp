#include "engine/anatomy/airway/airway_path.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina::airway_finder_test
{

class TestAirwayFinder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void carinaLiesBetweenTheMainBronchi();
    void withoutBronchiTheTracheaEndsAtItsLowestPoint();
    void glottisLiesBetweenTheVocalLigaments();
    void withoutLigamentsTheGlottisStandsAboveTheTrachea();
    void incisorsAreTheLowerEdgesOfTheUpperCentralTeeth();
    void withoutTeethIncisorsStandInFrontOfTheMandible();
    void withoutMandibleIncisorsAreAtTheUsualDistance();
    void pathRunsFromInFrontOfTheTeethToTheCarina();
    void refusesASetWithoutATrachea_data();
    void refusesASetWithoutATrachea();
};

namespace
{

constexpr double kMillimetre = 1e-3;
const Vec3 kOrigin{0.012, -0.083, 1.285}; ///< a set's origin is anywhere

/// A closed cylinder.
TriangleMesh cylinder(const Vec3& from, const Vec3& to, double radius)
{
    constexpr std::uint32_t kSides = 48;
    constexpr std::uint32_t kRings = 60;
    const Vec3 axis = (to - from).normalized();
    const Vec3 side = axis.unitOrthogonal();
    const Vec3 other = axis.cross(side);
    TriangleMesh mesh;
    for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
        for (std::uint32_t k = 0; k < kSides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kSides;
            const Vec3 centre = from + double(ring) / kRings * (to - from);
            mesh.positions.push_back(
                (centre + radius * (std::cos(angle) * side + std::sin(angle) * other))
                    .cast<float>());
        }
    }
    for (std::uint32_t ring = 0; ring < kRings; ++ring) {
        for (std::uint32_t k = 0; k < kSides; ++k) {
            const std::uint32_t a = ring * kSides + k;
            const std::uint32_t b = ring * kSides + (k + 1) % kSides;
            mesh.triangles.push_back({a, b, b + kSides});
            mesh.triangles.push_back({a, b + kSides, a + kSides});
        }
    }
    for (std::uint32_t k = 2; k < kSides; ++k) {
        mesh.triangles.push_back({0, k, k - 1});
        const std::uint32_t top = kRings * kSides;
        mesh.triangles.push_back({top, top + k - 1, top + k});
    }
    return mesh;
}

TriangleMesh block(const Vec3& low, const Vec3& high)
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.emplace_back(float((corner & 1) != 0 ? high.x() : low.x()),
                                    float((corner & 2) != 0 ? high.y() : low.y()),
                                    float((corner & 4) != 0 ? high.z() : low.z()));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

AnatomyPart part(std::string name, PartRole role, TriangleMesh mesh)
{
    return {std::move(name), role, {}, {std::move(mesh)}};
}

const Vec3 kUp = Vec3{0.0, -0.2, 1.0}.normalized();
constexpr double kTracheaLength = 0.1;

/// A trachea that leans forward and two bronchi whose inner walls part at the set's origin.
std::vector<AnatomyPart> plainAirway()
{
    constexpr double kRadius = 6.0 * kMillimetre;
    std::vector<AnatomyPart> parts;
    parts.push_back(part("Trachea", PartRole::Trachea,
                         cylinder(kOrigin, kOrigin + kTracheaLength * kUp, 8.0 * kMillimetre)));
    for (const double side : {-1.0, 1.0}) {
        const double angle = degrees(side < 0.0 ? 27.0 : 46.0).si;
        const Vec3 down{side * std::sin(angle), 0.0, -std::cos(angle)};
        const Vec3 outward{side * std::cos(angle), 0.0, std::sin(angle)};
        const Vec3 start = kOrigin + kRadius * outward;
        parts.push_back(part(side < 0.0 ? "Right main bronchus" : "Left main bronchus",
                             side < 0.0 ? PartRole::RightMainBronchus : PartRole::LeftMainBronchus,
                             cylinder(start, start + 0.04 * down, kRadius)));
    }
    return parts;
}

double distance(const Vec3& a, const Vec3& b) { return (a - b).norm(); }

} // namespace

void TestAirwayFinder::carinaLiesBetweenTheMainBronchi()
{
    const auto found = findAirway(plainAirway());
    QVERIFY(found.has_value());
    QVERIFY(distance(found->p_A_carina, kOrigin) < 1.0 * kMillimetre);
}

void TestAirwayFinder::withoutBronchiTheTracheaEndsAtItsLowestPoint()
{
    const std::vector<AnatomyPart> trachea{plainAirway().front()};
    const auto found = findAirway(trachea);
    QVERIFY(found.has_value());
    QVERIFY(std::abs(found->p_A_carina.z() - boundsOf(trachea.front().levels.front()).min.z())
            < 1e-6);
}

void TestAirwayFinder::glottisLiesBetweenTheVocalLigaments()
{
    const Vec3 glottis = kOrigin + 0.12 * kUp;
    const Vec3 half{1.0 * kMillimetre, 7.0 * kMillimetre, 1.0 * kMillimetre};
    std::vector<AnatomyPart> parts = plainAirway();
    for (const double side : {-1.0, 1.0}) {
        const Vec3 middle = glottis + 3.0 * side * kMillimetre * Vec3::UnitX();
        parts.push_back(part(side < 0.0 ? "Right vocal ligament" : "Left vocal ligament",
                             PartRole::Larynx, block(middle - half, middle + half)));
    }
    const auto found = findAirway(parts);
    QVERIFY(found.has_value());
    QVERIFY(distance(found->p_A_glottis, glottis) < 1e-6);
}

void TestAirwayFinder::withoutLigamentsTheGlottisStandsAboveTheTrachea()
{
    constexpr double kTolerance = 3.0 * kMillimetre;
    const auto found = findAirway(plainAirway());
    QVERIFY(found.has_value());
    // Cords to carina 12.7 cm where the trachea measures 10.1 cm.
    const Vec3 glottis = kOrigin + 12.7 / 10.1 * kTracheaLength * kUp;
    QVERIFY2(distance(found->p_A_glottis, glottis) < kTolerance,
             qPrintable(QString::number(distance(found->p_A_glottis, glottis))));
}

void TestAirwayFinder::incisorsAreTheLowerEdgesOfTheUpperCentralTeeth()
{
    std::vector<AnatomyPart> parts = plainAirway();
    const Vec3 edge = kOrigin + Vec3{0.0, -0.1, 0.17};
    const Vec3 size{8.0 * kMillimetre, 3.0 * kMillimetre, 10.0 * kMillimetre};
    const auto tooth = [&](const char* name, double x, double z) {
        const Vec3 low = edge + Vec3{x, -1.5 * kMillimetre, z};
        parts.push_back(part(name, PartRole::Tooth, block(low, low + size)));
    };
    tooth("Right upper central secondary incisor tooth", -8.0 * kMillimetre, 0.0);
    tooth("Left upper central secondary incisor tooth", 0.0, 0.0);
    tooth("Left upper lateral secondary incisor tooth", 8.0 * kMillimetre, 0.0);
    tooth("Left lower central secondary incisor tooth", 0.0, -0.02);
    const auto found = findAirway(parts);
    QVERIFY(found.has_value());
    QVERIFY(distance(found->p_A_incisors, edge) < 1e-6);
}

void TestAirwayFinder::withoutTeethIncisorsStandInFrontOfTheMandible()
{
    std::vector<AnatomyPart> parts = plainAirway();
    const Vec3 low = kOrigin + Vec3{-0.05, -0.1, 0.12};
    parts.push_back(part("Mandible", PartRole::Mandible,
                         cylinder(low + Vec3{0.05, 0.0, 0.0}, low + Vec3{0.05, 0.0, 0.03}, 0.02)));
    const auto found = findAirway(parts);
    QVERIFY(found.has_value());
    const Vec3 expected = low + Vec3{0.05, -0.02 - 0.01, 0.03 + 0.01};
    QVERIFY(distance(found->p_A_incisors, expected) < 1.0 * kMillimetre);
}

void TestAirwayFinder::withoutMandibleIncisorsAreAtTheUsualDistance()
{
    constexpr double kTolerance = 6.0 * kMillimetre;
    const auto found = findAirway(plainAirway());
    QVERIFY(found.has_value());
    double along = 0.0;
    for (std::size_t i = 1; i < found->path_A.size(); ++i)
        along += distance(found->path_A[i], found->path_A[i - 1]);
    // In front of the teeth, teeth to cords, cords to carina.
    const double expected = 0.1 + (13.5 + 12.7) / 10.1 * kTracheaLength;
    QVERIFY2(std::abs(along - expected) < kTolerance, qPrintable(QString::number(along)));
    QVERIFY(found->p_A_incisors.y() < found->p_A_glottis.y());
    QVERIFY(found->p_A_incisors.z() > found->p_A_glottis.z());
}

void TestAirwayFinder::pathRunsFromInFrontOfTheTeethToTheCarina()
{
    const std::vector<AnatomyPart> parts = plainAirway();
    const auto found = findAirway(parts);
    QVERIFY(found.has_value());
    const std::vector<Vec3>& path = found->path_A;
    QVERIFY(std::abs(distance(path.front(), found->p_A_incisors) - 0.1) < 1e-9);
    QVERIFY(distance(path.back(), found->p_A_carina) < 1e-9);
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        const Vec3 before = path[i] - path[i - 1];
        const Vec3 after = path[i + 1] - path[i];
        QVERIFY(before.norm() < 2.0 * kMillimetre + 1e-9);
        QVERIFY(before.normalized().dot(after.normalized()) > std::cos(degrees(12.0).si));
        const double along = (path[i] - kOrigin).dot(kUp);
        if (along > 5.0 * kMillimetre && along < kTracheaLength - 5.0 * kMillimetre) {
            const double off = (path[i] - kOrigin - along * kUp).norm();
            QVERIFY2(off < 2.5 * kMillimetre, qPrintable(QString::number(off)));
        }
    }
}

void TestAirwayFinder::refusesASetWithoutATrachea_data()
{
    QTest::addColumn<bool>("hasPart");
    QTest::addColumn<double>("length");
    QTest::newRow("nothing") << false << 0.0;
    QTest::newRow("a trachea without triangles") << true << 0.0;
    QTest::newRow("a trachea of one centimetre") << true << 0.01;
}

void TestAirwayFinder::refusesASetWithoutATrachea()
{
    QFETCH(bool, hasPart);
    QFETCH(double, length);
    std::vector<AnatomyPart> parts;
    if (hasPart)
        parts.push_back(part("Trachea", PartRole::Trachea,
                             length > 0.0 ? cylinder(Vec3::Zero(), length * Vec3::UnitZ(), 0.008)
                                          : TriangleMesh{}));
    const auto found = findAirway(parts);
    QVERIFY(!found.has_value());
    QCOMPARE(found.error().code, Errc::NoAirway);
}

CARINA_TEST(TestAirwayFinder)

} // namespace carina::airway_finder_test

#include "tst_airway_finder.moc"
