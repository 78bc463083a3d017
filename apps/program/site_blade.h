#pragma once

#include "models/patient/laryngoscopy.h"
#include "models/station/shared_tools.h"

#include <optional>

namespace carina::program
{

/// The blade of the own laryngoscope as it was touched; nothing where it was not.
[[nodiscard]] std::optional<Blade> bladeOf(const SharedTools& tools);

} // namespace carina::program
