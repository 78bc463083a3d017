#include "engine/tracking/markers/tool_error.h"

namespace carina
{

std::optional<PoseError> predictedError(const TrackedTool& tool, const RigidTransform& X_TO)
{
    if (!tool.probe) {
        const auto newest = tool.history ? tool.history->newest() : std::nullopt;
        return newest && newest->covariance_O
                   ? std::optional{PoseError{.covariance_F = *newest->covariance_O}}
                   : std::nullopt;
    }
    // Of the device that sees it.
    const auto X_TD = tool.history != nullptr ? tool.history->deviceFrame() : std::nullopt;
    const Vec3 p_TD = X_TD.value_or(RigidTransform{}).translation();
    const Vec3 d_O = X_TO.rotation().conjugate() * (p_TD - X_TO.translation()).stableNormalized();
    const Result<PoseError> error = poseError(*tool.probe, d_O, tool.noise);
    return error ? std::optional{*error} : std::nullopt;
}

} // namespace carina
