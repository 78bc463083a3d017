#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

#include <cmath>

namespace carina::airway_tint_test
{

using namespace carina::test;

namespace
{

constexpr int kSwitchFrames = 8; ///< after which another shader program is in use
constexpr int kTolerance = 2;    ///< of 255
constexpr Rgb kTint{30, 60, 200};
constexpr QColor kOwn{220, 20, 20}; ///< of spherePart

/// In the middle of the picture.
QColor drawn(const QColor& color, ChestRegion region, const AirwayField& airway, bool isSpotlit)
{
    ScenePart part = spherePart(1, MaterialGroup::SoftTissue, Vec3::Zero(), 0.3);
    part.color = color;
    part.region = region;
    const auto view = shownView({part}, [&airway](int, LocalTime) {
        SceneFrame frame = frontFrame();
        frame.airway = airway;
        return frame;
    });
    if (isSpotlit)
        view->setSpotlight(metres(1.0));
    if (!draws(*view, kSwitchFrames))
        return {};
    return view->picture().pixelColor(kWidth / 2, kHeight / 2);
}

AirwayField tinted(double share)
{
    AirwayField field;
    field.tint({.across = metres(2.0),
                .along = metres(2.0),
                .color = kTint,
                .share = share,
                .tissues = only(AirwayTissue::Larynx)});
    return field;
}

constexpr double kFinePlate = 0.25;       ///< half its width and height, metres
constexpr std::uint32_t kFineSteps = 250; ///< of 2 mm, between which colours are interpolated
constexpr Rgb kWideTint{200, 200, 40};    ///< of the first tint
const Vec3 kCentre{0.05, 0.02, 0.04};     ///< of the last one,
const Vec3 kAxis{2.0 / 3.0, 1.0 / 3.0, -2.0 / 3.0}; ///< whose axis leans out of the plate

/// In the plane y = 0, facing the eye.
ScenePart finePlate(const QColor& color)
{
    auto mesh = std::make_shared<TriangleMesh>();
    for (std::uint32_t row = 0; row <= kFineSteps; ++row)
        for (std::uint32_t column = 0; column <= kFineSteps; ++column) {
            const double x = kFinePlate * (2.0 * column / kFineSteps - 1.0);
            const double z = kFinePlate * (2.0 * row / kFineSteps - 1.0);
            mesh->positions.emplace_back(Vec3{x, 0.0, z}.cast<float>());
            mesh->normals.emplace_back(0.0F, -1.0F, 0.0F);
        }
    for (std::uint32_t row = 0; row < kFineSteps; ++row)
        for (std::uint32_t column = 0; column < kFineSteps; ++column) {
            const std::uint32_t a = row * (kFineSteps + 1) + column;
            const std::uint32_t b = a + kFineSteps + 1;
            mesh->triangles.push_back({a, a + 1, b + 1});
            mesh->triangles.push_back({a, b + 1, b});
        }
    ScenePart part;
    part.id = 1;
    part.group = MaterialGroup::SoftTissue;
    part.color = color;
    part.region = ChestRegion::Larynx;
    part.levels = {std::move(mesh)};
    return part;
}

QImage drawnPlate(const QColor& color, const AirwayField& airway)
{
    const auto view = shownView({finePlate(color)}, [&airway](int, LocalTime) {
        SceneFrame frame = frontFrame();
        frame.airway = airway;
        return frame;
    });
    return draws(*view, kSwitchFrames) ? view->picture() : QImage{};
}

/// A wide sphere first, and in the last place a spheroid twice as long as wide.
AirwayField spheroidOverSphere()
{
    AirwayField field;
    const AirwayTissues tissues = only(AirwayTissue::Larynx);
    field.tint({.across = metres(0.25),
                .along = metres(0.25),
                .color = kWideTint,
                .share = 0.5,
                .tissues = tissues});
    for (std::size_t n = 2; n < kMostTints; ++n)
        field.tint({.across = metres(1.0), .along = metres(1.0), .share = 0.0, .tissues = tissues});
    field.tint({.p_A_centre = kCentre,
                .axis_A = kAxis,
                .across = metres(0.14),
                .along = metres(0.28),
                .color = kTint,
                .share = 0.9,
                .tissues = tissues});
    return field;
}

double metresPerPixel()
{
    return 2.0 * kDistance * std::tan(0.5 * OrbitCamera::kVerticalFieldOfView) / kHeight;
}

/// The pixel in which a place of the plate is drawn, and the place of its middle.
QPoint pixelAt(double x, double z)
{
    return {int(std::floor(0.5 * kWidth + x / metresPerPixel())),
            int(std::floor(0.5 * kHeight - z / metresPerPixel()))};
}

Vec3 placeOf(const QPoint& pixel)
{
    return {(pixel.x() + 0.5 - 0.5 * kWidth) * metresPerPixel(), 0.0,
            (0.5 * kHeight - pixel.y() - 0.5) * metresPerPixel()};
}

/// Of tissue that has kOwn: colours are coded as the square root of light.
QColor tintedAt(const AirwayField& field, const Vec3& p_A)
{
    const Vec3 own{kOwn.redF(), kOwn.greenF(), kOwn.blueF()};
    const Vec3 light =
        airwayLight<double>(field.frame(), AirwayTissue::Larynx, p_A, own.cwiseProduct(own));
    return QColor::fromRgbF(float(std::sqrt(light.x())), float(std::sqrt(light.y())),
                            float(std::sqrt(light.z())));
}

bool areAlike(const QColor& a, const QColor& b)
{
    return a.isValid() && b.isValid() && std::abs(a.red() - b.red()) <= kTolerance
           && std::abs(a.green() - b.green()) <= kTolerance
           && std::abs(a.blue() - b.blue()) <= kTolerance;
}

/// Of light that is mixed: colours are coded as its square root.
int mixed(int own, int tint, double share)
{
    return int(std::lround(std::sqrt((1.0 - share) * own * own + share * tint * tint)));
}

} // namespace

/// Tissue that events colour is drawn as tissue that has this colour.
class TestAirwayTint : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void drawsTissueInTheColourOfATint_data();
    void drawsTissueInTheColourOfATint();
    void drawsASpheroidOverAnotherTint_data();
    void drawsASpheroidOverAnotherTint();
    void leavesOtherTissue();
};

