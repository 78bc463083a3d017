#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace carina::scope_picture_test
{

using namespace carina::test;

namespace
{

constexpr int kSwitchFrames = 8; ///< after which another shader program is in use
constexpr double kLightTolerance = 0.1;
constexpr double kStray = 0.02;     ///< of the albedo, light from everywhere
constexpr double kLampNear2 = 0.25; ///< of the usual distance, squared (organ.vert)
constexpr int kWhite = 215;         ///< of 255, in green and blue of a glint
constexpr int kAlike = 2;           ///< of 255
constexpr double kEven = 1.5;       ///< standard deviation, of 255: pixels beside the ring
constexpr double kUneven = 2.5;

std::optional<std::uint16_t> idAt(const IdPicture& picture, int x, int y)
{
    return picture.ids.at(std::size_t(y) * std::size_t(picture.width) + std::size_t(x));
}

/// Linear red light of a pixel, without the stray light.
double redLight(const QImage& picture, double x, double y)
{
    const QRgb pixel = picture.pixel(int(x * picture.width()), int(y * picture.height()));
    const double albedo = std::pow(220.0 / 255.0, 2.0); // of spherePart
    return std::pow(qRed(pixel) / 255.0, 2.0) - kStray * albedo;
}

/// Of a sphere before the eye and a lamp.
constexpr double kSphereRadius = 0.01;
constexpr double kSphereDistance = 0.05; ///< from its centre to the eye, metres

/// With everything, the eye too, moved in A by so much.
SceneFrame closeFrame(const Vec3& moved = Vec3::Zero())
{
    SceneFrame frame;
    EyePicture eye = frontEye();
    eye.X_AD = RigidTransform{eye.X_AD.rotation(), moved - kSphereDistance * Vec3::UnitY()};
    frame.eyes = {eye};
    frame.bodies["tissue"] = RigidTransform{Quat::Identity(), moved};
    return frame;
}

QImage closePicture(MaterialGroup group, SurfaceLook look, const Vec3& moved = Vec3::Zero())
{
    const auto view = shownView({spherePart(1, group, Vec3::Zero(), kSphereRadius, "tissue")},
                                [moved](int, LocalTime) { return closeFrame(moved); });
    view->setSpotlight(metres(kSphereDistance - kSphereRadius));
    view->setFixedLook(look);
    return draws(*view, kSwitchFrames) ? view->picture() : QImage{};
}

/// The standard deviation of red at one distance from the middle, of 255.
double unevenness(const QImage& picture)
{
    constexpr int kRing = 60; // pixels
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kSteps = 180;
    for (int step = 0; step < kSteps; ++step) {
        const double angle = 2.0 * std::numbers::pi * step / kSteps;
        const double red =
            qRed(picture.pixel(kWidth / 2 + int(std::lround(kRing * std::cos(angle))),
                               kHeight / 2 + int(std::lround(kRing * std::sin(angle)))));
        sum += red;
        squares += red * red;
    }
    const double mean = sum / kSteps;
    return std::sqrt(std::max(squares / kSteps - mean * mean, 0.0));
}

QRgb brightest(const QImage& picture)
{
    QRgb found = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (qBlue(picture.pixel(x, y)) >= qBlue(found))
                found = picture.pixel(x, y);
    return found;
}

} // namespace

/// What a view tells of its picture, and how a lamp beside the eye lights it.
class TestScopePicture : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void tellsTheNearestOpaquePartInEachPixel();
    void tellsAFluid();
    void tellsTheSameWithoutWaiting();
    void tellsNothingOfPartsThatAreGone();
    void tellsNothingWhileNotShown();
    void lightsLessWithTheDistance();
    void glintsWhereMucosaIsMoist();
    void leavesTeethWithoutVessels();
    void keepsReliefOnTissueThatMoves();
    void seesTheSamePartsInEachLook();
};

