#pragma once

#include "engine/registration/rigid_fit.h"

#include <optional>

namespace carina
{

/// How far each landmark lies from where the fit of all others puts it, metres. A landmark that was
/// touched at a wrong place draws the fit of all to itself and hides; from that of the others it
/// stands out.
///
/// @returns in the pairs' order, nothing where the others alone determine no fit (three, or on one
///          line); what fitRigid returns for all of them.
[[nodiscard]] Result<std::vector<std::optional<double>>>
leaveOneOut(std::span<const LandmarkPair> pairs);

} // namespace carina
