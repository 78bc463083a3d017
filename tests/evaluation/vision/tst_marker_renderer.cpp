#include "evaluation/vision/marker_renderer.h"

#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::marker_renderer_test
{
namespace
{

constexpr double kFocal = 600.0;   ///< pixels
constexpr double kDistance = 0.6;  ///< metres, at which a millimetre is a pixel
constexpr double kSide = 0.030;    ///< of the square, metres
constexpr int kMargin = 10;        ///< pixels around the square that count
constexpr double kWithin = 0.03;   ///< pixels: four standard errors of samples drawn, and rounding
constexpr double kOfTheArea = 2.5; ///< pixels^2: the same, of four edges

CameraModel pinhole()
{
    return {.width = 120,
            .height = 100,
            .focal = {kFocal, kFocal},
            .centre = {60.0, 50.0},
            .distortion = {}};
}

/// A black square, its edges along rows and columns, in white paper: where its middle is in the
/// picture, pixels, and its area, pixels^2.
struct DarkSpot {
    Vec2 middle = Vec2::Zero();
    double area = 0.0;
};

/// @param at where the middle of the square is to be, pixels
DarkSpot rendered(const Vec2& at)
{
    MarkerRenderer renderer{pinhole(), MarkerDictionary::Bits4Of50, {.blur = 0.3, .noise = 0.0}};
    const CameraModel camera = pinhole();
    const Vec3 p_T{(at.x() - camera.centre.x()) * kDistance / kFocal,
                   -(at.y() - camera.centre.y()) * kDistance / kFocal, -kDistance};
    const GreyPicture picture =
        renderer.drawBoard({{false}, 1, kSide, RigidTransform::translation(p_T)});
    const int half = int(0.5e3 * kSide) + kMargin;
    const double white = picture.at(int(at.x()) - half, int(at.y()));
    const double black = picture.at(int(at.x()), int(at.y()));
    DarkSpot spot;
    for (int y = int(at.y()) - half; y <= int(at.y()) + half; ++y)
        for (int x = int(at.x()) - half; x <= int(at.x()) + half; ++x) {
            const double dark = (white - picture.at(x, y)) / (white - black);
            spot.area += dark;
            spot.middle += dark * Vec2{x, y};
        }
    spot.middle /= spot.area;
    return spot;
}

} // namespace

class TestMarkerRenderer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Wherever between the middles of pixels an edge along them is.
    void putsASquareWhereItIs()
    {
        for (int i = 0; i < 12; ++i) {
            const Vec2 at{60.0 + i / 12.0, 50.0 + (i * 5 % 12) / 12.0};
            const DarkSpot spot = rendered(at);
            const QString told = QStringLiteral("at %1, %2: off by %3, %4; area %5")
                                     .arg(at.x())
                                     .arg(at.y())
                                     .arg(spot.middle.x() - at.x())
                                     .arg(spot.middle.y() - at.y())
                                     .arg(spot.area);
            QVERIFY2((spot.middle - at).cwiseAbs().maxCoeff() < kWithin, qPrintable(told));
            QVERIFY2(std::abs(spot.area - 30.0 * 30.0) < kOfTheArea, qPrintable(told));
        }
    }
};

CARINA_TEST(TestMarkerRenderer)

} // namespace carina::marker_renderer_test

#include "tst_marker_renderer.moc"
