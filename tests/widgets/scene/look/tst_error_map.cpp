// Where each error is drawn follows from the quadric and the way that light takes into the eye; a
// plate that faces the eye has no shades, so that bands and lines are all there is to see.

#include "tests/support/test_class.h"
#include "tests/widgets/colour_vision.h"
#include "tests/widgets/scene/plate.h"
#include "widgets/scene/view/graphics.h"

#include <cmath>
#include <vector>

namespace carina::error_map_test
{

using namespace carina::test;

namespace
{

constexpr double kLineReach = 2.0;  ///< pixels to either side of an isoline that may show it
constexpr double kLinePlace = 0.75; ///< pixels by which the middle of one may be off
constexpr int kRounding = 1;        ///< of 255

/// Least at a place and growing unlike in all directions, 1 mm to about 5 mm.
Mat4 someQuadric()
{
    Mat3 shape;
    shape << 1.6e-4, 4e-5, 2e-5, 4e-5, 1e-4, -3e-5, 2e-5, -3e-5, 2.2e-4;
    const Vec3 centre{0.07, 0.1, -0.11};
    Mat4 quadric;
    quadric << shape, -shape * centre, (-shape * centre).transpose(),
        centre.dot(shape * centre) + 1e-6;
    return quadric;
}

double errorAt(const Mat4& quadric, const Vec3& p)
{
    return std::sqrt(p.homogeneous().dot(quadric * p.homogeneous()));
}

/// Where the light in the middle of a pixel comes from: a place in the plane y = 0 of A, as
/// frontEye() sees it.
Vec3 seenAt(double column, double row)
{
    const Frustum frustum = frontEye().frustum;
    return {kDistance * (2.0 * (column + 0.5) / kWidth - 1.0) * frustum.right, 0.0,
            kDistance * (1.0 - 2.0 * (row + 0.5) / kHeight) * frustum.top};
}

/// The column in which x is seen, in pixels from the left edge of the picture.
double columnOf(double x)
{
    return 0.5 * kWidth * (1.0 + x / (kDistance * frontEye().frustum.right));
}

bool isOnPlate(const Vec3& p)
{
    const double margin = kPlate - 0.01;
    return std::abs(p.x()) < margin && std::abs(p.z()) < margin;
}

QImage pictureOf(const std::vector<ScenePart>& parts, const std::optional<ErrorMap>& map,
                 const SceneFrame& frame = frontFrame())
{
    const auto view = shownView(parts, [&](int, LocalTime) { return frame; });
    view->setErrorMap(map);
    return draws(*view, 3) ? view->picture() : QImage{};
}

/// The middles of what lies between stretches of one colour of at least ten pixels.
std::vector<double> linesIn(const QImage& picture, int row)
{
    constexpr int kStretch = 10;
    std::vector<double> lines;
    int end = -1; // of the stretch before
    for (int begin = 0; begin < picture.width();) {
        int next = begin + 1;
        while (next < picture.width() && picture.pixel(next, row) == picture.pixel(begin, row))
            ++next;
        if (next - begin >= kStretch) {
            if (end >= 0)
                lines.push_back(0.5 * (end + begin));
            end = next;
        }
        begin = next;
    }
    return lines;
}

bool isNear(const QColor& a, const QColor& b)
{
    return std::abs(a.red() - b.red()) <= kRounding && std::abs(a.green() - b.green()) <= kRounding
           && std::abs(a.blue() - b.blue()) <= kRounding;
}

double lightness(const QColor& color) { return inLab(color, kSights[0])[0]; }

} // namespace

class TestErrorMap : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void drawsLinesWhereTheErrorIsAMultiple_data();
    void drawsLinesWhereTheErrorIsAMultiple();
    void fillsEachBandWithItsColour();
    void isDarkerTheLargerTheError_data();
    void isDarkerTheLargerTheError();
    void belongsToThePlaceWhereAPartIsDrawn_data();
    void belongsToThePlaceWhereAPartIsDrawn();
    void leavesToolsAsTheyAre();
    void leavesNothingBehindWhenItGoes();
};

