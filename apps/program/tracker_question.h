#pragma once

#include "models/tracker/tracker_form.h"

#include <QCommandLineParser>

#include <filesystem>
#include <functional>
#include <optional>

class QWidget;

namespace carina::program
{

using HoldTracker = std::function<void(bool holds)>;

/// Asks a person for the tracker, beginning with the one of the last time.
/// @param kept a Polaris, server or webcam that is chosen is described in this file, or in one like
/// it
///             where that is there (keepTracker)
/// @param conversation what the window begins with for that of the choice (TrackerChoice)
/// @param hold is told to let go of the present tracker's device while one is tried, which may be
///             the same (TrackerDialog::devicesWanted)
/// @returns std::nullopt where the person cancelled; FileUnwritable for the file.
[[nodiscard]] Result<std::optional<TrackerChoice>> askForTracker(const std::filesystem::path& kept,
                                                                 const std::string& conversation,
                                                                 QWidget* parent = nullptr,
                                                                 const HoldTracker& hold = {});

/// trackerOption, which is read beside the work of the program's windows: a recording may take
/// long, and a window then tells how far it is and lets it be cancelled.
/// @returns the errors of trackerOption; Cancelled.
[[nodiscard]] Result<std::optional<TrackerChoice>>
readTrackerOption(const QCommandLineParser& parser, const QString& site);

/// The same for a program in a session, at the site of `--site`.
/// @returns also WrongOption where a tracker that is not simulated is named without a site.
[[nodiscard]] Result<std::optional<TrackerChoice>>
readSessionTracker(const QCommandLineParser& parser);

} // namespace carina::program
