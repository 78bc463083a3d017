#pragma once

#include "engine/io/site/tracker_file.h"
#include "engine/tracking/delivery_thread.h"

#include <memory>

namespace carina
{

/// The tracker that a description is of, not started.
/// @returns WrongAddress for an address that its kind cannot have; the errors of
///          CameraTracker::make.
[[nodiscard]] Result<std::unique_ptr<Tracker>>
describedTracker(const TrackerDescription& description, ReadSessionClock clock);

} // namespace carina
