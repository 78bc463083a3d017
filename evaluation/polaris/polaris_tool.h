#pragma once

#include "engine/core/result.h"
#include "engine/geometry/vec.h"

#include <string>
#include <vector>

namespace carina
{

/// What a Polaris has to know of a tool: the content of a .rom file. A host uploads it for a
/// wireless tool; in a wired one it is stored.
struct PolarisTool {
    struct Marker {
        Vec3 p_mm = Vec3::Zero();   ///< in the frame of the tool
        Vec3 normal = Vec3::Zero(); ///< where it faces; zero where it is seen from everywhere
    };

    std::string information{}; ///< type, maker, revision and serial number, as PHINF tells them
    std::string partNumber{};
    std::vector<Marker> markers{};
    unsigned fewestMarkers = 3;     ///< that a pose needs
    double largestError_mm = 2.0;   ///< of a marker that a pose is computed from
    double largestAngle_deg = 90.0; ///< between a marker's normal and the device
};

/// Reads the bytes of a .rom file by the table of NDI's tool files.
/// @returns FileMalformed for another length, beginning or checksum, for no marker or more than
///          twenty, for a pose that needs more markers than there are, and for a marker that is not
///          within 2 m of the tool's origin; the detail says which.
[[nodiscard]] Result<PolarisTool> polarisTool(const std::string& bytes);

/// Whether a device cannot tell the tools apart: the same markers at the same places.
[[nodiscard]] bool haveSameMarkers(const PolarisTool& one, const PolarisTool& other);

} // namespace carina
