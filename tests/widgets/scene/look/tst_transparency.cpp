// What lies behind what is computed from the spheres themselves, and how each of them looks is
// measured on it alone, over black and over white: blended by the over operator in the order of
// their depths they must give the picture of all of them together.

#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

#include <algorithm>

namespace carina::transparency_test
{

using namespace carina::test;

namespace
{

constexpr double kTolerance = 4.0; ///< of 255: each blending rounds, and so do both measurements
constexpr double kAtRim = 2.0;     ///< pixels around a silhouette that are left out

struct Ball {
    std::uint16_t id;
    MaterialGroup group;
    Vec3 centre;
    double radius;
    QColor color;
};

ScenePart partOf(const Ball& ball)
{
    ScenePart part = spherePart(ball.id, ball.group, ball.centre, ball.radius);
    part.color = ball.color;
    return part;
}

/// Where the line of sight through a pixel enters a ball: its distance from the eye along it.
std::optional<double> entry(const Ball& ball, const Vec3& eye, const Vec3& way, double radius)
{
    const Vec3 to = ball.centre - eye;
    const double along = to.dot(way);
    const double squared = radius * radius - (to - along * way).squaredNorm();
    if (squared < 0.0)
        return std::nullopt;
    return along - std::sqrt(squared);
}

struct Sight {
    Vec3 eye;
    Vec3 way;
};

/// Through the middle of a pixel, as frontEye() sees it.
Sight sightThrough(int x, int y)
{
    const EyePicture eye = frontEye();
    const double right = (x + 0.5) / kWidth * 2.0 - 1.0;
    const double up = 1.0 - (y + 0.5) / kHeight * 2.0;
    return {{0.0, -kDistance, 0.0},
            Vec3{right * eye.frustum.right, 1.0, up * eye.frustum.top}.normalized()};
}

QImage pictureOf(const std::vector<ScenePart>& parts, Qt::GlobalColor background)
{
    const auto view = shownView(parts, [](int, LocalTime) { return frontFrame(); });
    view->setBackground(background);
    return draws(*view, 3) ? view->picture() : QImage{};
}

using Channels = std::array<double, 3>;

Channels channels(QRgb pixel)
{
    return {double(qRed(pixel)), double(qGreen(pixel)), double(qBlue(pixel))};
}

/// How a ball looks by itself.
struct Alone {
    QImage overBlack;
    QImage overWhite;
};

/// What it does to the light that comes through it at a pixel.
void blend(const Alone& alone, int x, int y, Channels& light)
{
    const Channels black = channels(alone.overBlack.pixel(x, y));
    const Channels white = channels(alone.overWhite.pixel(x, y));
    for (std::size_t k = 0; k < light.size(); ++k)
        light[k] = black[k] + light[k] * (white[k] - black[k]) / 255.0;
}

bool isNearARim(const Ball& ball, const Sight& sight)
{
    const double margin = kAtRim * 2.0 * frontEye().frustum.top / kHeight * kDistance;
    return entry(ball, sight.eye, sight.way, ball.radius + margin).has_value()
           != entry(ball, sight.eye, sight.way, ball.radius - margin).has_value();
}

} // namespace

class TestTransparency : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void blendsOrgansInTheOrderOfTheirDepths_data();
    void blendsOrgansInTheOrderOfTheirDepths();
    void keepsWhatIsOpaqueInFront();
    void blendsFarBeforeNearFromBehindToo();
};

void TestTransparency::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestTransparency::blendsOrgansInTheOrderOfTheirDepths_data()
{
    QTest::addColumn<std::vector<Ball>>("balls");
    using enum MaterialGroup;
    const QColor red{220, 60, 60};
    const QColor green{60, 200, 80};
    const QColor blue{70, 90, 230};
    const QColor sand{230, 210, 150};
    QTest::newRow("one in the other, the innermost first")
        << std::vector<Ball>{{1, Lung, Vec3::Zero(), 0.1, red},
                             {2, Veil, Vec3::Zero(), 0.2, green},
                             {3, Skin, Vec3::Zero(), 0.3, blue}};
    QTest::newRow("one in the other, the outermost first")
        << std::vector<Ball>{{3, Ghost, Vec3::Zero(), 0.3, blue},
                             {2, Lung, Vec3::Zero(), 0.2, green},
                             {1, Skin, {0.02, 0.0, 0.0}, 0.1, red}};
    QTest::newRow("several of one material, one behind the other")
        << std::vector<Ball>{{1, Lung, {0.05, -0.3, 0.0}, 0.15, red},
                             {2, Lung, {0.0, 0.3, 0.05}, 0.2, green},
                             {3, Lung, {-0.05, 0.0, 0.0}, 0.1, blue}};
    QTest::newRow("heart and vessels behind a lung within a chest")
        << std::vector<Ball>{{1, Veil, {0.0, 0.2, 0.0}, 0.1, red},
                             {2, Veil, {0.1, 0.05, 0.05}, 0.04, blue},
                             {3, Lung, {0.05, -0.05, 0.0}, 0.12, sand},
                             {4, Skin, Vec3::Zero(), 0.4, green}};
}

