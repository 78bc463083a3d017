#include "engine/registration/landmarks/bone_landmarks.h"

#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <fstream>
#include <sstream>

namespace carina::bone_landmarks_test
{
namespace
{

constexpr double kExact = 1e-7; // m, of single precision

/// Bones by a few of their points each, in millimetres: a manubrium with a notch, ribs of which the
/// left crosses the plane of its clavicle and the right ends before it.
struct Thorax {
    std::vector<std::pair<std::string, std::vector<Vec3f>>> surfaces{
        {"Left clavicle", {{10, -60, 50}, {140, 0, 60}}},
        {"Right clavicle", {{-10, -60, 50}, {-150, 0, 60}}},
        {"Manubrium of sternum",
         {{-28, -60, 45}, {30, -60, 45}, {0, -58, 34}, {2, -57, 35}, {5, -60, 39}, {0, -90, 0}}},
        {"Body of sternum", {{0, -90, 0}, {0, -120, -100}}},
        {"XIPHOID process", {{3, -124, -110}, {-1, -125, -124}}},
        {"Left fifth costal cartilage", {{75, -200, -100}}},
        {"Left fifth rib",
         {{90, -150, -120}, {73, -110, -100}, {77, -116, -105}, {79, -118, -104}}},
        {"Right fifth rib", {{-90, -100, -120}, {-85, -112, -104}, {-120, 0, 0}}}};

    Thorax()
    {
        for (auto& [name, points] : surfaces)
            for (Vec3f& p : points)
                p *= 1e-3F;
    }

    void add(const char* name, std::vector<Vec3f> points_mm)
    {
        for (Vec3f& p : points_mm)
            p *= 1e-3F;
        surfaces.emplace_back(name, std::move(points_mm));
    }

    [[nodiscard]] std::vector<Bone> bones() const
    {
        std::vector<Bone> bones;
        for (const auto& [name, points] : surfaces)
            bones.push_back({name, points});
        return bones;
    }
};

bool isAt(const Vec3& p_AQ, const Vec3& p_mm) { return (p_AQ - 1e-3 * p_mm).norm() < kExact; }

bool isAt(const Landmark& landmark, const Vec3& p_mm) { return isAt(landmark.p_AQ, p_mm); }

/// The vertices of an OBJ file, in metres.
std::vector<Vec3f> verticesOf(const std::filesystem::path& file)
{
    std::vector<Vec3f> vertices;
    std::ifstream input{file};
    for (std::string line; std::getline(input, line);) {
        std::istringstream words{line};
        std::string key;
        Vec3f p;
        if (words >> key >> p.x() >> p.y() >> p.z() && key == "v")
            vertices.push_back(1e-3F * p);
    }
    return vertices;
}

} // namespace

class TestBoneLandmarks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheFourPlaces()
    {
        const Thorax thorax;
        const auto catalogue = boneLandmarks(thorax.bones(), "abc");
        QVERIFY(catalogue.has_value());
        QCOMPARE(catalogue->anatomy, std::string{"abc"});
        const auto& landmarks = catalogue->landmarks;
        QCOMPARE(landmarks.size(), 4U);
        QVERIFY(isAt(landmarks[0], {2, -57, 35}));     // not the shoulders beside the notch
        QVERIFY(isAt(landmarks[1], {-1, -125, -124})); // its tip
        QVERIFY(isAt(landmarks[2], {77, -116, -105})); // not further forward beside the plane
        QVERIFY(isAt(landmarks[3], {-85, -112, -104}));
    }

    void namesThemAsTheProportionsDo()
    {
        const Thorax thorax;
        const auto onBones = boneLandmarks(thorax.bones(), {});
        const LandmarkCatalogue byHeight = ribCageCatalogue(metres(1.7), {});
        QVERIFY(onBones.has_value());
        QCOMPARE(onBones->name, byHeight.name);
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(onBones->landmarks[i].name, byHeight.landmarks[i].name);
    }

    void findsNothingWithoutOneOfTheBones_data()
    {
        QTest::addColumn<int>("missing");
        for (const int bone : {0, 1, 2, 4, 6, 7})
            QTest::newRow(Thorax{}.surfaces[std::size_t(bone)].first.c_str()) << bone;
    }

    void findsNothingWithoutOneOfTheBones()
    {
        QFETCH(int, missing);
        Thorax thorax;
        thorax.surfaces.erase(thorax.surfaces.begin() + missing);
        QVERIFY(!boneLandmarks(thorax.bones(), {}));
    }

    void findsNothingOnAnEmptyBone()
    {
        Thorax thorax;
        thorax.surfaces[4].second.clear();
        QVERIFY(!boneLandmarks(thorax.bones(), {}));
    }

    /// The angle of the jaw lies furthest down and back of its half; the end of a rib is its
    /// foremost point.
    void findsTheFurtherPlaces()
    {
        Thorax thorax;
        thorax.add("Mandible", {{0, -90, 160},
                                {48, -20, 170},
                                {50, -10, 172},
                                {45, 0, 200},
                                {-49, -18, 171},
                                {-47, -30, 160}});
        thorax.add("LEFT TENTH RIB", {{110, 20, -240}, {118, -36, -255}, {100, 60, -200}});
        thorax.add("right tenth rib", {{-121, -33, -251}, {-118, -20, -255}});
        const FurtherPlaces places = onBones({}, thorax.bones());
        QVERIFY(isAt(places.p_A_leftJawAngle, {50, -10, 172})); // not 30 mm higher, further back
        QVERIFY(isAt(places.p_A_rightJawAngle, {-49, -18, 171}));
        QVERIFY(isAt(places.p_A_leftTenthRib, {118, -36, -255}));
        QVERIFY(isAt(places.p_A_rightTenthRib, {-121, -33, -251}));
    }

