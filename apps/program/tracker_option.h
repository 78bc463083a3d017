#pragma once

#include "models/tracker/tracker_choice.h"

#include <QCommandLineParser>

#include <optional>

namespace carina::program
{

/// `--tracker FILE|simulated|recorded:FILE|looped:FILE`: the tracker of a program.
/// And how it is recorded: `--record FILE` its poses, `--record-device FILE` the bytes of the
/// conversation with the device.
/// @param without what the program does without a tracker, as a sentence
void addTrackerOption(QCommandLineParser& parser, const QString& without);

/// `--record FILE`: records the poses of the tracker from the start on.
[[nodiscard]] QString recordOption(const QCommandLineParser& parser);

/// The tracker that `--tracker` names; std::nullopt without it.
/// @returns the errors of trackerNamed.
[[nodiscard]] Result<std::optional<TrackerChoice>> trackerOption(const QCommandLineParser& parser);

} // namespace carina::program
