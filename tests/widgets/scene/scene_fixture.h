#pragma once

#include "tests/widgets/scene/scene_shapes.h"
#include "widgets/scene/view/scene_view.h"

#include <QScreen>
#include <QTest>

#include <optional>
#include <string>

namespace carina::test
{

inline constexpr int kWidth = 640;       ///< pixels
inline constexpr int kHeight = 480;      ///< pixels
inline constexpr double kDistance = 2.0; ///< metres from the eye to the origin of A

/// A sphere that is fixed to a body, or fixed in A where the body is "".
inline ScenePart spherePart(std::uint16_t id, MaterialGroup group, const Vec3& centre,
                            double radius, const char* body = "")
{
    ScenePart part;
    part.id = id;
    part.group = group;
    part.color = QColor(220, 20, 20);
    part.body = body;
    part.levels = {sphere(centre, radius)};
    return part;
}

/// An eye at x in front, at kDistance, looking along +y with the head up, through the frustum of
/// the desktop's camera.
inline EyePicture frontEye(double x = 0.0)
{
    const double half = std::sqrt(0.5); // a quarter turn about x takes -z to +y and y to z
    const double up = std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    const double right = up * kWidth / kHeight;
    return {RigidTransform(Quat(half, half, 0.0, 0.0), Vec3(x, -kDistance, 0.0)),
            {-right, right, -up, up},
            {}};
}

/// A frame seen by that eye.
inline SceneFrame frontFrame()
{
    SceneFrame frame;
    frame.eyes = {frontEye()};
    return frame;
}

/// A view that shows parts as a frame says, in a window of known size, each frame drawn anew and
/// with edges as they come.
inline std::unique_ptr<SceneView> shownView(const std::vector<ScenePart>& parts,
                                            SceneView::FrameSource source)
{
    auto view = std::make_unique<SceneView>();
    view->setParts(parts);
    view->setFixedQuality(PictureQuality::Quick);
    view->setFrameSource(std::move(source));
    view->setBackground(Qt::black);
    view->resize(kWidth, kHeight);
    view->show();
    return view;
}

/// Lets the view draw this many further frames.
inline bool draws(SceneView& view, std::size_t frames)
{
    constexpr int kPatience = 30'000; // milliseconds; a loaded software renderer
    const std::size_t target = view.statistics().frames + frames;
    return QTest::qWaitFor([&] { return view.statistics().frames >= target; }, kPatience);
}

/// Pixels that a sphere covers whose centre is on the line of sight: it is seen under the half
/// angle asin(r / distance), so as a disc of the focal length times its tangent.
inline double discPixels(double radius, double distance)
{
    const double focal = 0.5 * kHeight / std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    const double squared = radius * radius / (distance * distance - radius * radius);
    return std::numbers::pi * focal * focal * squared;
}

inline bool isRed(QRgb pixel) { return qRed(pixel) > 60 && qRed(pixel) > 2 * qBlue(pixel); }

/// Mean column and row of the red pixels, as a share of the picture; nothing without any.
inline std::optional<QPointF> redCentre(const QImage& picture)
{
    double x = 0.0;
    double y = 0.0;
    double count = 0.0;
    for (int row = 0; row < picture.height(); ++row)
        for (int column = 0; column < picture.width(); ++column)
            if (isRed(picture.pixel(column, row))) {
                x += column + 0.5;
                y += row + 0.5;
                count += 1.0;
            }
    if (count == 0.0)
        return std::nullopt;
    return QPointF(x / count / picture.width(), y / count / picture.height());
}

/// What the X server shows where the view is: what came out of the swap, not what is drawn next.
inline QImage onScreen(SceneView& view)
{
    const QPoint corner = view.mapToGlobal(QPoint(0, 0));
    return view.screen()
        ->grabWindow(0, corner.x(), corner.y(), view.width(), view.height())
        .toImage();
}

} // namespace carina::test
