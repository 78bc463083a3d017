#pragma once

#include "engine/io/site/devices/tracker_file.h"
#include "engine/tracking/several/body_watch.h"

namespace carina::lab
{

/// A device that sees the body, and its name of the tool that is fixed to it.
struct Watcher {
    TrackerDescription described;
    std::string tool;
};

/// Tracks with both devices for so long, with their stamps on one clock.
/// @returns the errors of describedTracker, BodyWatch::begin and BodyWatch::end.
[[nodiscard]] Result<WatchedBody> watchBody(const Watcher& first, const Watcher& second,
                                            Duration duration);

/// What a recording in Carina's own form has of a tool; only such stamps can be compared with those
/// of another recording.
/// @returns the errors of readAnyRecording; WrongOption for another form, or a tool that is not in
///          it.
[[nodiscard]] Result<BodySamples> recordedBody(const std::string& file, const std::string& tool);

} // namespace carina::lab
