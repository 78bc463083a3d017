#pragma once

#include "engine/io/site/devices/tracker_file.h"

namespace carina
{

/// What a file describes: Carina's own description (readTrackerFile), or where its name ends in
/// .xml a device set of PLUS (readPlusDeviceSet).
/// @returns the errors of reading it.
[[nodiscard]] Result<TrackerDescription> readAnyDescription(const std::filesystem::path& file);

} // namespace carina
