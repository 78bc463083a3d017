#include "engine/display/eye_picture.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

int nearestLine(double share, int pixels) { return static_cast<int>(std::lround(share * pixels)); }

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

PixelRect letterboxed(const Frustum& frustum, const PixelRect& area)
{
    CARINA_EXPECTS(area.width > 0 && area.height > 0);
    CARINA_EXPECTS(frustum.right > frustum.left && frustum.top > frustum.bottom);
    const double aspect = (frustum.right - frustum.left) / (frustum.top - frustum.bottom);
    const double width = std::min<double>(area.width, area.height * aspect);
    const double height = std::min<double>(area.height, area.width / aspect);
    const int columns = std::max(1, static_cast<int>(std::lround(width)));
    const int rows = std::max(1, static_cast<int>(std::lround(height)));
    return {area.x + (area.width - columns) / 2, area.y + (area.height - rows) / 2, columns, rows};
}

} // namespace carina
