#include "engine/tracking/ndi/ndi_frame.h"

#include "engine/core/units.h"
#include "engine/tracking/ndi/ndi_fields.h"

#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kUnitLength = 0.01; // four digits of a quaternion leave 2e-4
constexpr double kFarthest_mm = 1e5; // no volume of theirs reaches 100 m
constexpr std::uint32_t kOutOfVolume = 0x40;
constexpr std::uint32_t kPartlyOut = 0x80;
// Of a tool, by option 0002.
constexpr std::uint32_t kBadFit = 0x01;
constexpr std::uint32_t kTooFewMarkers = 0x02;

Result<RigidTransform> poseIn(const ndi::StatedPose& pose)
{
    const std::array numbers{pose.q0,   pose.qx,   pose.qy,   pose.qz,
                             pose.x_mm, pose.y_mm, pose.z_mm, pose.error_mm};
    for (const double number : numbers)
        if (!std::isfinite(number))
            return fail(Errc::NotFinite, "a number of a pose");
    const Quat q_TO{pose.q0, pose.qx, pose.qy, pose.qz};
    if (std::abs(q_TO.norm() - 1.0) > kUnitLength)
        return fail(Errc::NotARotation, "the quaternion of a pose");
    const Vec3 p_mm{pose.x_mm, pose.y_mm, pose.z_mm};
    if (p_mm.cwiseAbs().maxCoeff() > kFarthest_mm)
        return fail(Errc::OutOfRange, "the position of a pose");
    return RigidTransform{q_TO, p_mm.unaryExpr([](double mm) { return millimetres(mm).si; })};
}

} // namespace

Validity validityOf(const NdiTool& tool)
{
    if (!tool.X_TO)
        return Validity::Lost;
    switch (tool.sight) {
    case NdiSight::Tracked:
        return Validity::Tracked;
    case NdiSight::PartlyOutOfVolume:
    case NdiSight::PartlyAveraged:
    case NdiSight::OutOfVolume:
        return Validity::PartlyOccluded;
    case NdiSight::TooFewMarkers:
    case NdiSight::Interference:
    case NdiSight::BadFit:
    case NdiSight::Missing:
    case NdiSight::Disabled:
    case NdiSight::Unoccupied:
    case NdiSight::Failed:
        break;
    }
    return Validity::Lost;
}

ToolSight toolSightOf(const NdiTool& tool)
{
    switch (tool.sight) {
    case NdiSight::PartlyOutOfVolume:
        return ToolSight::PartlyOutOfVolume;
    case NdiSight::OutOfVolume:
        return ToolSight::OutOfVolume;
    case NdiSight::TooFewMarkers:
        return ToolSight::TooFewMarkers;
    case NdiSight::Interference:
        return ToolSight::Interference;
    case NdiSight::BadFit:
        return ToolSight::BadFit;
    case NdiSight::Failed:
        return ToolSight::Failed;
    case NdiSight::Tracked:
    case NdiSight::PartlyAveraged:
    case NdiSight::Missing:
    case NdiSight::Disabled:
    case NdiSight::Unoccupied:
        break;
    }
    return ToolSight::Unsaid;
}

namespace ndi
{

StatedPose poseFrom(ByteReader& bytes)
{
    StatedPose pose;
    for (double* each : {&pose.q0, &pose.qx, &pose.qy, &pose.qz, &pose.x_mm, &pose.y_mm, &pose.z_mm,
                         &pose.error_mm})
        *each = bytes.realFloat();
    return pose;
}

Vec3 positionFrom(ByteReader& bytes)
{
    Vec3 p_TQ;
    for (double& each : p_TQ)
        each = millimetres(bytes.realFloat()).si;
    return p_TQ;
}

void placeTool(NdiTool& tool, const StatedPose& pose, NdiFrame& frame)
{
    const auto X_TO = poseIn(pose);
    if (!X_TO) {
        tool.sight = NdiSight::Failed;
        frame.refusedPose = X_TO.error();
        return;
    }
    tool.X_TO = *X_TO;
    tool.error = millimetres(pose.error_mm).si;
}

void judge(NdiTool& tool)
{
    if (tool.sight == NdiSight::Failed)
        return;
    if ((tool.status & kOutOfVolume) != 0)
        tool.sight = NdiSight::OutOfVolume;
    else if (!tool.X_TO)
        tool.sight = NdiSight::Missing;
    else
        tool.sight =
            (tool.status & kPartlyOut) != 0 ? NdiSight::PartlyOutOfVolume : NdiSight::Tracked;
}

void judgeMissing(NdiTool& tool, std::uint32_t bits, bool seesMarkers)
{
    if (tool.sight != NdiSight::Missing)
        return;
    if ((bits & kBadFit) != 0)
        tool.sight = NdiSight::BadFit;
    else if ((bits & kTooFewMarkers) != 0 && seesMarkers)
        tool.sight = NdiSight::TooFewMarkers;
}

void judgeMissing(NdiFrame& frame)
{
    if ((frame.status & kNdiInterference) == 0)
        return;
    for (NdiTool& tool : frame.tools)
        if (tool.sight == NdiSight::Missing)
            tool.sight = NdiSight::Interference;
}

} // namespace ndi
} // namespace carina
