#include "widgets/scene/look/tissue_colors.h"

#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_shapes.h"

#include <array>
#include <memory>
#include <vector>

namespace carina::tissue_colors_test
{
namespace
{

using test::sphere;

constexpr double kRadius = 5e-3; ///< metres
constexpr std::array kStructures{SeenStructure::Nothing, SeenStructure::Epiglottis,
                                 SeenStructure::Tube};

ScenePart part(std::uint16_t id, const Vec3& centre)
{
    ScenePart made;
    made.id = id;
    made.region = ChestRegion::Larynx;
    made.color = Qt::blue;
    made.levels = {sphere(centre, kRadius)};
    return made;
}

/// An epiglottis, and a tube that has nothing to do with the patient.
std::vector<ScenePart> scene() { return {part(1, Vec3::Zero()), part(2, Vec3::UnitX())}; }

/// With its inner face: the wall of a hollow, which is darker.
std::vector<ScenePart> darkScene()
{
    auto parts = scene();
    auto inside = std::make_shared<TriangleMesh>(*parts.front().levels.front());
    for (Vec3f& normal : inside->normals)
        normal = -normal;
    parts.front().levels = {inside};
    return parts;
}

std::vector<ScenePart> colored(TissueColors& colors, std::vector<ScenePart> parts, const char* hash)
{
    AirwayLandmarks landmarks;
    landmarks.p_A_glottis = {0.0, 0.0, 0.1};
    colors.color(parts, kStructures, landmarks, hash);
    return parts;
}

} // namespace

class TestTissueColors : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areThoseOfItsStructures()
    {
        TissueColors colors;
        const auto parts = colored(colors, scene(), "anna");
        QVERIFY(parts.front().color != QColor{Qt::blue});
        QCOMPARE(parts.front().colors.front().size(),
                 parts.front().levels.front()->positions.size());
        QCOMPARE(parts.back().color, QColor{Qt::blue});
        QVERIFY(parts.back().colors.empty());
    }

    /// Other surfaces under the same name tell that nobody looks at them.
    void areWorkedOutOnceForAPatient()
    {
        TissueColors colors;
        const auto first = colored(colors, scene(), "anna");
        const auto again = colored(colors, darkScene(), "anna");
        QCOMPARE(again.front().color, first.front().color);
        QVERIFY(again.front().colors == first.front().colors);
        QCOMPARE(again.back().color, QColor{Qt::blue});
    }

    void areAnewForAnotherPatient()
    {
        TissueColors colors;
        const auto first = colored(colors, scene(), "anna");
        const auto other = colored(colors, darkScene(), "bert");
        QVERIFY(other.front().colors != first.front().colors);
        QVERIFY(colored(colors, scene(), "anna").front().colors == first.front().colors);
    }
};

CARINA_TEST(TestTissueColors)

} // namespace carina::tissue_colors_test

#include "tst_tissue_colors.moc"
