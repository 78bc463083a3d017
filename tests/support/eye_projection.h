#pragma once

#include "engine/geometry/rigid_transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace carina::test
{

/// An eye and the screen in front of it, in the head frame H, metres: the screen is a rectangle
/// around its centre, parallel to the x and y axes of H.
struct EyeBeforeScreen {
    Vec3 p_H_eye = Vec3::Zero();
    Vec3 p_H_centre = Vec3::Zero();
    double width = 0.0;
    double height = 0.0;
};

/// A rectangle of pixels: left and top edge and size, not rounded. y runs downwards.
struct PixelArea {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;
};

/// The largest centred area with the screen's aspect ratio within another area.
inline PixelArea screenWithin(const EyeBeforeScreen& eye, const PixelArea& area)
{
    const double pixelsPerMetre = std::min(area.width / eye.width, area.height / eye.height);
    const double width = eye.width * pixelsPerMetre;
    const double height = eye.height * pixelsPerMetre;
    return {area.left + 0.5 * (area.width - width), area.top + 0.5 * (area.height - height), width,
            height};
}

/// The image of a small ball.
struct SeenBall {
    double x = 0.0;     ///< of its centre, pixels from the left edge of the window
    double y = 0.0;     ///< pixels from the top edge
    double reach = 0.0; ///< pixels from there to the furthest point of its outline
};

/// The point where the line from the eye to a ball's centre Q meets the screen, in pixels of the
/// area that shows the whole screen. std::nullopt for a ball that is not completely in front of the
/// eye.
///
/// The reach is for the outline's point furthest from the axis: (tan(a + b) - tan(a)) times the
/// distance of the screen, where a is the angle of the ball's centre from the axis and b the
/// angular radius of the ball.
inline std::optional<SeenBall> seenBall(const EyeBeforeScreen& eye, const PixelArea& area,
                                        const Vec3& p_HQ, double radius)
{
    const Vec3 line = p_HQ - eye.p_H_eye;
    const double ahead = eye.p_H_eye.z() - eye.p_H_centre.z();
    const double depth = -line.z();
    if (depth <= 0.0)
        return std::nullopt;
    const Vec3 hit = eye.p_H_eye + (ahead / depth) * line;
    const double fromLeft = hit.x() - (eye.p_H_centre.x() - 0.5 * eye.width);
    const double fromTop = (eye.p_H_centre.y() + 0.5 * eye.height) - hit.y();
    const double toAxis = std::atan2(std::hypot(line.x(), line.y()), depth);
    const double half = std::asin(std::min(1.0, radius / line.norm()));
    if (toAxis + half >= 0.5 * std::numbers::pi)
        return std::nullopt;
    const double pixelsPerMetre = area.width / eye.width;
    return SeenBall{area.left + pixelsPerMetre * fromLeft, area.top + pixelsPerMetre * fromTop,
                    pixelsPerMetre * ahead * (std::tan(toAxis + half) - std::tan(toAxis))};
}

} // namespace carina::test
