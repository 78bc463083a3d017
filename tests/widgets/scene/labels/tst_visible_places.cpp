#include "engine/geometry/mesh/surface_query.h"
#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_shapes.h"
#include "widgets/scene/labels/visible_places.h"

#include <numbers>
#include <random>

namespace carina::visible_places_test
{
namespace
{

constexpr double kOnSurface = 1e-6; // m, of a point that was computed in two ways
const Vec3 kEye{0.0, -2.0, 0.0};

/// Two metres in front of the origin, with the head up.
SceneSight fromFront()
{
    SceneSight sight;
    sight.pose.p_A_eye = kEye;
    sight.frustum = {-0.5, 0.5, -0.4, 0.4};
    return sight;
}

ScenePart ball(const Vec3& centre, double radius, MaterialGroup group = MaterialGroup::Bone)
{
    ScenePart part;
    part.group = group;
    part.levels = {test::sphere(centre, radius)};
    return part;
}

TriangleMesh drawnMesh(const ScenePart& part, const SceneFrame& frame)
{
    TriangleMesh mesh = *part.levels.back();
    for (Vec3f& p : mesh.positions)
        p = drawnAt(part, p.cast<double>(), frame)->cast<float>();
    return mesh;
}

/// Whether the segment from the eye meets a mesh before the point, by ray and triangles.
bool hides(const TriangleMesh& mesh, const Vec3& p_A)
{
    const auto hit = rayHit(mesh, kEye, p_A - kEye);
    return hit && *hit < 1.0 - 1e-5;
}

/// The place of one part, the others being there too.
std::optional<SurfacePlace> placeOf(const std::vector<ScenePart>& parts, std::size_t which,
                                    const SceneFrame& frame = {},
                                    const SceneSight& sight = fromFront())
{
    const std::array wanted{which};
    return visiblePlaces(parts, wanted, frame, sight).front();
}

} // namespace

class TestVisiblePlaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsWhereACameraSeesAPoint_data();
    void findsWhereACameraSeesAPoint();

    /// Balls at random before and behind each other, by ray casting.
    void liesWhereAnEyeSeesIt()
    {
        std::mt19937 random{5};
        std::uniform_real_distribution<double> somewhere{-0.6, 0.6};
        int found = 0;
        for (int scene = 0; scene < 20; ++scene) {
            std::vector<ScenePart> parts;
            for (int i = 0; i < 12; ++i)
                parts.push_back(ball({somewhere(random), somewhere(random), somewhere(random)},
                                     0.08 + 0.1 * std::abs(somewhere(random)),
                                     i % 3 == 0 ? MaterialGroup::Veil : MaterialGroup::Bone));
            for (std::size_t i = 0; i < parts.size(); ++i) {
                const auto place = placeOf(parts, i);
                if (!place)
                    continue;
                ++found;
                const Vec3 p_A = drawnAt(parts[i], *place, {}).value();
                QVERIFY(distanceTo(*parts[i].levels.back(), p_A) < kOnSurface);
                for (const ScenePart& other : parts)
                    if (other.group == MaterialGroup::Bone || &other == &parts[i])
                        QVERIFY(!hides(*other.levels.back(), p_A));
            }
        }
        QVERIFY(found > 150); // of 240, some of them behind others or outside
    }

    void findsNothingOfWhatIsHidden()
    {
        const ScenePart small = ball({0.0, 0.3, 0.0}, 0.1);
        QVERIFY(placeOf({small}, 0));
        QVERIFY(!placeOf({small, ball({0.0, -0.3, 0.0}, 0.2)}, 0));
        QVERIFY(placeOf({small, ball({0.0, -0.3, 0.0}, 0.2, MaterialGroup::Veil)}, 0));
        QVERIFY(!placeOf({ball({3.0, 0.0, 0.0}, 0.1)}, 0));  // beside the picture
        QVERIFY(!placeOf({ball({0.0, -3.0, 0.0}, 0.1)}, 0)); // behind the eye
    }

