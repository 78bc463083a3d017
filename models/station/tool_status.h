#pragma once

#include "engine/tracking/tracker.h"

#include <QString>

#include <vector>

namespace carina
{

/// The visibility of one tool of a tracker.
struct ToolStatus {
    ToolRole role = ToolRole::Other;
    QString name{};         ///< as shown: "Stylus"
    bool isVisible = false; ///< tracked, with recent samples
    QString text{};         ///< "out of view", or sample rate and quality
};

/// The status of a tracker's tools at a time on its clock.
[[nodiscard]] std::vector<ToolStatus> toolStatus(const Tracker& tracker, SessionTime now);

} // namespace carina
