#pragma once

#include "engine/core/byte_buffer.h"
#include "engine/tracking/ndi/ndi_frame.h"

/// What the decoders of TX, BX and BX2 share.
namespace carina::ndi
{

/// A pose as the device states it: the quaternion q0 qx qy qz of T to O, millimetres.
struct StatedPose {
    double q0 = 1.0;
    double qx = 0.0;
    double qy = 0.0;
    double qz = 0.0;
    double x_mm = 0.0;
    double y_mm = 0.0;
    double z_mm = 0.0;
    double error_mm = 0.0;
};

/// The next pose, and the next position p_TQ in metres, of a binary reply.
[[nodiscard]] StatedPose poseFrom(ByteReader& bytes);
[[nodiscard]] Vec3 positionFrom(ByteReader& bytes);

/// Puts a stated pose into a tool. @returns NotFinite; NotARotation where the quaternion's length
/// is not 1 +- 0.01; OutOfRange beyond 100 m.
[[nodiscard]] Result<void> placeTool(NdiTool& tool, const StatedPose& pose);

/// The sight of a tool whose port has this status in TX and BX.
[[nodiscard]] NdiSight sightOfPort(std::uint32_t status, bool hasPose);

} // namespace carina::ndi
