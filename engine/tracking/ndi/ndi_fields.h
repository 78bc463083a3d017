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

/// Puts a stated pose into a tool of a frame. Where it is none the tool Failed, and the frame says
/// why: NotFinite; NotARotation where the quaternion's length is not 1 +- 0.01; OutOfRange beyond
/// 100 m.
void placeTool(NdiTool& tool, const StatedPose& pose, NdiFrame& frame);

/// Judges a tool in TX and BX by the status of its port and whether it has a pose.
void judge(NdiTool& tool);

/// Why a tool is missing, by what option 0002 tells: the bits of the tool, and whether anything is
/// told of its markers. Of a tool that is hidden all markers are missing, too.
void judgeMissing(NdiTool& tool, std::uint32_t bits, bool seesMarkers);

/// The same by the status of the system, which is of all tools.
void judgeMissing(NdiFrame& frame);

} // namespace carina::ndi