    void leavesPlacesOfBonesThatAreMissing()
    {
        Thorax thorax;
        const FurtherPlaces before = furtherPlaces(metres(1.7));
        const FurtherPlaces without = onBones(before, thorax.bones());
        QVERIFY(without.p_A_leftJawAngle == before.p_A_leftJawAngle);
        QVERIFY(without.p_A_rightTenthRib == before.p_A_rightTenthRib);
        thorax.add("Left half of mandible", {{48, -20, 170}, {50, -10, 172}});
        thorax.add("Right tenth rib", {{-121, -33, -251}});
        const FurtherPlaces half = onBones(before, thorax.bones());
        QVERIFY(isAt(half.p_A_leftJawAngle, {50, -10, 172}));
        QVERIFY(half.p_A_rightJawAngle == before.p_A_rightJawAngle);
        QVERIFY(half.p_A_leftTenthRib == before.p_A_leftTenthRib);
        QVERIFY(isAt(half.p_A_rightTenthRib, {-121, -33, -251}));
    }

    void findsPlacesToCheckThatAreNoLandmarks()
    {
        const Thorax thorax;
        const std::vector<Landmark> checks = boneCheckPlaces(thorax.bones());
        QCOMPARE(checks.size(), 2U);
        QVERIFY(isAt(checks[0], {10, -60, 50}));
        QVERIFY(isAt(checks[1], {-10, -60, 50}));
        const auto catalogue = boneLandmarks(thorax.bones(), {});
        for (const Landmark& check : checks)
            for (const Landmark& landmark : catalogue->landmarks)
                QVERIFY(check.name != landmark.name && check.p_AQ != landmark.p_AQ);
    }

    void findsNoPlacesToCheckWithoutTheirBones_data()
    {
        QTest::addColumn<int>("missing");
        for (const int bone : {0, 1, 2})
            QTest::newRow(Thorax{}.surfaces[std::size_t(bone)].first.c_str()) << bone;
    }

    void findsNoPlacesToCheckWithoutTheirBones()
    {
        QFETCH(int, missing);
        Thorax thorax;
        thorax.surfaces.erase(thorax.surfaces.begin() + missing);
        QVERIFY(boneCheckPlaces(thorax.bones()).empty());
    }

    /// At the height of the airway: the larynx, or else the chin.
    void findsAPlaceToCheckAtTheAirway()
    {
        Thorax thorax;
        thorax.add("Mandible", {{0, -110, 160}, {1, -115, 150}, {50, -17, 175}});
        auto checks = boneCheckPlaces(thorax.bones());
        QCOMPARE(checks.size(), 3U);
        QCOMPARE(checks[0].name, std::string{"Tip of the chin"});
        QVERIFY(isAt(checks[0], {1, -115, 150}));
        thorax.add("Thyroid cartilage", {{20, -30, 120}, {0, -52, 124}, {-20, -30, 120}});
        checks = boneCheckPlaces(thorax.bones());
        QCOMPARE(checks.size(), 3U);
        QCOMPARE(checks[0].name, std::string{"Prominence of the larynx"});
        QVERIFY(isAt(checks[0], {0, -52, 124}));
        thorax.surfaces.erase(thorax.surfaces.begin()); // a clavicle
        QCOMPARE(boneCheckPlaces(thorax.bones()).size(), 1U);
    }

    /// A grown man's: the sternum is 15 to 18 cm long to the tip of its xiphoid process, and both
    /// sides are alike to a few millimetres.
    void findsThemOnARealMan()
    {
        const auto folder = test::testData("anatomy/bodyparts3d/thorax");
        if (!folder)
            QSKIP("anatomy/bodyparts3d is not there");
        Thorax thorax;
        thorax.surfaces = {{"Manubrium", verticesOf(*folder / "FJ3290.obj")},
                           {"Xiphoid process", verticesOf(*folder / "FJ3153.obj")},
                           {"Left fifth rib", verticesOf(*folder / "FJ3232.obj")},
                           {"Right fifth rib", verticesOf(*folder / "FJ3342.obj")},
                           {"Left clavicle", verticesOf(*folder / "FJ3237.obj")},
                           {"Right clavicle", verticesOf(*folder / "FJ3362.obj")}};
        const auto catalogue = boneLandmarks(thorax.bones(), {});
        QVERIFY(catalogue.has_value());
        const auto& q = catalogue->landmarks;
        const double sternum = (q[0].p_AQ - q[1].p_AQ).norm();
        QVERIFY(sternum > 0.15 && sternum < 0.18);
        const Vec3 mirrored{-q[3].p_AQ.x(), q[3].p_AQ.y(), q[3].p_AQ.z()};
        QVERIFY((q[2].p_AQ - mirrored).norm() < 0.006);
        QVERIFY(q[2].p_AQ.x() > 0.07 && q[2].p_AQ.x() < 0.08);
    }
};

CARINA_TEST(TestBoneLandmarks)

} // namespace carina::bone_landmarks_test

#include "tst_bone_landmarks.moc"
