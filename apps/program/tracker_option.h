#pragma once

#include "models/tracker/tracker_choice.h"

#include <QCommandLineParser>

#include <optional>

namespace carina::program
{

/// `--tracker FILE|simulated|recorded:FILE|looped:FILE`: the tracker of a program.
/// @param without what the program does without it, as a sentence
void addTrackerOption(QCommandLineParser& parser, const QString& without);

/// The tracker that `--tracker` names; std::nullopt without it.
/// @returns the errors of trackerNamed.
[[nodiscard]] Result<std::optional<TrackerChoice>> trackerOption(const QCommandLineParser& parser);

} // namespace carina::program
