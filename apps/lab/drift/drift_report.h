#pragma once

#include "apps/lab/drift/live_evaluation.h"
#include "evaluation/drift/drift_experiment.h"

#include <QJsonObject>

namespace carina::lab
{

/// The figures of a drift experiment as `carina-lab drift` prints them.
[[nodiscard]] QJsonObject reportOf(const DriftFigures& figures);

/// Those of a live one, beside what its time average must be below, and the machine's load of now.
[[nodiscard]] QJsonObject reportOf(const LiveFigures& figures, const ActionScript::Settings& script,
                                   const DriftScenario& scenario);

} // namespace carina::lab
