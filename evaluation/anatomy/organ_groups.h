#pragma once

#include "engine/anatomy/anatomy.h"

#include <map>
#include <string>

namespace carina
{

/// Which scale of AnatomyComparison a real organ gets.
enum class OrganScale : std::uint8_t { Airway, Chest };

/// One organ: all of its parts in one mesh, at their finest level.
struct Organ {
    OrganScale scale = OrganScale::Airway;
    TriangleMesh mesh;
};

/// The compared organs of a patient, by name ("trachea", "ribs"). The larynx is its cartilages and
/// vocal ligaments, the pharynx its constrictors, the tongue without the muscles below it. Muscles,
/// vessels, discs and parts that no generated patient has are left out.
[[nodiscard]] std::map<std::string, Organ> organsOf(const Anatomy& anatomy);

} // namespace carina
