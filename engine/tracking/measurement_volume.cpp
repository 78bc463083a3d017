#include "engine/tracking/measurement_volume.h"

#include "engine/tracking/working_volume.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

// Half widths in metres. The corners of Spectra and Vega are those of NDI's volume description.
constexpr std::array<VolumeSection, 4> kPolaris{
    {{0.950, 0.224, 0.240}, {1.532, 0.396, 0.572}, {2.400, 0.656, 0.783}, {3.000, 0.735, 0.928}}};

/// The distance of a point to a face that widens from one half width to another, along its normal.
double toFace(double from, double to, double height, double share, double aside)
{
    const double slope = (to - from) / height;
    return (from + share * (to - from) - aside) / std::hypot(1.0, slope);
}

} // namespace

double MeasurementVolume::insideBy(const Vec3& p_T) const
{
    const double depth = -p_T.z();
    const double ends = std::min(depth - sections.front().depth, sections.back().depth - depth);
    const auto isBehind = [&](const VolumeSection& section) { return section.depth >= depth; };
    const auto found = std::ranges::find_if(sections.begin() + 1, sections.end() - 1, isBehind);
    const VolumeSection& far = *found;
    const VolumeSection& near = *(found - 1);
    const double height = far.depth - near.depth;
    const double share = std::clamp((depth - near.depth) / height, 0.0, 1.0);
    if (isRound)
        return std::min(ends,
                        toFace(near.halfX, far.halfX, height, share, std::hypot(p_T.x(), p_T.y())));
    return std::min({ends, toFace(near.halfX, far.halfX, height, share, std::abs(p_T.x())),
                     toFace(near.halfY, far.halfY, height, share, std::abs(p_T.y()))});
}

MeasurementVolume polarisPyramid() { return {std::span{kPolaris}.first(3), false}; }

MeasurementVolume polarisExtendedPyramid() { return {kPolaris, false}; }

MeasurementVolume simulatedCone()
{
    static const WorkingVolume cone;
    static const std::array<VolumeSection, 2> sections{
        {{0.0, 0.0, 0.0}, {cone.height.si, cone.baseRadius.si, cone.baseRadius.si}}};
    return {sections, true};
}

} // namespace carina
