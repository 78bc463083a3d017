#pragma once

#include "engine/core/result.h"
#include "engine/vision/camera_model.h"

#include <filesystem>
#include <string>

namespace carina
{

/// A camera as it was calibrated.
struct CalibratedCamera {
    CameraModel model;
    double rms = 0.0;     ///< of the reprojection, pixels; 0 where it is not known
    int pictures = 0;     ///< of the board; 0 where it is not known
    std::string madeAt{}; ///< ISO 8601; empty where it is not known
};

/// Reads the calibration of a camera: a JSON object with
///
///     schema       "carina.camera/1"
///     width, height   of its pictures, pixels
///     focal_px     [fx, fy]
///     centre_px    [cx, cy], where (0, 0) is the centre of the upper left pixel
///     distortion   [k1, k2, p1, p2, k3]; see CameraModel
///     rms_px, pictures, made_at   of the calibration; may be left out
///
/// or, where its name ends in .yml or .yaml (isOpenCvCamera), a file of OpenCV (cameraFromYaml).
///
/// @returns the errors of readJsonFile; FileMalformed for a fault, and for a camera that is not
///          usable. The detail names file and field.
[[nodiscard]] Result<CalibratedCamera> readCameraFile(const std::filesystem::path& file);

/// Whether a file is one of OpenCV, by its name.
[[nodiscard]] bool isOpenCvCamera(const std::filesystem::path& file);

/// @returns FileUnwritable, also for the name of a file of OpenCV: it would not be read again.
[[nodiscard]] Result<void> writeCameraFile(const std::filesystem::path& file,
                                           const CalibratedCamera& camera);

} // namespace carina
