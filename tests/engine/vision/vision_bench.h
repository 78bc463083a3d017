#pragma once

#include "engine/vision/camera_model.h"
#include "engine/vision/printed_tools.h"

#include <algorithm>
#include <cmath>

namespace carina::vision_test
{

/// A webcam with a view of 60 degrees and some distortion.
inline CameraModel webcam()
{
    return {.width = 640,
            .height = 480,
            .focal = {560.0, 557.0},
            .centre = {322.0, 236.0},
            .distortion = {0.08, -0.2, 0.002, -0.003, 0.05}};
}

/// A pose whose +z looks back at the camera, tilted about an axis across the line of sight.
inline RigidTransform facing(const Vec3& p_T, double tilt_deg, double direction_deg = 0.0,
                             double turn_deg = 0.0)
{
    const double direction = degrees(direction_deg).si;
    const Quat q = Quat::FromTwoVectors(Vec3::UnitZ(), -p_T.normalized())
                   * Quat{Eigen::AngleAxisd{degrees(tilt_deg).si,
                                            Vec3{std::cos(direction), std::sin(direction), 0.0}}}
                   * Quat{Eigen::AngleAxisd{degrees(turn_deg).si, Vec3::UnitZ()}};
    return {q, p_T};
}

/// A printed tool by its name.
inline const PrintedTool& printed(const std::string& name)
{
    return *std::ranges::find(printedTools(), name, &PrintedTool::name);
}

} // namespace carina::vision_test