void TestErrorMap::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestErrorMap::drawsLinesWhereTheErrorIsAMultiple_data()
{
    QTest::addColumn<double>("width_mm");
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("count");
    QTest::newRow("of half a millimetre") << 0.5 << 1 << 6;
    QTest::newRow("of a millimetre") << 1.0 << 0 << 4;
    QTest::newRow("more than there are bands for") << 0.5 << 2 << 3;
}

/// 5 mm of error per metre from x = -0.4 on: 0.5 mm at the left edge of the plate, 3.5 at the
/// right.
void TestErrorMap::drawsLinesWhereTheErrorIsAMultiple()
{
    QFETCH(const double, width_mm);
    QFETCH(const int, first);
    QFETCH(const int, count);
    const ErrorMap map{growingAlongX(-0.4, 5e-3), {millimetres(width_mm), first, count}};
    const QImage picture = pictureOf({platePart(1, MaterialGroup::Bone)}, map);
    std::vector<double> expected{columnOf(-kPlate)};
    for (double error_mm = width_mm; error_mm < 3.49; error_mm += width_mm)
        if (error_mm > 0.51)
            expected.push_back(columnOf(-0.4 + error_mm / 5.0));
    expected.push_back(columnOf(kPlate));
    const std::vector<double> lines = linesIn(picture, kHeight / 2 + 40);
    QCOMPARE(lines.size(), expected.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        QVERIFY2(std::abs(lines[i] - expected[i]) < kLinePlace,
                 qPrintable(QStringLiteral("%1, not %2").arg(lines[i]).arg(expected[i])));
}

void TestErrorMap::fillsEachBandWithItsColour()
{
    const Mat4 quadric = someQuadric();
    const ErrorBands bands{millimetres(0.5), 2, 7};
    const QImage picture = pictureOf({platePart(1, MaterialGroup::Bone)}, ErrorMap{quadric, bands});
    std::vector<int> compared(static_cast<std::size_t>(bands.count));
    for (int row = 0; row < kHeight; row += 3)
        for (int column = 0; column < kWidth; column += 3) {
            const Vec3 p = seenAt(column, row);
            const double error = errorAt(quadric, p) / bands.width.si;
            const double reach = (errorAt(quadric, seenAt(column + kLineReach, row))
                                  - errorAt(quadric, seenAt(column - kLineReach, row)));
            const double reachUp = (errorAt(quadric, seenAt(column, row + kLineReach))
                                    - errorAt(quadric, seenAt(column, row - kLineReach)));
            const double nearest = std::abs(error - std::round(error)) * bands.width.si;
            if (!isOnPlate(p) || nearest < 0.5 * std::hypot(reach, reachUp))
                continue;
            const int band =
                std::clamp(static_cast<int>(std::floor(error)) - bands.first, 0, bands.count - 1);
            QVERIFY2(
                isNear(picture.pixelColor(column, row), bandColor(band, bands.count)),
                qPrintable(QStringLiteral("band %1 at (%2, %3)").arg(band).arg(column).arg(row)));
            ++compared[static_cast<std::size_t>(band)];
        }
    for (const int pixels : compared)
        QVERIFY(pixels > 50);
}

void TestErrorMap::isDarkerTheLargerTheError_data()
{
    QTest::addColumn<MaterialGroup>("group");
    QTest::addColumn<double>("leastStep"); // of lightness
    QTest::newRow("bone") << MaterialGroup::Bone << 8.0;
    QTest::newRow("lung") << MaterialGroup::Lung << 8.0;
    QTest::newRow("ribs, translucent over black") << MaterialGroup::Veil << 1.0;
}

void TestErrorMap::isDarkerTheLargerTheError()
{
    QFETCH(const MaterialGroup, group);
    QFETCH(const double, leastStep);
    const ErrorBands bands{millimetres(0.5), 1, 6};
    const QImage picture =
        pictureOf({platePart(1, group)}, ErrorMap{growingAlongX(-0.4, 5e-3), bands});
    double before = 101.0;
    for (int band = 0; band < bands.count; ++band) {
        const double middle_m = -0.4 + (inMillimetres(bands.edge(band)) + 0.25) / 5.0;
        const double light =
            lightness(picture.pixelColor(static_cast<int>(columnOf(middle_m)), kHeight / 2));
        QVERIFY2(light < before - (band == 0 ? 0.0 : leastStep),
                 qPrintable(QString::number(light)));
        before = light;
    }
}

void TestErrorMap::belongsToThePlaceWhereAPartIsDrawn_data()
{
    QTest::addColumn<double>("grown");
    QTest::addColumn<double>("moved");
    QTest::newRow("at rest") << 1.0 << 0.0;
    QTest::newRow("swollen by a breath") << 1.1 << 0.0;
    QTest::newRow("moved with its body") << 1.0 << 0.05;
}

void TestErrorMap::belongsToThePlaceWhereAPartIsDrawn()
{
    QFETCH(const double, grown);
    QFETCH(const double, moved);
    ScenePart plate = platePart(1, MaterialGroup::Bone, moved == 0.0 ? "" : "jaw");
    plate.region = moved == 0.0 ? ChestRegion::RightUpperLung : ChestRegion::Still;
    SceneFrame frame = frontFrame();
    frame.chest.field = wideChest();
    frame.chest.motion[static_cast<std::size_t>(ChestRegion::RightUpperLung)] = scaledBy(grown);
    frame.bodies["jaw"] = RigidTransform::translation({moved, 0.0, 0.0});
    const ErrorMap map{growingAlongX(-0.4, 5e-3), {millimetres(1.0), 0, 4}};
    const QImage picture = pictureOf({plate}, map, frame);
    const std::vector<double> lines = linesIn(picture, kHeight / 2);
    QCOMPARE(lines.size(), std::size_t{5}); // two edges, and 1, 2 and 3 mm between them
    for (const int error_mm : {1, 2, 3})
        QVERIFY(
            std::abs(lines[static_cast<std::size_t>(error_mm)] - columnOf(-0.4 + error_mm / 5.0))
            < kLinePlace);
    const double left = kHilum_x + grown * (-kPlate - kHilum_x) + moved;
    QVERIFY(std::abs(lines.front() - columnOf(left)) < kLinePlace); // it did move
}

void TestErrorMap::leavesToolsAsTheyAre()
{
    const std::vector parts{spherePart(1, MaterialGroup::Tool, {0.1, 0.0, 0.0}, 0.2)};
    const QImage plain = pictureOf(parts, {});
    QVERIFY(!plain.isNull());
    QCOMPARE(pictureOf(parts, ErrorMap{someQuadric(), {}}), plain);
}

void TestErrorMap::leavesNothingBehindWhenItGoes()
{
    const std::vector parts{spherePart(1, MaterialGroup::Bone, {-0.2, 0.0, 0.0}, 0.1),
                            spherePart(2, MaterialGroup::Lung, {0.05, 0.0, 0.0}, 0.2),
                            spherePart(3, MaterialGroup::Skin, Vec3::Zero(), 0.35),
                            spherePart(4, MaterialGroup::Tool, {0.1, -0.4, 0.1}, 0.03)};
    const QImage never = pictureOf(parts, {});
    const auto view = shownView(parts, [](int, LocalTime) { return frontFrame(); });
    QVERIFY(draws(*view, 3));
    QCOMPARE(view->picture(), never);
    view->setErrorMap(ErrorMap{someQuadric(), {millimetres(0.5), 2, 7}});
    QVERIFY(draws(*view, 3));
    QVERIFY(view->picture() != never);
    view->setErrorMap({});
    QVERIFY(draws(*view, 3));
    QCOMPARE(view->picture(), never);
}

CARINA_SCREEN_TEST(TestErrorMap)

} // namespace carina::error_map_test

#include "tst_error_map.moc"
