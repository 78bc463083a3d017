#pragma once

#include "engine/core/result.h"
#include "engine/io/site/devices/tracker_file.h"
#include "engine/io/site/site.h"
#include "engine/tracking/several/frame_calibration.h"

#include <filesystem>

namespace carina
{

/// Functions that return a site with other devices. What was measured with a device whose frame is
/// another one now, or that is gone, is kept and marked as stale by the tracker
/// (StaleCause::Tracker):
///
///     touches, registration, verification   where the device sees the stylus; a landmark that is
///                                           touched while the manikin is registered again is
///                                           dropped
///     registration, verification            where it sees the chin or body probe that these
///                                           follow
///     tube, laryngoscope                    where it sees either the tool or the stylus that it
///                                           was touched with, but not both
///
/// Of a device whose description cannot be read any more, all of these.
///
/// `folder` is that of the site file. All return the errors of readSiteDevices, which tell whether
/// the devices can be used together.

/// The first device, in whose frame all track, in place of the one of before. What was measured
/// with that one tells itself by the tracker's name.
/// @pre there is no second one.
[[nodiscard]] Result<Site> withFirstDevice(Site site, const std::filesystem::path& folder,
                                           std::string file);

/// Another device, or one of the site that was calibrated anew.
/// @pre there is a first one, which is not this.
[[nodiscard]] Result<Site> withDevice(Site site, const std::filesystem::path& folder,
                                      SiteDevice device);

/// Without a device.
/// @pre it is there, and not the first while there is another.
[[nodiscard]] Result<Site> withoutDevice(Site site, const std::filesystem::path& folder,
                                         std::string file);

/// As a site file names the file that describes a device: relative to its folder.
[[nodiscard]] std::string deviceFile(const std::filesystem::path& folder,
                                     const std::filesystem::path& file);

/// A calibration as a site stores it. @param at ISO 8601
[[nodiscard]] SiteDeviceFrame deviceFrame(const FrameCalibration& found, std::string at);

} // namespace carina
