#pragma once

#include "engine/tracking/tracker.h"

#include <QString>

#include <vector>

namespace carina
{

/// How a tracker sees one of its tools now.
struct ToolStatus {
    ToolRole role = ToolRole::Other;
    QString name{};         ///< as shown: "Stylus"
    bool isVisible = false; ///< tracked, and not silent
    QString text{};         ///< "visible, 60 Hz, error 0.21 mm, 9 ms old", or "out of view"
};

/// The tools of a tracker at a time on its clock.
[[nodiscard]] std::vector<ToolStatus> toolStatus(const Tracker& tracker, SessionTime now);

} // namespace carina
