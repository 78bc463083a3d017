#pragma once

#include "engine/session/facts/facts.h"

#include <vector>

namespace carina
{

/// The first facts about a new patient's breathing: the build, and the quiet breath of a person of
/// this build (restingPattern).
[[nodiscard]] std::vector<FactBody> introducedPatient(const PatientBuild& build);

} // namespace carina
