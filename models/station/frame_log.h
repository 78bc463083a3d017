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

/// One frame as it was drawn: what went to the screen, and when.
struct LoggedFrame {
    /// CLOCK_MONOTONIC when the frame was expected to be lit; one clock for all on a machine.
    LocalTime local{};
    SessionTime session{};              ///< the session time that was drawn
    int level = 0;                      ///< level of detail of the lungs
    std::array<float, 2> amplitude{};   ///< of the diaphragm at the right and the left lung
    std::optional<RigidTransform> X_AE; ///< the tube as drawn
    std::optional<Duration> sampleAge;  ///< of the newest sample of the tube behind it
    std::array<double, 2> volume_ml{};  ///< right and left lung, from the vertices drawn
    std::optional<RigidTransform> X_AV; ///< the virtual patient as drawn, once it was acted on
};

/// Writes frames as CSV with a header line, one line each; the columns are those of LoggedFrame
/// with their units, empty where a value is absent.
/// @returns FileUnwritable with the path.
[[nodiscard]] Result<void> writeFrames(const QString& path, const std::vector<LoggedFrame>& frames);

/// Reads what writeFrames wrote.
/// @returns FileNotFound, or FileMalformed with the path and line.
[[nodiscard]] Result<std::vector<LoggedFrame>> readFrames(const QString& path);

} // namespace carina
