#pragma once

#include "models/tracker/tracker_form.h"

#include <filesystem>
#include <optional>

namespace carina
{

// Trackers that a person described in a window are kept in files beside the site: the first in
// tracker.json, another one in tracker_2.json and so on. What is there already, a description that
// was written by hand among it, is never written to.

/// Whether what a form describes is to be kept: a Polaris, a server, and a webcam. A video is not,
/// as it need not lie where a description beside the site can name it.
[[nodiscard]] bool isToBeKept(const TrackerForm& form);

/// The description of these that was written or chosen last; nothing where there is none.
/// @param kept the first of the files
[[nodiscard]] std::optional<std::filesystem::path>
lastKeptTracker(const std::filesystem::path& kept);

/// Keeps a description: in the file that says the same already, else in a new one.
/// @returns its file; FileUnwritable.
[[nodiscard]] Result<std::filesystem::path> keepTracker(const std::filesystem::path& kept,
                                                        const TrackerDescription& description);

/// The fields to begin with: the description that was kept last, and beside it what a Polaris, a
/// server or a webcam that it describes is connected by.
[[nodiscard]] TrackerForm formOfKept(const std::filesystem::path& kept);

} // namespace carina
