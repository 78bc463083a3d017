#pragma once

#include "engine/core/progress.h"
#include "engine/io/site/tracker_file.h"
#include "engine/tracking/record/recorded_tracker.h"
#include "models/tracker/known_volume.h"

#include <QString>

#include <memory>
#include <variant>

namespace carina
{

/// The simulated tracker and manikin, which each program makes for what it does with them.
struct SimulatedDevice {
};

/// A recording, which is played from its beginning.
struct PlayedRecording {
    std::string file; ///< as it was named
    TrackerSequence sequence;
    Playing playing = Playing::Once;
};

/// The tracker that a program is to use.
struct TrackerChoice {
    std::variant<SimulatedDevice, PlayedRecording, TrackerDescription> device;
    /// The file for the bytes of the conversation with the device, where it has one; empty: none.
    /// A file that is there already is kept: the next one is NAME-2, and so on.
    std::string conversation{};

    [[nodiscard]] bool isSimulated() const
    {
        return std::holds_alternative<SimulatedDevice>(device);
    }
};

/// The choice that words name: "simulated"; "recorded:FILE", a recording
/// (readAnyRecording), which is played once; "looped:FILE", one that is played again and again;
/// otherwise a file that describes a tracker (describedIn).
/// @returns the errors of reading that file.
[[nodiscard]] Result<TrackerChoice> trackerNamed(const QString& words);

/// What a file describes: Carina's own description (readTrackerFile), or where its name ends in
/// .xml a device set of PLUS (readPlusDeviceSet).
/// @returns the errors of reading it.
[[nodiscard]] Result<TrackerChoice> describedIn(const std::filesystem::path& file);

/// The recording in a file. @returns the errors of reading it; Cancelled.
[[nodiscard]] Result<TrackerChoice> recordedTracker(const std::string& file, Playing playing,
                                                    const Progress& goesOn = {});

/// As it is shown, and as a site names the tracker that it was registered with: "Simulated
/// tracker", "Recording of FILE", "NDI tracker at /dev/ttyUSB0", "Markers before the camera
/// /dev/video0".
[[nodiscard]] QString trackerName(const TrackerChoice& choice);

/// The same for the question whether a site was registered with this tracker; empty for a
/// recording, which may be of any.
[[nodiscard]] QString trackerIdentity(const TrackerChoice& choice);

/// The volume in which such a tracker usually sees.
[[nodiscard]] KnownVolume usualVolume(const TrackerChoice& choice);

/// Whether bytes are exchanged with it, which can be recorded: a Polaris or a server.
[[nodiscard]] bool hasConversation(const TrackerChoice& choice);

/// The tracker itself, not started.
/// @pre the choice is not the simulated tracker.
/// @returns the errors of describedTracker and of DeviceLog::create.
[[nodiscard]] Result<std::unique_ptr<Tracker>> makeTracker(const TrackerChoice& choice,
                                                           ReadSessionClock clock);

} // namespace carina