void TestAirwayTint::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestAirwayTint::drawsTissueInTheColourOfATint_data()
{
    QTest::addColumn<double>("share");
    QTest::addColumn<bool>("isSpotlit");
    QTest::newRow("whole, by daylight") << 1.0 << false;
    QTest::newRow("half, by daylight") << 0.5 << false;
    QTest::newRow("whole, by a lamp") << 1.0 << true;
    QTest::newRow("half, by a lamp") << 0.5 << true;
}

void TestAirwayTint::drawsTissueInTheColourOfATint()
{
    QFETCH(double, share);
    QFETCH(bool, isSpotlit);
    const QColor same{mixed(kOwn.red(), kTint[0], share), mixed(kOwn.green(), kTint[1], share),
                      mixed(kOwn.blue(), kTint[2], share)};
    const QColor byTint = drawn(kOwn, ChestRegion::Larynx, tinted(share), isSpotlit);
    QVERIFY(areAlike(byTint, drawn(same, ChestRegion::Larynx, {}, isSpotlit)));
    QVERIFY(!areAlike(byTint, drawn(kOwn, ChestRegion::Larynx, {}, isSpotlit)));
}

void TestAirwayTint::drawsASpheroidOverAnotherTint_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("z");
    QTest::addColumn<double>("least"); // share of the spheroid, of which 0.9 is the whole
    QTest::addColumn<double>("most");
    QTest::newRow("in its middle") << 0.05 << 0.04 << 0.89 << 0.91;
    QTest::newRow("along it, beyond its width") << 0.16 << -0.07 << 0.7 << 0.91;
    QTest::newRow("across it, at its edge") << 0.13 << 0.12 << 0.2 << 0.7;
    QTest::newRow("outside") << -0.1 << -0.15 << 0.0 << 0.0;
}

/// As a plate that has the colour which the formula gives there.
void TestAirwayTint::drawsASpheroidOverAnotherTint()
{
    QFETCH(double, x);
    QFETCH(double, z);
    QFETCH(double, least);
    QFETCH(double, most);
    const AirwayField field = spheroidOverSphere();
    const QPoint pixel = pixelAt(x, z);
    const Vec3 p_A = placeOf(pixel);
    const double share = tintShare<double>(field.frame().tints.back(), p_A);
    QVERIFY2(share >= least && share <= most, qPrintable(QString::number(share)));
    const QColor expected = drawnPlate(tintedAt(field, p_A), {}).pixelColor(pixel);
    QVERIFY(areAlike(drawnPlate(kOwn, field).pixelColor(pixel), expected));
}

void TestAirwayTint::leavesOtherTissue()
{
    for (const ChestRegion region : {ChestRegion::Throat, ChestRegion::Still})
        QVERIFY(areAlike(drawn(kOwn, region, tinted(1.0), false), drawn(kOwn, region, {}, false)));
}

CARINA_SCREEN_TEST(TestAirwayTint)

} // namespace carina::airway_tint_test

#include "tst_airway_tint.moc"