void TestScopePicture::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestScopePicture::tellsTheNearestOpaquePartInEachPixel()
{
    const std::vector parts{spherePart(7, MaterialGroup::Bone, Vec3::Zero(), 0.1),
                            spherePart(300, MaterialGroup::SoftTissue, {0.0, 0.5, 0.0}, 0.3),
                            spherePart(9, MaterialGroup::Airway, {0.0, -0.5, 0.0}, 0.3)};
    const auto view = shownView(parts, [](int, LocalTime) { return frontFrame(); });
    QVERIFY(draws(*view, 3));
    const IdPicture picture = view->opaqueIds();
    QCOMPARE(picture.width, kWidth);
    QCOMPARE(picture.height, kHeight);
    QVERIFY(idAt(picture, kWidth / 2, kHeight / 2) == std::uint16_t{7});
    // 0.2 m above the middle of the farther sphere, which is 2.5 m away.
    const double focal = 0.5 * kHeight / std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    QVERIFY(idAt(picture, kWidth / 2, kHeight / 2 - int(0.2 / 2.5 * focal)) == std::uint16_t{300});
    QVERIFY(!idAt(picture, 2, 2));
}

void TestScopePicture::tellsAFluid()
{
    const std::vector parts{spherePart(5, MaterialGroup::Fluid, Vec3::Zero(), 0.1)};
    const auto view = shownView(parts, [](int, LocalTime) { return frontFrame(); });
    QVERIFY(draws(*view, 3));
    QVERIFY(idAt(view->opaqueIds(), kWidth / 2, kHeight / 2) == std::uint16_t{5});
}

// Of the frame that was drawn next, while others are drawn.
void TestScopePicture::tellsTheSameWithoutWaiting()
{
    const std::vector parts{spherePart(7, MaterialGroup::Bone, Vec3::Zero(), 0.1)};
    constexpr double kOfEdges = 0.05; // of the pixels, where each is four
    int asked = 0;
    const auto view = shownView(parts, [&asked](int, LocalTime) {
        SceneFrame frame = frontFrame();
        frame.time = SessionTime{std::chrono::seconds{++asked}};
        return frame;
    });
    QVERIFY(draws(*view, 3));
    std::optional<IdPicture> told;
    SessionTime of{};
    view->onIdsRead([&](const IdPicture& ids, const SceneFrame& frame) {
        told = ids;
        of = frame.time;
    });
    view->askForIds();
    const SessionTime next{std::chrono::seconds{asked + 1}};
    QVERIFY(draws(*view, kSwitchFrames));
    QVERIFY(told.has_value());
    QCOMPARE(of, next);
    QCOMPARE(told->width, kWidth / 2);
    QCOMPARE(told->height, kHeight / 2);
    const auto shareOf = [](const IdPicture& picture) {
        return double(std::ranges::count(picture.ids, std::optional{std::uint16_t{7}}))
               / double(picture.ids.size());
    };
    const double whole = shareOf(view->opaqueIds());
    QVERIFY(whole > 0.0);
    QVERIFY(std::abs(shareOf(*told) / whole - 1.0) < kOfEdges);
    QVERIFY(idAt(*told, kWidth / 4, kHeight / 4) == std::uint16_t{7});
    QVERIFY(!idAt(*told, 1, 1));
    told.reset();
    QVERIFY(draws(*view, kSwitchFrames));
    QVERIFY(!told); // once
}

// Replaced after the frame whose ids were asked for, and before they are told.
void TestScopePicture::tellsNothingOfPartsThatAreGone()
{
    const std::vector before{spherePart(7, MaterialGroup::Bone, Vec3::Zero(), 0.1)};
    const std::vector after{spherePart(8, MaterialGroup::Bone, Vec3::Zero(), 0.1)};
    const auto view = shownView(before, [](int, LocalTime) { return frontFrame(); });
    QVERIFY(draws(*view, 3));
    std::optional<IdPicture> told;
    view->onIdsRead([&told](const IdPicture& ids, const SceneFrame&) { told = ids; });
    bool isReplaced = false;
    view->onFrameDrawn([&](const DrawnFrame&) {
        if (!std::exchange(isReplaced, true))
            view->setParts(after);
    });
    view->askForIds();
    QVERIFY(draws(*view, kSwitchFrames));
    QVERIFY(isReplaced);
    QVERIFY(!told);
    view->askForIds();
    QVERIFY(draws(*view, kSwitchFrames));
    QVERIFY(told.has_value());
    QVERIFY(idAt(*told, kWidth / 4, kHeight / 4) == std::uint16_t{8});
}

