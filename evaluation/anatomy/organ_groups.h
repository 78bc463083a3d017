#pragma once

#include "engine/anatomy/anatomy.h"

#include <map>
#include <string>

namespace carina
{

/// By which of its measures a real organ is scaled to a patient.
enum class OrganScale : std::uint8_t { Airway, Chest };

/// One organ as both patients have it: all of its parts in one mesh, at their finest level.
struct Organ {
    OrganScale scale = OrganScale::Airway;
    TriangleMesh mesh;
};

/// The organs of a patient by name ("trachea", "ribs"), of what is compared. The larynx is its
/// cartilages and vocal ligaments, the pharynx its constrictors, the tongue without the muscles
/// below it. Muscles, vessels, discs and what a generated patient never has are left out.
[[nodiscard]] std::map<std::string, Organ> organsOf(const Anatomy& anatomy);

} // namespace carina
