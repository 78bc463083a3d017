#pragma once

#include "tests/widgets/scene/scene_shapes.h"
#include "widgets/scene/scene_view.h"

#include <QTest>

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

/// A frame seen from in front, at kDistance, looking along +y with the head up.
inline SceneFrame frontFrame()
{
    SceneFrame frame;
    const double half = std::sqrt(0.5); // a quarter turn about x takes -z to +y and y to z
    frame.X_AD = RigidTransform(Quat(half, half, 0.0, 0.0), Vec3(0.0, -kDistance, 0.0));
    return frame;
}

/// A view that shows parts as a frame says, in a window of known size.
inline std::unique_ptr<SceneView> shownView(const std::vector<ScenePart>& parts,
                                            SceneView::FrameSource source)
{
    auto view = std::make_unique<SceneView>();
    view->setParts(parts);
    view->setFrameSource(std::move(source));
    view->setEyeFollowed(true);
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

} // namespace carina::test
