#include "engine/session/simulated_tools.h"

#include "engine/geometry/rotation.h"

namespace carina
{
namespace
{

constexpr double kTubeBend = 1.0 / 0.14; ///< 1/m

Length lengthOf(const std::vector<Vec3>& points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i] - points[i - 1]).norm();
    return metres(length);
}

} // namespace

SimulatedTools simulatedTools(const TubeShape& tube)
{
    return {.X_NE = {rotationFromVector({0.25, -0.15, 0.4}), {0.01, -0.055, -0.02}},
            .tube = {.length = lengthOf(tube.p_E_centre),
                     .bends = {kTubeBend, kTubeBend},
                     .outerDiameter = tube.outerDiameter},
            .X_NL = {rotationFromVector({-0.2, 0.1, 0.3}), {0.005, -0.17, -0.01}},
            .blade = {.heelWidth = millimetres(16.0),
                      .handle = millimetres(155.0),
                      .p_L_tip = {0.0, 0.012, -0.13},
                      .p_L_half = {0.0, -0.013, -0.065}}};
}

} // namespace carina
