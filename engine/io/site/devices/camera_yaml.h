#pragma once

#include "engine/core/result.h"
#include "engine/vision/camera_model.h"

#include <string_view>

namespace carina
{

/// The camera in a YAML file as the calibration programs of OpenCV write it, with image_width,
/// image_height, camera_matrix and distortion_coefficients, whose first five numbers are k1, k2,
/// p1, p2 and k3; of no more than these four keys anything is read.
/// @returns FileMalformed where one is missing, a matrix has another size, or it has more than five
///          coefficients that are not zero; the detail names the key.
[[nodiscard]] Result<CameraModel> cameraFromYaml(std::string_view text);

} // namespace carina
