#include "engine/tracking/markers/tool_error.h"

#include <algorithm>

namespace carina
{
namespace
{

/// Of the device that sees it.
Vec3 directionToDevice(const TrackedTool& tool, const RigidTransform& X_TO)
{
    const auto X_TD = tool.history != nullptr ? tool.history->deviceFrame() : std::nullopt;
    const Vec3 p_TD = X_TD.value_or(RigidTransform{}).translation();
    return X_TO.rotation().conjugate() * (p_TD - X_TO.translation()).stableNormalized();
}

std::vector<std::size_t> indicesOf(const MarkerSet& markers, std::size_t count)
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < std::min(count, markers.size()); ++i)
        if (markers.test(i))
            indices.push_back(i);
    return indices;
}

} // namespace

std::optional<PoseError> predictedError(const TrackedTool& tool, const PoseSample& X_TO)
{
    if (X_TO.validity == Validity::Lost)
        return std::nullopt;
    if (!tool.probe)
        return X_TO.covariance_O ? std::optional{PoseError{.covariance_F = *X_TO.covariance_O}}
                                 : std::nullopt;
    if (!X_TO.markers && X_TO.validity == Validity::PartlyOccluded)
        return std::nullopt;
    const Probe& probe = *tool.probe;
    const Vec3 d_O = directionToDevice(tool, X_TO.X_FO);
    const Result<PoseError> error =
        X_TO.markers
            ? poseError(probe, indicesOf(*X_TO.markers, probe.markers.size()), d_O, tool.noise)
            : poseError(probe, d_O, tool.noise);
    return error ? std::optional{*error} : std::nullopt;
}

} // namespace carina
