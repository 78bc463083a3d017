#pragma once

#include "apps/lab/drift/live_evaluation.h"
#include "evaluation/drift/drift_experiment.h"

#include <QJsonObject>

namespace carina::lab
{

/// The figures of a drift experiment as `carina-lab drift` prints them.
[[nodiscard]] QJsonObject reportOf(const DriftFigures& figures);

/// Those of a live one, beside what its time average must be below, and the machine's load of now.
/// @param inVirtualTime those of the same experiment in virtual time
[[nodiscard]] QJsonObject reportOf(const LiveFigures& figures, const DriftSettings& settings,
                                   const DriftFigures& inVirtualTime);

} // namespace carina::lab
