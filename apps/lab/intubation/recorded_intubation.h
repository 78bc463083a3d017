#pragma once

#include "apps/lab/intubation/watched_intubation.h"
#include "engine/session/station_tracking.h"
#include "engine/tracking/sequence_file.h"
#include "evaluation/intubation/observed_motion.h"

#include <functional>
#include <optional>

namespace carina::lab
{

/// How the recording of a tracker is to be understood. Unless said otherwise the tracker measures
/// in the patient's frame A, the connector, the blade and the mandible themselves, as those of
/// recordingOf.
struct RecordingSetup {
    StationRegistration registration{.X_AT = {}, .X_JA = RigidTransform{}};
    Blade blade;
    std::vector<MotionCommand> commands; ///< by time, from its beginning
    /// By time from its beginning. No tool tells it.
    std::function<HeadPosition(Duration)> headAt = [](Duration) { return HeadPosition{}; };
    PlacementError expected{};           ///< of the poses
    std::optional<SessionTime> begins{}; ///< by its clock; nothing: with its first sample
};

/// Runs a recording through pose histories, registration and monitor: a moment for each sample of
/// the tube, with the other tools as interpolated. Without a jaw the mandible stays as it is in the
/// surfaces.
/// @returns NothingRecognised for a recording without a tube
[[nodiscard]] Result<WatchedIntubation> watchRecording(const IntubationSubject& subject,
                                                       const TrackerSequence& recording,
                                                       const RecordingSetup& setup);

/// The tools as a recording in the frame A as it was registered: Tube, Laryngoscope and Jaw.
[[nodiscard]] TrackerSequence recordingOf(const ObservedMotion& seen);

} // namespace carina::lab