void TestTransparency::blendsOrgansInTheOrderOfTheirDepths()
{
    QFETCH(std::vector<Ball>, balls);
    std::vector<ScenePart> parts;
    std::vector<Alone> alone;
    for (const Ball& ball : balls) {
        parts.push_back(partOf(ball));
        alone.push_back(
            {pictureOf({parts.back()}, Qt::black), pictureOf({parts.back()}, Qt::white)});
    }
    const QImage together = pictureOf(parts, Qt::black);
    QVERIFY(!together.isNull());
    int compared = 0;
    for (int y = 0; y < kHeight; y += 7) {
        for (int x = 0; x < kWidth; x += 7) {
            const Sight sight = sightThrough(x, y);
            std::vector<std::pair<double, std::size_t>> entered;
            bool rim = false;
            for (std::size_t i = 0; i < balls.size(); ++i) {
                rim = rim || isNearARim(balls[i], sight);
                if (const auto at = entry(balls[i], sight.eye, sight.way, balls[i].radius))
                    entered.emplace_back(*at, i);
            }
            if (rim || entered.empty())
                continue;
            std::sort(entered.rbegin(), entered.rend());
            Channels light{};
            for (const auto& [depth, i] : entered)
                blend(alone[i], x, y, light);
            const Channels drawn = channels(together.pixel(x, y));
            for (std::size_t k = 0; k < light.size(); ++k)
                QVERIFY2(std::abs(drawn[k] - light[k]) <= kTolerance,
                         qPrintable(QStringLiteral("(%1, %2): %3, computed %4")
                                        .arg(x)
                                        .arg(y)
                                        .arg(drawn[k])
                                        .arg(light[k])));
            ++compared;
        }
    }
    QVERIFY(compared > 200);
}

void TestTransparency::keepsWhatIsOpaqueInFront()
{
    const Ball bone{1, MaterialGroup::Bone, {0.0, -0.3, 0.0}, 0.1, {220, 60, 60}};
    const Ball lung{2, MaterialGroup::Lung, {0.0, 0.3, 0.0}, 0.3, {70, 90, 230}};
    const QImage alone = pictureOf({partOf(bone)}, Qt::black);
    const QImage together = pictureOf({partOf(lung), partOf(bone)}, Qt::black);
    const QPoint middle{kWidth / 2, kHeight / 2};
    QCOMPARE(together.pixelColor(middle), alone.pixelColor(middle));
}

void TestTransparency::blendsFarBeforeNearFromBehindToo()
{
    // The same two, from in front and from behind: each time the nearer one's colour prevails.
    const std::vector parts{partOf({1, MaterialGroup::Lung, {0.0, -0.3, 0.0}, 0.1, {255, 0, 0}}),
                            partOf({2, MaterialGroup::Lung, {0.0, 0.3, 0.0}, 0.1, {0, 0, 255}})};
    SceneFrame frame = frontFrame();
    const auto view = shownView(parts, [&](int, LocalTime) { return frame; });
    QVERIFY(draws(*view, 3));
    const QPoint middle{kWidth / 2, kHeight / 2};
    const QColor before = view->picture().pixelColor(middle);
    QVERIFY(before.red() > before.blue());
    const double half = std::sqrt(0.5);
    frame.eyes->front().X_AD =
        RigidTransform(Quat(0.0, 0.0, half, half), Vec3(0.0, kDistance, 0.0));
    QVERIFY(draws(*view, 3));
    const QColor behind = view->picture().pixelColor(middle);
    QVERIFY(behind.blue() > behind.red());
}

CARINA_SCREEN_TEST(TestTransparency)

} // namespace carina::transparency_test

#include "tst_transparency.moc"
