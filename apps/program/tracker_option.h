#pragma once

#include "engine/io/site/tracker_file.h"

#include <QCommandLineParser>
#include <QString>

namespace carina::program
{

/// `--tracker FILE`: the device of a program that tracks.
void addTrackerOption(QCommandLineParser& parser);

/// The tracker that `--tracker` describes; std::nullopt without it.
/// @returns the errors of readTrackerFile.
[[nodiscard]] Result<std::optional<TrackerDescription>>
trackerOption(const QCommandLineParser& parser);

/// As it is shown, and as a site names the tracker that it was registered with: "NDI tracker at
/// /dev/ttyUSB0".
[[nodiscard]] QString trackerName(const TrackerDescription& description);

} // namespace carina::program