    void findsNoPlaceThatIsCutAway()
    {
        SceneSight sight = fromFront();
        sight.section = Section{Vec3::UnitX(), 0.05, Cut::All}; // x above 0.05 is away
        const std::vector parts{ball({0.0, 0.0, 0.0}, 0.2), ball({0.4, 0.0, 0.0}, 0.1),
                                ball({0.4, 0.0, 0.3}, 0.1, MaterialGroup::Tool)};
        const auto half = placeOf(parts, 0, {}, sight);
        QVERIFY(half);
        QVERIFY(drawnAt(parts[0], *half, {})->x() < 0.05);
        QVERIFY(!placeOf(parts, 1, {}, sight));
        QVERIFY(placeOf(parts, 2, {}, sight)); // tools stay whole
    }

    /// A section uncovers what lies behind what it takes away.
    void findsWhatASectionUncovers()
    {
        SceneSight sight = fromFront();
        const std::vector parts{ball({0.0, 0.4, 0.0}, 0.1), ball({0.0, -0.3, 0.0}, 0.2)};
        QVERIFY(!placeOf(parts, 0, {}, sight));
        sight.section = Section{-Vec3::UnitY(), 0.0, Cut::All}; // y below 0 is away
        QVERIFY(placeOf(parts, 0, {}, sight));
        QVERIFY(!placeOf(parts, 1, {}, sight));
    }

    void followsTheBodyAndTheBreath()
    {
        ScenePart tube = ball({0.0, 0.0, 0.0}, 0.1, MaterialGroup::Tool);
        tube.body = "tube";
        QVERIFY(!placeOf({tube}, 0)); // it is not there
        SceneFrame frame;
        const Quat quarter{Eigen::AngleAxisd{0.5 * std::numbers::pi, Vec3::UnitZ()}};
        frame.bodies["tube"] = PlacedBody{RigidTransform{quarter, {0.2, 0.0, 0.1}}, 2.0};
        const auto place = placeOf({tube}, 0, frame);
        QVERIFY(place);
        const Vec3 p_A = drawnAt(tube, *place, frame).value();
        QVERIFY(distanceTo(drawnMesh(tube, frame), p_A) < kOnSurface);
        QVERIFY(!hides(drawnMesh(tube, frame), p_A));
    }

    void liesWellInsideWhatIsSeen()
    {
        const std::vector parts{ball({0.0, 0.0, 0.0}, 0.3)};
        const auto place = placeOf(parts, 0);
        const Vec3 p_A = drawnAt(parts[0], *place, {}).value();
        QVERIFY(std::hypot(p_A.x(), p_A.z()) < 0.03); // the middle of its disc
    }
};

void TestVisiblePlaces::findsWhereACameraSeesAPoint_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<QPointF>("seen");
    QTest::newRow("straight ahead") << 0.0 << 3.0 << 0.0 << QPointF{0.5, 0.5};
    QTest::newRow("upper right corner") << 4.0 << 2.0 << 2.0 << QPointF{1.0, 0.0};
    QTest::newRow("a quarter to the left") << -3.0 << 3.0 << 0.0 << QPointF{0.25, 0.5};
    QTest::newRow("a quarter down") << 0.0 << 2.0 << -1.0 << QPointF{0.5, 0.75};
}

void TestVisiblePlaces::findsWhereACameraSeesAPoint()
{
    constexpr double kSmall = 1e-9;
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    QFETCH(QPointF, seen);
    SceneSight lookingBack;
    lookingBack.pose.p_A_target = Vec3::UnitY();
    lookingBack.frustum = {-2.0, 2.0, -1.0, 1.0};
    const auto found = seenPoint({x, y, z}, lookingBack);
    QVERIFY(found);
    QVERIFY(std::abs(found->at.x() - seen.x()) < kSmall);
    QVERIFY(std::abs(found->at.y() - seen.y()) < kSmall);
    QVERIFY(std::abs(found->depth - y) < kSmall);
    for (const Vec3& outside : {Vec3{4.1, 2, 0}, Vec3{-4.1, 2, 0}, Vec3{0, 2, 2.1},
                                Vec3{0, 2, -2.1}, Vec3{0, -1, 0}, Vec3{0, 0, 0}})
        QVERIFY(!seenPoint(outside, lookingBack));
}

CARINA_TEST(TestVisiblePlaces)

} // namespace carina::visible_places_test

#include "tst_visible_places.moc"
