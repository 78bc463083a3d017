#include "engine/display/eye_view.h"

#include <cmath>

namespace carina
{
namespace
{

constexpr double kNearestScreen = 1e-3; // metres before the eye

Vec3 placeOf(const DisplayGeometry& display, Eye eye)
{
    switch (eye) {
    case Eye::Left:
        return display.p_HDl;
    case Eye::Right:
        return display.p_HDr;
    case Eye::Middle:
        break;
    }
    return 0.5 * (display.p_HDl + display.p_HDr);
}

bool isFinite(const DisplayGeometry& display)
{
    return display.p_HDl.allFinite() && display.p_HDr.allFinite()
           && display.p_HQ_screenCentre.allFinite() && std::isfinite(display.screenWidth)
           && std::isfinite(display.screenHeight);
}

/// In numbers that can be drawn with.
bool hasSize(const Frustum& frustum)
{
    return std::isfinite(frustum.right - frustum.left) && frustum.right > frustum.left
           && std::isfinite(frustum.top - frustum.bottom) && frustum.top > frustum.bottom;
}

} // namespace

Result<EyeView> eyeView(const DisplayGeometry& display, Eye eye)
{
    if (!isFinite(display))
        return fail(Errc::NotFinite, "the display's eyes or screen");
    if (display.screenWidth <= 0.0 || display.screenHeight <= 0.0)
        return fail(Errc::OutOfRange, "the display's screen has no width or no height");
    const Vec3 p_HD = placeOf(display, eye);
    const Vec3 p_D_centre = display.p_HQ_screenCentre - p_HD;
    const double distance = -p_D_centre.z();
    if (distance < kNearestScreen)
        return fail(Errc::OutOfRange, "the display's screen is not before the eyes");
    const Frustum frustum{.left = (p_D_centre.x() - 0.5 * display.screenWidth) / distance,
                          .right = (p_D_centre.x() + 0.5 * display.screenWidth) / distance,
                          .bottom = (p_D_centre.y() - 0.5 * display.screenHeight) / distance,
                          .top = (p_D_centre.y() + 0.5 * display.screenHeight) / distance};
    if (!hasSize(frustum))
        return fail(Errc::OutOfRange, "the display's screen is too far, too large or too small");
    return EyeView{RigidTransform::translation(p_HD), frustum};
}

} // namespace carina
