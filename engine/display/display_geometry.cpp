#include "engine/display/display_geometry.h"

#include <cmath>
#include <numbers>

namespace carina
{

DisplayGeometry defaultDisplay()
{
    constexpr double kEyeDistance = 0.063;                            // metres
    constexpr double kScreenDistance = 1.0;                           // metres
    constexpr double kHalfDiagonal = 26.0 * std::numbers::pi / 180.0; // radians
    const double diagonal = 2.0 * kScreenDistance * std::tan(kHalfDiagonal);
    return {.p_HDl = {-0.5 * kEyeDistance, 0.0, 0.0},
            .p_HDr = {0.5 * kEyeDistance, 0.0, 0.0},
            .p_HQ_screenCentre = {0.0, 0.0, -kScreenDistance},
            .screenWidth = 0.8 * diagonal, // 4:3:5
            .screenHeight = 0.6 * diagonal};
}

} // namespace carina
