#pragma once

#include "engine/geometry/vec.h"

#include <cstdint>
#include <optional>

namespace carina
{

/// Which parts a section cuts.
enum class Cut : std::uint8_t {
    All,          ///< all parts but tools
    AllButAirway, ///< all parts but tools and airway
};

/// A section plane of a scene: points p in A with normal_A . p > distance are not drawn.
struct Section {
    Vec3 normal_A = Vec3::UnitY(); ///< of length 1, away from the part that stays
    double distance = 0.0;         ///< of the plane from the origin of A along it, metres
    Cut cut = Cut::All;

    friend bool operator==(const Section&, const Section&) = default;
};

} // namespace carina
