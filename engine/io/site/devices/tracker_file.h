#pragma once

#include "engine/core/result.h"
#include "engine/io/site/devices/marker_file.h"
#include "engine/tracking/igtl/igtl_client.h"
#include "engine/tracking/ndi/ndi_client.h"
#include "engine/tracking/tracker.h"
#include "engine/vision/camera_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace carina
{

/// A tool of a tracker, and what it is for.
struct DescribedTool {
    std::string name;
    ToolRole role = ToolRole::Other;
    std::optional<NdiToolDefinition> definition{}; ///< nothing for one that is plugged in
    std::string device{}; ///< by which a server of OpenIGTLink knows it; empty: its name
    std::optional<MarkedBody> body{}; ///< of a camera: what it wears
};

/// How the poses of a tracker come.
enum class TrackerKind : std::uint8_t {
    Ndi,         ///< from a device of NDI
    OpenIgtLink, ///< from a server of OpenIGTLink, such as PLUS
    Camera,      ///< from markers in the pictures of a camera or video
};

/// A tracker of a site, as its technician describes it.
struct TrackerDescription {
    /// "/dev/ttyUSB0", or host and port: "192.0.2.7:8765"; of a camera "/dev/video0", or the whole
    /// path of a video or a folder of pictures
    std::string address;
    NdiPoseReply poses = NdiPoseReply::Bx;
    int fastestRate = 921600; ///< that the serial port holds, bits a second
    std::vector<DescribedTool> tools{};
    TrackerKind kind = TrackerKind::Ndi;
    // Of OpenIGTLink only:
    IgtlPoses igtlPoses = IgtlPoses::Transform;
    int rate_hz = 60; ///< of TDATA and QTDATA; of a folder of pictures, or asked of a webcam
    // Of a camera only:
    CameraModel camera{};
    std::string calibration{}; ///< the file that camera is from; empty where it is from none
    bool isLooped = false;     ///< a video is played again and again
};

/// Reads the description of a tracker, a JSON object with
///
///     schema        "carina.tracker/1"
///     kind          "ndi": a Polaris of any generation; or "openigtlink", see below
///     address       a serial port, or host:port
///     poses         "TX", "BX" or "BX2"; BX without it
///     fastest_rate  of the serial port, bits a second; 921600 without it
///     tools         a list of name; role ("head", "jaw", "tube", "stylus", "manikin", "chest",
///                   "hand", "laryngoscope" or "other"), none but "other" twice; and of a wireless
///                   tool definition, its .rom file, beside this one or below. Wired tools are
///                   those of the ports in ascending order
///
/// or, of kind "openigtlink", with
///
///     address       host:port of the server
///     poses         "TRANSFORM": the server sends by itself, as it is without this; "TDATA" or
///                   "QTDATA": it is asked for them
///     rate          that TDATA or QTDATA are asked for at, a second; 60 without it
///     tools         name and role as above, and device, by which the server knows the tool;
///                   without it by its name
///
/// or, of kind "camera", with
///
///     address       of a webcam, such as "/dev/video0"; or a video, or a folder of pictures,
///                   beside this file or below
///     calibration   of the camera (readCameraFile), a file beside this one or below
///     looped        true: a video is played again and again; false without it
///     rate          of a folder, and asked of a webcam, pictures a second; 30 without it
///     tools         name and role as above, and definition: the file of its markers
///                   (readMarkerFile), beside this one or below. No marker is on two tools, and all
///                   are of one dictionary
///
/// @returns the errors of readJsonFile; FileMalformed for a fault; those of reading a definition.
///          The detail names file and field.
[[nodiscard]] Result<TrackerDescription> readTrackerFile(const std::filesystem::path& file);

/// Writes a description, and beside it the definition of its first wireless tool as FILE-1.rom, of
/// the second as FILE-2.rom and so on, where FILE is the name of the file without its extension. Of
/// a camera it writes the calibration as FILE-camera.json, unless that is the file that it is from,
/// and the markers of the first tool as FILE-1.json and so on; the address of a video or folder is
/// that relative to the file.
/// @returns FileUnwritable
[[nodiscard]] Result<void> writeTrackerFile(const std::filesystem::path& file,
                                            const TrackerDescription& description);

/// Has the description of a camera name another calibration, a file beside it or below; the rest of
/// it stays as it is.
/// @returns the errors of readJsonFile; FileUnwritable
[[nodiscard]] Result<void> nameCalibration(const std::filesystem::path& file,
                                           const std::filesystem::path& calibration);

/// Reads the definition of a wireless tool, a .rom file.
/// @returns the errors of reading a file and of NdiToolDefinition::read; the detail begins with the
///          file.
[[nodiscard]] Result<NdiToolDefinition> readToolDefinition(const std::filesystem::path& file);

} // namespace carina
