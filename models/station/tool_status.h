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
    QString text{};         ///< "out of view", or how often and how well it is seen
};

/// The tools of a tracker at a time on its clock.
[[nodiscard]] std::vector<ToolStatus> toolStatus(const Tracker& tracker, SessionTime now);

} // namespace carina
