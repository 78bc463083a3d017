#pragma once

#include "engine/io/files/json_fields.h"
#include "engine/io/site/site_device.h"

#include <vector>

namespace carina
{

/// A device of a site as it stands in the site file (site_file.h).
[[nodiscard]] QJsonObject jsonDevice(const SiteDevice& device);

/// The devices of a site; the first fault is kept in the fields.
[[nodiscard]] std::vector<SiteDevice> readDevices(JsonFields& fields);

/// No site has more.
inline constexpr std::size_t kMostDevices = 8;
/// No two devices stamp the same moment farther apart.
inline constexpr Duration kLatestDevice = std::chrono::seconds{5};

} // namespace carina
