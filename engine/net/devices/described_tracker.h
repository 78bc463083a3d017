#pragma once

#include "engine/io/site/devices/tracker_file.h"
#include "engine/net/devices/device_log.h"
#include "engine/tracking/delivery_thread.h"

#include <memory>

namespace carina
{

/// The tracker that a description is of, not started.
/// @param log where the bytes of the conversation with the device are written; null: nowhere. A
///        camera has none
/// @returns WrongAddress for an address that its kind cannot have; the errors of
///          CameraTracker::make.
[[nodiscard]] Result<std::unique_ptr<Tracker>>
describedTracker(const TrackerDescription& description, ReadSessionClock clock,
                 std::unique_ptr<DeviceLog> log = {});

} // namespace carina
