#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace carina
{

/// One frame as drawn: its content and its times.
struct LoggedFrame {
    /// When the frame was expected to be lit: CLOCK_MONOTONIC, common to all programs of a machine.
    LocalTime local{};
    SessionTime session{};              ///< the session time that was drawn
    int level = 0;                      ///< level of detail of the lungs
    std::array<float, 2> amplitude{};   ///< of the diaphragm at the right and the left lung
    std::optional<RigidTransform> X_AE; ///< the tube as drawn
    std::optional<Duration> sampleAge;  ///< of the tube's newest sample
    std::array<double, 2> volume_ml{};  ///< right and left lung, from the drawn vertices
    std::optional<RigidTransform> X_AV; ///< the patient as drawn; empty before any action on it
};

/// Writes frames as CSV with a header line, one line per frame; the columns are the members of
/// LoggedFrame with their units, empty if a value is absent.
/// @returns FileUnwritable with the path.
[[nodiscard]] Result<void> writeFrames(const QString& path, const std::vector<LoggedFrame>& frames);

/// Reads a file of writeFrames.
/// @returns FileNotFound, or FileMalformed with the path and line.
[[nodiscard]] Result<std::vector<LoggedFrame>> readFrames(const QString& path);

} // namespace carina
