#include "engine/display/eye_picture.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

int nearestLine(double share, int pixels) { return static_cast<int>(std::lround(share * pixels)); }

/// Pixels that a length touches, and how far they reach beyond it at either end.
struct Touched {
    int first = 0;
    int count = 0;
    double before = 0.0;
    double after = 0.0;
};

/// A length in pixels in the middle of `available` pixels.
Touched touchedInMiddle(double length, int available)
{
    constexpr double kRounding = 1e-6; // pixels by which a sum of doubles may miss a line
    const double start = 0.5 * (available - length);
    const double end = start + length;
    const int first = std::clamp(static_cast<int>(std::floor(start + kRounding)), 0, available - 1);
    const int last = std::clamp(static_cast<int>(std::ceil(end - kRounding)), first + 1, available);
    return {first, last - first, start - first, last - end};
}

} // namespace

PixelRect pixelsOf(const WindowPart& part, int windowWidth, int windowHeight)
{
    CARINA_EXPECTS(windowWidth > 0 && windowHeight > 0);
    CARINA_EXPECTS(part.x >= 0.0 && part.y >= 0.0);
    CARINA_EXPECTS(part.x + part.width <= 1.0 && part.y + part.height <= 1.0);
    const int left = nearestLine(part.x, windowWidth);
    const int top = nearestLine(part.y, windowHeight);
    return {left, top, nearestLine(part.x + part.width, windowWidth) - left,
            nearestLine(part.y + part.height, windowHeight) - top};
}

PlacedPicture letterboxed(const Frustum& frustum, const PixelRect& area)
{
    CARINA_EXPECTS(area.width > 0 && area.height > 0);
    CARINA_EXPECTS(frustum.right > frustum.left && frustum.top > frustum.bottom);
    const double width = frustum.right - frustum.left;
    const double height = frustum.top - frustum.bottom;
    const double scale = std::min(area.width / width, area.height / height); // pixels
    const Touched columns = touchedInMiddle(scale * width, area.width);
    const Touched rows = touchedInMiddle(scale * height, area.height);
    return {{area.x + columns.first, area.y + rows.first, columns.count, rows.count},
            {.left = frustum.left - columns.before / scale,
             .right = frustum.right + columns.after / scale,
             .bottom = frustum.bottom - rows.after / scale,
             .top = frustum.top + rows.before / scale}};
}

} // namespace carina
