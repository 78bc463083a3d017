// Edges of a picture in each quality, against how much of each pixel a plate covers, by geometry.

#include "tests/support/test_class.h"
#include "tests/widgets/scene/plate.h"
#include "widgets/scene/view/graphics.h"

#include <algorithm>
#include <cmath>

namespace carina::picture_edges_test
{

using namespace carina::test;

namespace
{

constexpr std::size_t kSwitchFrames = 4; ///< after which another quality is in use
constexpr int kSubpixels = 16;           ///< across a pixel, of the truth
constexpr QColor kGround{128, 128, 128};
const Angle kTilt = degrees(12.0); ///< of the plate in the picture

SceneFrame tiltedFrame()
{
    SceneFrame frame = frontFrame();
    const double half = 0.5 * kTilt.si;
    frame.bodies["plate"] =
        RigidTransform{Quat{std::cos(half), 0.0, std::sin(half), 0.0}, Vec3::Zero()};
    return frame;
}

std::unique_ptr<SceneView> plateView()
{
    auto view = shownView({platePart(1, MaterialGroup::Bone, "plate")},
                          [](int, LocalTime) { return tiltedFrame(); });
    view->setBackground(kGround);
    return view;
}

double metresPerPixel()
{
    return 2.0 * kDistance * std::tan(0.5 * OrbitCamera::kVerticalFieldOfView) / kHeight;
}

/// How far a place of the picture, in pixels from its upper left corner, is outside of the plate,
/// by the larger of both ways along its edges; below 0 inside.
double outside_px(double column, double row)
{
    const double x = column - 0.5 * kWidth;
    const double z = 0.5 * kHeight - row;
    const double across = std::cos(kTilt.si) * x - std::sin(kTilt.si) * z;
    const double up = std::sin(kTilt.si) * x + std::cos(kTilt.si) * z;
    return std::max(std::abs(across), std::abs(up)) - kPlate / metresPerPixel();
}

/// The share of a pixel that the plate covers.
double coverage(int column, int row)
{
    const double middle = outside_px(column + 0.5, row + 0.5);
    if (std::abs(middle) > 1.0)
        return middle > 0.0 ? 0.0 : 1.0;
    int inside = 0;
    for (int i = 0; i < kSubpixels; ++i)
        for (int j = 0; j < kSubpixels; ++j)
            if (outside_px(column + (i + 0.5) / kSubpixels, row + (j + 0.5) / kSubpixels) < 0.0)
                ++inside;
    return double(inside) / (kSubpixels * kSubpixels);
}

/// Colours are coded as the square root of light.
double lightIn(const QColor& color) { return std::pow(double(color.blueF()), 2.0); }

/// How far the share of the plate's light in the pixels of its edges is from what they show of it,
/// on average; nothing where the picture has no plate.
double errorAtEdges(const QImage& picture)
{
    const double ground = lightIn(kGround);
    const double plate = lightIn(picture.pixelColor(kWidth / 2, kHeight / 2));
    double sum = 0.0;
    int edges = 0;
    for (int row = 0; row < kHeight; ++row)
        for (int column = 0; column < kWidth; ++column) {
            const double covered = coverage(column, row);
            if (covered == 0.0 || covered == 1.0)
                continue;
            const double shown =
                (lightIn(picture.pixelColor(column, row)) - ground) / (plate - ground);
            sum += std::abs(shown - covered);
            ++edges;
        }
    return edges == 0 ? 1.0 : sum / edges;
}

double errorIn(PictureQuality quality)
{
    const auto view = plateView();
    view->setFixedQuality(quality);
    return draws(*view, kSwitchFrames) ? errorAtEdges(view->picture()) : 1.0;
}

} // namespace

class TestPictureEdges : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void areNearerToTheTruthInEachQuality();
    void aPlateHasTheSameColourInEachQuality();
    void everyFrameIsDrawnWhileTheQualityChanges();
    void smallerAndLargerWindowsAreFilled();
    void idsAreTheSameInEachQuality();
    void aSectionCutsInEachQuality();
    void aPictureThatRestsIsFine();
    void aPictureThatMovesAgainIsDrawn();
};

void TestPictureEdges::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

/// One sample per pixel is off by a fifth on average, and four samples by about a sixteenth.
void TestPictureEdges::areNearerToTheTruthInEachQuality()
{
    const double quick = errorIn(PictureQuality::Quick);
    const double smoothed = errorIn(PictureQuality::Smoothed);
    const double fine = errorIn(PictureQuality::Fine);
    const QString told = QStringLiteral("%1, %2, %3").arg(quick).arg(smoothed).arg(fine);
    QVERIFY2(quick > 0.17 && quick < 0.3, qPrintable(told));
    QVERIFY2(smoothed < 0.8 * quick, qPrintable(told));
    QVERIFY2(fine < 0.12, qPrintable(told));
}

