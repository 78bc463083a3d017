#pragma once

#include "engine/geometry/vec.h"

#include <cstdint>
#include <optional>

namespace carina
{

/// What a section takes away.
enum class Cut : std::uint8_t {
    All,          ///< all that lies beyond the plane, but tools
    AllButAirway, ///< the airway stays whole, too: what lies around it is cut away
};

/// A plane that cuts a scene open: what lies at p with normal_A . p > distance is not drawn.
struct Section {
    Vec3 normal_A = Vec3::UnitY(); ///< of length 1, out of what stays
    double distance = 0.0;         ///< of the plane from the origin of A along it, metres
    Cut cut = Cut::All;
};

} // namespace carina
