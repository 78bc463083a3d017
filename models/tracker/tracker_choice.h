#pragma once

#include "engine/core/progress.h"
#include "engine/io/site/devices/site_devices.h"
#include "engine/tracking/record/recorded_tracker.h"
#include "engine/tracking/simulated/simulated_options.h"
#include "models/tracker/known_volume.h"
#include "models/tracker/played_motion.h"

#include <QByteArray>
#include <QString>

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace carina
{

/// The simulated tracker and manikin, which each program makes for what it does with them.
struct SimulatedDevice {
    SimulatedTrackerSettings settings{}; ///< rate, occlusions and dropouts that were chosen
    PlayMotion play{}; ///< what its hands do in a session; without it they insert the tube
};

/// A recording, which is played from its beginning.
struct PlayedRecording {
    std::string file; ///< as it was named
    TrackerSequence sequence;
    Playing playing = Playing::Once;
};

/// Several devices that track together, in the frame of the first.
struct DeviceSet {
    std::vector<PlacedDescription> devices; ///< two or more
};

/// The tracker that a program is to use.
struct TrackerChoice {
    std::variant<SimulatedDevice, PlayedRecording, TrackerDescription, DeviceSet> device;
    /// The file for the bytes of the conversation with the device, where it has one; empty: none.
    /// A file that is there already is kept: the next one is NAME-2, and so on.
    std::string conversation{};

    [[nodiscard]] bool isSimulated() const
    {
        return std::holds_alternative<SimulatedDevice>(device);
    }
};

/// The choice that words name: "simulated", or "simulated:OPTIONS" (readSimulatedOptions);
/// "recorded:FILE", a recording
/// (readAnyRecording), which is played once; "looped:FILE", one that is played again and again;
/// otherwise a file that describes a tracker (describedIn).
/// A recording takes long.
/// @returns the errors of reading that file and of readSimulatedOptions; Cancelled.
[[nodiscard]] Result<TrackerChoice> trackerNamed(const QString& words, const Progress& goesOn = {});

/// The words that name the simulated tracker with these options.
[[nodiscard]] QString simulatedName(const SimulatedOptions& options);

/// What a file describes (readAnyDescription).
/// @returns the errors of reading it.
[[nodiscard]] Result<TrackerChoice> describedIn(const std::filesystem::path& file);

/// The devices that a site names in its file; nothing where it names none, or there is no such
/// file.
/// @returns the errors of readSiteFile and of readSiteDevices.
[[nodiscard]] Result<std::optional<TrackerChoice>> trackerOfSite(const std::filesystem::path& site);

/// The recording in a file. @returns the errors of reading it; Cancelled.
[[nodiscard]] Result<TrackerChoice> recordedTracker(const std::string& file, Playing playing,
                                                    const Progress& goesOn = {});

/// As it is shown, and as a site names the tracker that it was registered with: "Simulated
/// tracker", "Recording of FILE", "NDI tracker at /dev/ttyUSB0", "Markers before the camera
/// /dev/video0"; of several devices one after another.
[[nodiscard]] QString trackerName(const TrackerChoice& choice);

/// The same for the question whether a site was registered with this tracker: of several devices
/// that of the first, in whose frame they track; empty for a recording, which may be of any. With a
/// number for what the poses rest on besides the device, where that is known: the calibration of a
/// camera, and the markers of the tools that a site is registered and calibrated with.
[[nodiscard]] QString trackerIdentity(const TrackerChoice& choice);

/// The devices that track together, the first in its own frame; none of a simulated tracker, and of
/// a recording.
[[nodiscard]] std::vector<PlacedDescription> devicesOf(const TrackerChoice& choice);

/// All that a description says of a device and its tools, as bytes: two devices with the same are
/// one.
[[nodiscard]] QByteArray contentOf(const TrackerDescription& described);

/// Whether both are the same devices in the same places, or both are none.
[[nodiscard]] bool areSameDevices(const std::optional<TrackerChoice>& a,
                                  const std::optional<TrackerChoice>& b);

/// The volume in which such a tracker usually sees; of several devices that of the first.
[[nodiscard]] KnownVolume usualVolume(const TrackerChoice& choice);

/// Whether bytes are exchanged with it, which can be recorded: a Polaris or a server.
[[nodiscard]] bool hasConversation(const TrackerChoice& choice);

/// The tracker itself, not started.
/// @pre the choice is not the simulated tracker.
/// @returns the errors of describedTracker and of DeviceLog::create.
[[nodiscard]] Result<std::unique_ptr<Tracker>> makeTracker(const TrackerChoice& choice,
                                                           ReadSessionClock clock);

} // namespace carina