void TestPictureEdges::aPlateHasTheSameColourInEachQuality()
{
    const auto view = plateView();
    QVERIFY(draws(*view, kSwitchFrames));
    const QColor plate = view->picture().pixelColor(kWidth / 2, kHeight / 2);
    for (const PictureQuality quality : {PictureQuality::Smoothed, PictureQuality::Fine}) {
        view->setFixedQuality(quality);
        QVERIFY(draws(*view, kSwitchFrames));
        const QImage picture = view->picture();
        const QColor drawn = picture.pixelColor(kWidth / 2, kHeight / 2);
        QVERIFY(std::abs(drawn.green() - plate.green()) <= 1);
        QVERIFY(std::abs(drawn.blue() - plate.blue()) <= 1);
        QCOMPARE(picture.pixelColor(2, 2), kGround);
        QCOMPARE(view->quality(), quality);
    }
}

/// No frame is black because a shader or a texture is not ready.
void TestPictureEdges::everyFrameIsDrawnWhileTheQualityChanges()
{
    const auto view = plateView();
    QVERIFY(draws(*view, kSwitchFrames));
    for (const PictureQuality quality : {PictureQuality::Smoothed, PictureQuality::Fine,
                                         PictureQuality::Quick, PictureQuality::Fine}) {
        view->setFixedQuality(quality);
        for (int frame = 0; frame < 3; ++frame) {
            QVERIFY(draws(*view, 1));
            const QImage shown = onScreen(*view);
            QVERIFY(shown.pixelColor(kWidth / 2, kHeight / 2).blue() > kGround.blue() + 20);
            QVERIFY(std::abs(shown.pixelColor(2, 2).blue() - kGround.blue()) <= 1);
        }
    }
}

void TestPictureEdges::smallerAndLargerWindowsAreFilled()
{
    const auto view = plateView();
    for (const PictureQuality quality : {PictureQuality::Smoothed, PictureQuality::Fine}) {
        view->setFixedQuality(quality);
        for (const QSize& size : {QSize{320, 240}, QSize{800, 600}}) {
            view->resize(size);
            QVERIFY(draws(*view, kSwitchFrames));
            const QImage picture = view->picture();
            QCOMPARE(picture.size(), size);
            QVERIFY(picture.pixelColor(size.width() / 2, size.height() / 2).blue()
                    > kGround.blue() + 20);
            QCOMPARE(picture.pixelColor(size.width() - 2, size.height() - 2), kGround);
        }
    }
}

void TestPictureEdges::idsAreTheSameInEachQuality()
{
    const auto view = plateView();
    QVERIFY(draws(*view, kSwitchFrames));
    const auto pixels = view->visiblePixels();
    const IdPicture ids = view->opaqueIds();
    for (const PictureQuality quality : {PictureQuality::Smoothed, PictureQuality::Fine}) {
        view->setFixedQuality(quality);
        QVERIFY(draws(*view, kSwitchFrames));
        QCOMPARE(view->visiblePixels(), pixels);
        QVERIFY(view->opaqueIds().ids == ids.ids);
    }
}

/// What lies beyond its plane is not there, and the window is drawn on both of its sides.
void TestPictureEdges::aSectionCutsInEachQuality()
{
    constexpr int kAside = 40; // pixels from the plane, on the plate
    const auto view = plateView();
    view->setSection(Section{Vec3::UnitX(), 0.0, Cut::All});
    for (const PictureQuality quality :
         {PictureQuality::Quick, PictureQuality::Smoothed, PictureQuality::Fine}) {
        view->setFixedQuality(quality);
        QVERIFY(draws(*view, kSwitchFrames));
        const QImage picture = view->picture();
        QVERIFY(picture.pixelColor(kWidth / 2 - kAside, kHeight / 2).blue() > kGround.blue() + 20);
        for (const int column : {2, kWidth / 2 + kAside, kWidth - 2})
            QCOMPARE(picture.pixelColor(column, kHeight / 2), kGround);
    }
}

void TestPictureEdges::aPictureThatRestsIsFine()
{
    const auto view = plateView();
    view->setFixedQuality(std::nullopt);
    QVERIFY(draws(*view, RestingPicture::kFramesBefore + 20));
    QCOMPARE(view->quality(), PictureQuality::Fine);
    const double error = errorAtEdges(onScreen(*view));
    QVERIFY2(error < 0.12, qPrintable(QString::number(error)));
}

void TestPictureEdges::aPictureThatMovesAgainIsDrawn()
{
    SceneFrame shown = tiltedFrame();
    const auto view = shownView({platePart(1, MaterialGroup::Bone, "plate")},
                                [&shown](int, LocalTime) { return shown; });
    view->setFixedQuality(std::nullopt);
    QVERIFY(draws(*view, RestingPicture::kFramesBefore + 20));
    QVERIFY(onScreen(*view).pixelColor(kWidth / 2, kHeight / 2).blue() > 100);
    shown.bodies.clear();
    QVERIFY(draws(*view, 2));
    QCOMPARE(onScreen(*view).pixelColor(kWidth / 2, kHeight / 2), QColor(Qt::black));
}

CARINA_SCREEN_TEST(TestPictureEdges)

} // namespace carina::picture_edges_test

#include "tst_picture_edges.moc"
