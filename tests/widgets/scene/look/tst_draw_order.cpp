#include "tests/support/test_class.h"
#include "widgets/scene/look/draw_order.h"

#include <algorithm>
#include <random>

namespace carina::draw_order_test
{

namespace
{

/// Triangles with edges of a millimetre, at depths of their own along z.
struct Stack {
    std::vector<Triangle> triangles;
    std::vector<Vec3f> positions;

    explicit Stack(const std::vector<float>& depths)
    {
        for (const float z : depths) {
            const auto first = static_cast<std::uint32_t>(positions.size());
            triangles.push_back({first, first + 1, first + 2});
            positions.insert(positions.end(), {{0, 0, z}, {1e-3F, 0, z}, {0, 1e-3F, z}});
        }
    }

    /// Which of the depths come in which order.
    [[nodiscard]] std::vector<std::uint32_t> order(const Vec3f& forward) const
    {
        std::vector<std::uint32_t> places;
        for (const Triangle& t : DrawOrder{triangles, positions}.backToFront(forward))
            places.push_back(t[0] / 3);
        return places;
    }
};

using Places = std::vector<std::uint32_t>;

} // namespace

class TestDrawOrder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsTheFarthestFirst();
    void turnsRoundWithTheDirection();
    void keepsTheOrderOfWhatLiesEquallyFar();
    void leavesNeighboursTogether();
    void ordersASceneOfAnyDepth();
    void goesByTheMiddleOfATriangle();
    void takesStepsAsLongAsTheMeanEdge();
    void losesNoTriangle();
    void agreesWithASortOfTheDepths();
    void ordersNothing();
};

void TestDrawOrder::drawsTheFarthestFirst()
{
    QCOMPARE(Stack({1.0F, 3.0F, 2.0F}).order(Vec3f::UnitZ()), (Places{1, 2, 0}));
}

void TestDrawOrder::turnsRoundWithTheDirection()
{
    QCOMPARE(Stack({1.0F, 3.0F, 2.0F}).order(-Vec3f::UnitZ()), (Places{0, 2, 1}));
}

void TestDrawOrder::keepsTheOrderOfWhatLiesEquallyFar()
{
    QCOMPARE(Stack({2.0F, 2.0F, 1.0F, 2.0F}).order(Vec3f::UnitZ()), (Places{0, 1, 3, 2}));
    QCOMPARE(Stack({1.0F, 3.0F, 2.0F}).order(Vec3f::UnitX()), (Places{0, 1, 2}));
}

void TestDrawOrder::leavesNeighboursTogether()
{
    // Within a millimetre of the farthest they stay as they were given; beyond it they do not.
    QCOMPARE(Stack({0.0092F, 0.01F, 0.0096F}).order(Vec3f::UnitZ()), (Places{0, 1, 2}));
    QCOMPARE(Stack({0.0088F, 0.01F, 0.0096F}).order(Vec3f::UnitZ()), (Places{1, 2, 0}));
}

void TestDrawOrder::ordersASceneOfAnyDepth()
{
    QCOMPARE(Stack({-1e6F, 1e9F, 0.9e9F}).order(Vec3f::UnitZ()), (Places{1, 2, 0}));
    QCOMPARE(Stack({2.0F, 2.0F}).order(Vec3f::UnitZ()), (Places{0, 1}));
}

void TestDrawOrder::goesByTheMiddleOfATriangle()
{
    // The first reaches nearer and farther than the second, whose middle is farther.
    const std::vector<Vec3f> positions{{0, 0, 0}, {1, 0, 0},    {0, 1, 9},
                                       {0, 0, 4}, {1, 0, 4.0F}, {0, 1, 4}};
    const DrawOrder order{{{0, 1, 2}, {3, 4, 5}}, positions};
    QCOMPARE(order.backToFront(Vec3f::UnitZ()).front()[0], 3U);
}

void TestDrawOrder::takesStepsAsLongAsTheMeanEdge()
{
    const auto stepOf = [](std::vector<float> edges) {
        std::vector<Triangle> triangles;
        std::vector<Vec3f> positions;
        for (const float edge : edges) {
            const auto first = static_cast<std::uint32_t>(positions.size());
            triangles.push_back({first, first + 1, first + 2});
            positions.insert(positions.end(), {{0, 0, 0}, {edge, 0, 0}, {0, edge, 0}});
        }
        return DrawOrder{triangles, positions}.step();
    };
    QCOMPARE(stepOf({2e-3F, 6e-3F}), 4e-3F);
    QCOMPARE(stepOf({1e-4F}), DrawOrder::kLeastStep);
    QCOMPARE(stepOf({1.0F}), DrawOrder::kMostStep);
}

void TestDrawOrder::losesNoTriangle()
{
    const Stack stack{{5.0F, 1.0F, 4.0F, 1.0F, 3.0F}};
    std::vector<Triangle> ordered =
        DrawOrder{stack.triangles, stack.positions}.backToFront({0.6F, 0.0F, 0.8F});
    std::sort(ordered.begin(), ordered.end());
    QVERIFY(ordered == stack.triangles);
}

void TestDrawOrder::agreesWithASortOfTheDepths()
{
    constexpr std::size_t kMany = 5000;
    std::mt19937 random{7};
    std::uniform_real_distribution<float> depth{0.0F, 1.0F};
    std::vector<float> depths(kMany);
    std::generate(depths.begin(), depths.end(), [&] { return depth(random); });
    const Places places = Stack(depths).order(Vec3f::UnitZ());
    QCOMPARE(places.size(), kMany);
    for (std::size_t i = 1; i < kMany; ++i)
        QVERIFY(depths[places[i]] <= depths[places[i - 1]] + 1.01F * DrawOrder::kLeastStep);
}

void TestDrawOrder::ordersNothing()
{
    QVERIFY(DrawOrder{}.empty());
    QVERIFY(DrawOrder{}.backToFront(Vec3f::UnitZ()).empty());
    QVERIFY(!DrawOrder(Stack({1.0F}).triangles, Stack({1.0F}).positions).empty());
}

CARINA_TEST(TestDrawOrder)

} // namespace carina::draw_order_test

#include "tst_draw_order.moc"
