#pragma once

#include "models/tracker/tracker_form.h"

#include <filesystem>
#include <optional>

class QWidget;

namespace carina::program
{

/// Asks a person for the tracker, beginning with the one of the last time.
/// @param kept a Polaris or server that is chosen is described in this file, or in one like it
///             where that is there (keepTracker)
/// @param conversation of the choice (TrackerChoice)
/// @returns std::nullopt where the person cancelled; FileUnwritable for the file.
[[nodiscard]] Result<std::optional<TrackerChoice>> askForTracker(const std::filesystem::path& kept,
                                                                 const std::string& conversation,
                                                                 QWidget* parent = nullptr);

} // namespace carina::program
