#pragma once

#include <cstdint>

namespace carina
{

/// Why a device has no pose of a tool, or one that is to be taken with care.
enum class ToolSight : std::uint8_t {
    Unsaid,            ///< there is no reason, or the device tells none
    PartlyOutOfVolume, ///< some markers are outside the volume for which the accuracy is stated
    OutOfVolume,       ///< all are
    TooFewMarkers,     ///< seen, but too little of it for a pose
    Interference,      ///< other infrared light disturbs
    BadFit,            ///< the markers do not fit the tool's definition
    Failed,            ///< the device fell behind, or failed otherwise
    Silent,            ///< the device does not answer, or is not there
};

} // namespace carina
