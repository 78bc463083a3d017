#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_shapes.h"
#include "widgets/scene/view/parts_on_ray.h"

namespace carina::parts_on_ray_test
{
namespace
{

constexpr double kOnSphere = 2e-3; ///< metres, of a ball made of triangles
const SightRay kFromFront{{0.0, -2.0, 0.0}, Vec3::UnitY()};

ScenePart ball(const Vec3& centre, double radius, MaterialGroup group = MaterialGroup::Bone)
{
    ScenePart part;
    part.group = group;
    part.levels = {test::sphere(centre, radius)};
    return part;
}

std::vector<std::size_t> met(const std::vector<ScenePart>& parts, const SceneFrame& frame = {},
                             const std::optional<Section>& section = {})
{
    std::vector<std::size_t> which;
    for (const PartOnRay& hit : partsOnRay(parts, frame, section, kFromFront))
        which.push_back(hit.part);
    return which;
}

using Parts = std::vector<std::size_t>;

} // namespace

class TestPartsOnRay : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void meetsTheNearestFirstAndNothingBeside()
    {
        const std::vector parts{ball({0.0, 0.5, 0.0}, 0.1), ball({0.0, -0.5, 0.0}, 0.1),
                                ball({0.3, 0.0, 0.0}, 0.1), ball({0.0, -4.0, 0.0}, 0.1)};
        QCOMPARE(met(parts), (Parts{1, 0}));
    }

    void knowsWhereOnTheSurface()
    {
        const std::vector parts{ball(Vec3::Zero(), 0.1)};
        const PartOnRay hit = partsOnRay(parts, {}, {}, kFromFront).front();
        QVERIFY(std::abs(hit.distance - 1.9) < kOnSphere);
        const auto p_A = drawnAt(parts.front(), hit.place, {});
        QVERIFY((*p_A - Vec3{0.0, hit.distance - 2.0, 0.0}).norm() < 1e-6);
    }

    /// The skin is around everything, and nobody means it.
    void meetsFaintOutlinesLast()
    {
        const std::vector parts{ball({0.0, 0.0, 0.0}, 0.5, MaterialGroup::Skin),
                                ball({0.0, 0.0, 0.0}, 0.3, MaterialGroup::Ghost),
                                ball({0.0, 0.0, 0.0}, 0.1, MaterialGroup::Lung)};
        QCOMPARE(met(parts), (Parts{2, 0, 1}));
    }

    void meetsNothingThatIsCutAway()
    {
        const std::vector parts{ball({0.0, -0.5, 0.0}, 0.1), ball({0.0, 0.5, 0.0}, 0.1),
                                ball({0.0, -0.8, 0.0}, 0.1, MaterialGroup::Airway)};
        const Section front{-Vec3::UnitY(), 0.0, Cut::All}; // y above 0 stays
        QCOMPARE(met(parts, {}, front), (Parts{1}));
        QCOMPARE(met(parts, {}, Section{-Vec3::UnitY(), 0.0, Cut::AllButAirway}), (Parts{2, 1}));
        const auto half = partsOnRay(std::vector{ball(Vec3::Zero(), 0.1)}, {}, front, kFromFront);
        QVERIFY(std::abs(half.front().distance - 2.1) < kOnSphere); // the inside of its back
    }

    void meetsBodiesWhereTheyAreDrawn()
    {
        std::vector parts{ball({5.0, 0.0, 0.0}, 0.1)};
        parts.front().body = "tube";
        QVERIFY(met(parts).empty()); // not drawn
        SceneFrame frame;
        frame.bodies["tube"] = RigidTransform::translation({-5.0, 0.0, 0.0});
        QCOMPARE(met(parts, frame), (Parts{0}));
    }

    void looksThroughThePointThatIsSeenThere()
    {
        SceneSight sight;
        sight.pose.p_A_eye = {0.3, -2.0, 0.1};
        sight.pose.p_A_target = {0.2, 0.0, 0.0};
        sight.frustum = {-0.5, 0.4, -0.3, 0.4};
        const Vec3 p_A{0.1, 0.2, 0.1};
        const auto seen = seenPoint(p_A, sight);
        const SightRay ray = rayThrough(seen->at, sight);
        QVERIFY((p_A - ray.p_A_eye).normalized().cross(ray.dir_A).norm() < 1e-9);
    }
};

CARINA_TEST(TestPartsOnRay)

} // namespace carina::parts_on_ray_test

#include "tst_parts_on_ray.moc"
