#pragma once

#include "engine/anatomy/anatomy.h"

#include <optional>
#include <string_view>

namespace carina
{

/// The role of a surface, recognised by its concept id of the Foundational Model of Anatomy
/// ("FMA7394"), otherwise by its English name in any case ("Trachea", "right_upper_lobe",
/// "RightLung"). Other where neither is recognised.
[[nodiscard]] PartRole recogniseRole(std::string_view conceptId, std::string_view name);

/// The side that a name contains: "Left second rib", "lung_R". Nothing for none or both.
[[nodiscard]] std::optional<Side> sideFromName(std::string_view name);

} // namespace carina
