#pragma once

#include "apps/lab/command/words.h"
#include "evaluation/drift/drift_experiment.h"

#include <vector>

namespace carina::lab
{

/// What `drift` is asked for.
struct DriftRequest {
    DriftSettings settings;
    int seeds = 1;
    bool isLive = false;
    QString logs;
    QString netlab;
};

/// @returns WrongOption; what findScenario does.
[[nodiscard]] Result<DriftRequest> driftRequest(const Words& words);

/// The runs of a table, in its order: a request for each scenario, strategy and number of
/// participants, of those that the words name or else of all that a table has.
/// @returns as driftRequest does.
[[nodiscard]] Result<std::vector<DriftRequest>> tableRequests(const Words& words);

/// Whether a table is asked for.
[[nodiscard]] bool isTable(const Words& words);

/// As it is named in options and results.
[[nodiscard]] std::string_view nameOf(ActionScript::Axes axes);

} // namespace carina::lab