void TestScopePicture::tellsNothingWhileNotShown()
{
    SceneView view;
    view.setParts(std::vector{spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1)});
    QVERIFY(view.opaqueIds().ids.empty());
}

// Of two spheres that face the eye alike, 1 m and 2 m away, in a light that is the usual at 0.5 m:
// nearly by the square of the distance.
void TestScopePicture::lightsLessWithTheDistance()
{
    const std::vector parts{spherePart(1, MaterialGroup::Bone, {-0.1, -1.0, 0.0}, 0.05),
                            spherePart(2, MaterialGroup::Bone, {0.2, 0.0, 0.0}, 0.1)};
    const auto view = shownView(parts, [](int, LocalTime) { return frontFrame(); });
    view->setSpotlight(metres(0.5));
    QVERIFY(draws(*view, kSwitchFrames));
    const QImage picture = view->picture();
    const double focal = 0.5 * kHeight / std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    const double aside = 0.1 * focal / kWidth; // shares of the picture's width
    const double ratio = redLight(picture, 0.5 - aside, 0.5) / redLight(picture, 0.5 + aside, 0.5);
    const double expected = (16.0 + kLampNear2) / (4.0 + kLampNear2);
    QVERIFY2(std::abs(ratio / expected - 1.0) < kLightTolerance,
             qPrintable(QString::number(ratio)));
}

// The film of moisture mirrors the white lamp; what is below is red.
void TestScopePicture::glintsWhereMucosaIsMoist()
{
    const QRgb moist = brightest(closePicture(MaterialGroup::SoftTissue, SurfaceLook::Moist));
    QVERIFY2(qGreen(moist) > kWhite && qBlue(moist) > kWhite,
             qPrintable(QString::number(moist, 16)));
    const QRgb plain = brightest(closePicture(MaterialGroup::SoftTissue, SurfaceLook::Plain));
    QVERIFY2(qBlue(plain) < kWhite, qPrintable(QString::number(plain, 16)));
}

// Around the middle a sphere is lit evenly; relief and vessels make it uneven.
void TestScopePicture::leavesTeethWithoutVessels()
{
    const double mucosa = unevenness(closePicture(MaterialGroup::SoftTissue, SurfaceLook::Moist));
    const double teeth = unevenness(closePicture(MaterialGroup::Bone, SurfaceLook::Moist));
    QVERIFY2(teeth < kEven && mucosa > kUneven,
             qPrintable(QStringLiteral("%1, %2 of 255").arg(teeth).arg(mucosa)));
}

// By binary fractions of a metre, so that nothing is rounded otherwise.
void TestScopePicture::keepsReliefOnTissueThatMoves()
{
    const QImage before = closePicture(MaterialGroup::SoftTissue, SurfaceLook::Moist);
    const QImage after =
        closePicture(MaterialGroup::SoftTissue, SurfaceLook::Moist, {0.03125, 0.0625, -0.015625});
    QVERIFY(unevenness(before) > kUneven);
    int different = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            if (std::abs(qRed(before.pixel(x, y)) - qRed(after.pixel(x, y))) > kAlike)
                ++different;
    QVERIFY2(different < kWidth * kHeight / 1000, qPrintable(QString::number(different)));
}

void TestScopePicture::seesTheSamePartsInEachLook()
{
    const std::vector parts{spherePart(7, MaterialGroup::Bone, Vec3::Zero(), 0.1),
                            spherePart(300, MaterialGroup::SoftTissue, {0.0, 0.5, 0.0}, 0.3)};
    const auto view = shownView(parts, [](int, LocalTime) { return frontFrame(); });
    view->setSpotlight(metres(2.0));
    QVERIFY(draws(*view, kSwitchFrames));
    const IdPicture plain = view->opaqueIds();
    view->setFixedLook(SurfaceLook::Moist);
    QVERIFY(draws(*view, kSwitchFrames));
    QVERIFY(!view->isPreparing());
    QVERIFY(view->opaqueIds().ids == plain.ids);
}

CARINA_SCREEN_TEST(TestScopePicture)

} // namespace carina::scope_picture_test

#include "tst_scope_picture.moc"
