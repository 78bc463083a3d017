#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/tracking/pose_sample.h"
#include "engine/tracking/tool_sight.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace carina
{

/// What a tracker of NDI says of a tool at one exposure.
enum class NdiSight : std::uint8_t {
    Tracked,
    PartlyOutOfVolume, ///< some markers are outside the volume for which the accuracy is stated
    PartlyAveraged,    ///< some exposures of an average are missing
    OutOfVolume,       ///< all are; the pose is there where it was asked for
    TooFewMarkers,     ///< seen, but too little of it for a pose
    Interference,      ///< other infrared light disturbs
    BadFit,            ///< the markers do not fit the tool's definition
    Missing,           ///< not seen, or for a reason that the device does not tell
    Disabled,          ///< the tool is not enabled
    Unoccupied,        ///< no tool is in the port
    Failed,            ///< the device fell behind, failed otherwise, or states what is no pose
};

/// A tool O of a tracker T at one exposure.
struct NdiTool {
    std::uint16_t handle = 0;
    NdiSight sight = NdiSight::Missing;
    std::optional<RigidTransform> X_TO{};
    double error = 0.0;             ///< RMS of the fit, metres; of a pose
    std::uint32_t status = 0;       ///< of the port, or in BX2 of the tool, as received
    std::uint32_t frameNumber = 0;  ///< counts the exposures of the device
    std::vector<Vec3> p_TMarkers{}; ///< metres; where they were asked for
};

/// How a sample of the tool is to be taken; Lost without a pose.
[[nodiscard]] Validity validityOf(const NdiTool& tool);

/// The same for a person: why it has no pose, or one with care.
[[nodiscard]] ToolSight toolSightOf(const NdiTool& tool);

/// What one reply to TX, BX or BX2 tells.
struct NdiFrame {
    std::vector<NdiTool> tools{};
    std::vector<Vec3> p_TStrays{};        ///< markers of no tool, metres
    std::uint16_t status = 0;             ///< of the system, NdiSystemStatus; 0 in BX2
    std::optional<Duration> deviceTime{}; ///< of the exposure by the device's clock; BX2
    std::optional<Error> refusedPose{};   ///< why a tool Failed whose pose is none
};

/// Bits of the system's status in TX and BX that are understood.
enum NdiSystemStatus : std::uint16_t {
    kNdiInterference = 0x0002,   ///< too much external infrared light
    kNdiPortOccupied = 0x0040,   ///< a tool was plugged in
    kNdiPortUnoccupied = 0x0080, ///< a tool was unplugged
};

/// The options of TX and BX that are understood; they can be added up.
enum NdiOption : std::uint16_t {
    kNdiPoses = 0x0001,           ///< and status and frame number; without it no tools are listed
    kNdiMarkerStates = 0x0002,    ///< why a tool has no pose, by what was seen of its markers
    kNdiSingleStray = 0x0004,     ///< one marker that is near an active tool of one marker
    kNdiMarkerPositions = 0x0008, ///< of the tools' markers; of BX only
    kNdiOutOfVolumeToo = 0x0800,  ///< also poses out of the volume
    kNdiStrays = 0x1000,          ///< positions of passive strays
};

/// Decodes the text of a reply to TX with these options.
///
/// A quaternion has four digits after the point: it is brought to unit length. A pose that is none,
/// because its quaternion is no rotation (NotARotation) or its position is beyond 100 m
/// (OutOfRange), is left out, and the tool counts as failed: the others of the reply are right.
///
/// @returns DeviceReplyDamaged; the detail names the rule that it breaks. WrongOption for other
///          options.
[[nodiscard]] Result<NdiFrame> decodeTx(std::string_view text, std::uint16_t options);

/// Decodes the body of a reply to BX with these options. A pose with a number that is not finite
/// (NotFinite) is none, too.
/// @returns as decodeTx
[[nodiscard]] Result<NdiFrame> decodeBx(std::span<const std::byte> body, std::uint16_t options);

/// Decodes the body of a reply to BX2, in NDI's general binary format: frames with poses of tools
/// and positions of markers and strays; other components are skipped. Of several frames the last;
/// none is in a frame.
/// @returns DeviceReplyDamaged
[[nodiscard]] Result<NdiFrame> decodeBx2(std::span<const std::byte> body);

} // namespace carina
