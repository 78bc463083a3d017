#pragma once

#include "evaluation/anatomy/anatomy_comparison.h"

#include <QJsonArray>
#include <QJsonObject>

namespace carina::lab
{

/// A comparison as `anatomy compare` prints it, with "unmet": one line for each demand that is not
/// met.
[[nodiscard]] QJsonObject reportOf(const AnatomyComparison& comparison);

/// "self_intersections" of a report.
[[nodiscard]] QJsonArray listOf(const std::vector<SelfIntersection>& found);

} // namespace carina::lab
