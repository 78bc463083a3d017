#pragma once

#include "engine/anatomy/anatomy.h"

#include <optional>
#include <string_view>

namespace carina
{

/// The role of a surface by what its file says of it: its concept of the Foundational Model of
/// Anatomy ("FMA7394"), else its English name ("Trachea", "right_upper_lobe", "RightLung"), in any
/// case. Other where neither is known.
[[nodiscard]] PartRole recogniseRole(std::string_view conceptId, std::string_view name);

/// The side that a name speaks of: "Left second rib", "lung_R". Nothing when it names none or both.
[[nodiscard]] std::optional<Side> sideFromName(std::string_view name);

} // namespace carina
