#pragma once

#include "engine/core/units.h"
#include "engine/tracking/pose_history.h"

#include <optional>
#include <string>

namespace carina
{

/// The frame D of a device in that of the site's first device, T, from a body that both saw.
struct SiteDeviceFrame {
    DevicePlace place{};        ///< X_TD
    double rms = 0.0;           ///< of the places of the body, metres
    Angle turn{};               ///< of its rotations, RMS
    int pairs = 0;              ///< moments at which both saw it
    std::string calibratedAt{}; ///< ISO 8601
};

/// A device that tracks at a site.
struct SiteDevice {
    std::string file;                       ///< that describes it, beside the site's or below
    std::optional<SiteDeviceFrame> frame{}; ///< nothing of the first, whose frame is T
};

} // namespace carina
