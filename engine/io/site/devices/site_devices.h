#pragma once

#include "engine/io/site/devices/tracker_file.h"
#include "engine/io/site/site_device.h"

namespace carina
{

/// A device of several, as its file describes it, and how it stands to the first.
struct PlacedDescription {
    TrackerDescription described;
    DevicePlace place{}; ///< X_TD
};

/// The devices of a site, from the files that describe them.
/// @param folder of the site file
/// @returns the errors of pathWithin and of readAnyDescription; FileMalformed where two devices
///          have a tool of one role or name: nothing would tell which of the two counts.
[[nodiscard]] Result<std::vector<PlacedDescription>>
readSiteDevices(const std::filesystem::path& folder, const std::vector<SiteDevice>& devices);

} // namespace carina
