#pragma once

#include "models/tracker/tracker_choice.h"

#include <QCommandLineParser>

#include <optional>
#include <string>

namespace carina::program
{

/// `--tracker FILE|simulated[:OPTIONS]|recorded:FILE|looped:FILE|site`: the tracker of a program.
/// And how it is recorded: `--record FILE` its poses, `--record-device FILE` the bytes of the
/// conversation with the device. OPTIONS are those of readSimulatedOptions and of simulatedWordsIn.
/// @param without what the program does without a tracker, as a sentence
void addTrackerOption(QCommandLineParser& parser, const QString& without);

/// Whether `--tracker` is given.
[[nodiscard]] bool namesTracker(const QCommandLineParser& parser);

/// Whether `--tracker site` names the devices of the site.
[[nodiscard]] bool namesSiteDevices(const QCommandLineParser& parser);

/// `--record FILE`: records the poses of the tracker from the start on.
[[nodiscard]] QString recordOption(const QCommandLineParser& parser);

/// `--record-device FILE`: records the bytes to and from a tracker that a person chooses; empty
/// without it.
[[nodiscard]] std::string recordDeviceOption(const QCommandLineParser& parser);

/// The tracker that `--tracker` names, else the devices that the site names (trackerOfSite);
/// std::nullopt without either, and where the site names none.
/// @param site its file; empty: none
/// @returns the errors of trackerNamed, simulatedWordsIn and trackerOfSite; WrongOption for
///          `--record-device` with a tracker that exchanges no bytes, and for `--tracker site`
///          without a site.
[[nodiscard]] Result<std::optional<TrackerChoice>>
trackerOption(const QCommandLineParser& parser, const QString& site, const Progress& goesOn = {});

} // namespace carina::program
