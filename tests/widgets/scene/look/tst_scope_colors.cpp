#include "widgets/scene/look/scope_colors.h"

#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_shapes.h"
#include "widgets/scene/look/near_tissue.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace carina::scope_colors_test
{
namespace
{

using test::sphere;

constexpr double kHollow = 6e-3; ///< radius, metres: within reach of its other side
constexpr double kBall = 2e-3;   ///< of what lies in it

/// A ball seen from outside, or one with the normals of who is inside.
std::shared_ptr<TriangleMesh> ball(double radius, bool isSeenInside)
{
    auto mesh = std::make_shared<TriangleMesh>(*sphere(Vec3::Zero(), radius));
    if (isSeenInside)
        for (Vec3f& normal : mesh->normals)
            normal = -normal;
    return mesh;
}

ScenePart tissue(std::uint16_t id, ChestRegion region, std::shared_ptr<const TriangleMesh> mesh)
{
    ScenePart part;
    part.id = id;
    part.region = region;
    part.levels = {std::move(mesh)};
    return part;
}

/// All of them vestibular folds, by id from 1 on.
std::vector<ScenePart> colored(std::vector<ScenePart> parts)
{
    std::vector<SeenStructure> structures(parts.size() + 1, SeenStructure::VestibularFold);
    structures.front() = SeenStructure::Nothing;
    AirwayLandmarks landmarks;
    landmarks.p_A_glottis = {0.0, 0.0, 0.1};
    colorTissue(parts, structures, landmarks);
    return parts;
}

int greenOf(const ScenePart& part, std::size_t vertex) { return part.colors.at(0).at(vertex)[1]; }

int leastGreen(const ScenePart& part)
{
    int least = 255;
    for (std::size_t i = 0; i < part.colors.at(0).size(); ++i)
        least = std::min(least, greenOf(part, i));
    return least;
}

int mostGreen(const ScenePart& part)
{
    int most = 0;
    for (std::size_t i = 0; i < part.colors.at(0).size(); ++i)
        most = std::max(most, greenOf(part, i));
    return most;
}

constexpr double kLength = 0.126;     ///< of a windpipe from the cords, metres
constexpr std::uint32_t kSteps = 420; ///< along it

/// One line along the front or the back of its wall, as an inner face.
ScenePart windpipeLine(bool isBack)
{
    auto mesh = std::make_shared<TriangleMesh>();
    const double side = isBack ? 1.0 : -1.0;
    for (std::uint32_t i = 0; i <= kSteps; ++i) {
        mesh->positions.emplace_back(0.0F, float(side * 8e-3),
                                     float(kLength - kLength * i / kSteps));
        mesh->normals.emplace_back(0.0F, float(-side), 0.0F);
    }
    return tissue(1, ChestRegion::Mediastinum, std::move(mesh));
}

std::vector<int> windpipeGreens(bool isBack)
{
    std::vector parts{windpipeLine(isBack)};
    AirwayLandmarks landmarks;
    landmarks.p_A_glottis = {0.0, 0.0, kLength};
    colorTissue(parts, std::array{SeenStructure::Nothing, SeenStructure::Trachea}, landmarks);
    std::vector<int> greens;
    for (std::size_t i = 0; i < parts.front().colors.at(0).size(); ++i)
        greens.push_back(greenOf(parts.front(), i));
    return greens;
}

} // namespace

/// What a laryngoscope shows has the colours of its structures, darker in hollows.
class TestScopeColors : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void darkensHollowsAndNothingElse();
    void darkensByWhatMovesWithIt();
    void hidesNothingBehindASurface();
    void keepsTheColoursOfASet();
    void givesTheWindpipeRings();
    void leavesTheBackOfTheWindpipe();
};

void TestScopeColors::darkensHollowsAndNothingElse()
{
    const auto outside = colored({tissue(1, ChestRegion::Larynx, ball(kHollow, false))});
    QCOMPARE(leastGreen(outside.front()), outside.front().color.green());
    QCOMPARE(mostGreen(outside.front()), outside.front().color.green());
    const auto inside = colored({tissue(1, ChestRegion::Larynx, ball(kHollow, true))});
    QVERIFY2(mostGreen(inside.front()) < 0.9 * inside.front().color.green(),
             qPrintable(QString::number(mostGreen(inside.front()))));
}

// A ball in a hollow, of the same region and of another.
void TestScopeColors::darkensByWhatMovesWithIt()
{
    const auto both = [](ChestRegion around) {
        return colored({tissue(1, ChestRegion::Larynx, ball(kBall, false)),
                        tissue(2, around, ball(kHollow, true))});
    };
    const auto together = both(ChestRegion::Larynx);
    QVERIFY(mostGreen(together.front()) < together.front().color.green());
    const auto apart = both(ChestRegion::Pharynx);
    QCOMPARE(leastGreen(apart.front()), apart.front().color.green());
}

void TestScopeColors::hidesNothingBehindASurface()
{
    const auto mesh = ball(kHollow, false);
    const NearTissue near{std::array<const TriangleMesh*, 1>{mesh.get()}};
    const Vec3f outside{0.0F, 0.0F, float(1.5 * kHollow)};
    QCOMPARE(near.hiddenAt(outside, Vec3f::UnitZ()), 0.0F);
    QVERIFY(near.hiddenAt(outside, -Vec3f::UnitZ()) > 0.1F);
    QVERIFY(near.hiddenAt(outside, Vec3f::UnitX()) < near.hiddenAt(outside, -Vec3f::UnitZ()));
}

void TestScopeColors::keepsTheColoursOfASet()
{
    ScenePart part = tissue(1, ChestRegion::Larynx, ball(kHollow, false));
    part.colors = {std::vector<Rgb>(part.levels.front()->positions.size(), Rgb{10, 200, 30})};
    QCOMPARE(leastGreen(colored({part}).front()), 200);
}

void TestScopeColors::givesTheWindpipeRings()
{
    const std::vector<int> greens = windpipeGreens(false);
    const int middle = (*std::ranges::min_element(greens) + *std::ranges::max_element(greens)) / 2;
    int begun = 0;
    for (std::size_t i = 1; i < greens.size(); ++i)
        begun += greens[i - 1] <= middle && greens[i] > middle ? 1 : 0;
    QCOMPARE(begun, 21); // one begins at the cords, and one ends at the carina
}

void TestScopeColors::leavesTheBackOfTheWindpipe()
{
    const std::vector<int> greens = windpipeGreens(true);
    QCOMPARE(*std::ranges::min_element(greens), *std::ranges::max_element(greens));
}

CARINA_TEST(TestScopeColors)

} // namespace carina::scope_colors_test

#include "tst_scope_colors.moc"
