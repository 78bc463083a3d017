#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/net/node/session_node.h"

namespace carina
{

/// Tells the session which patient lies at a station, and how it breathes at rest.
void introducePatient(SessionNode& node, StationId station, const std::string& contentHash,
                      const std::string& name, const PatientDimensions& dimensions);

/// Lays a patient that is made from its parameters: introduces it, and shares it and its groups of
/// organs as objects to act on.
void layNewPatient(SessionNode& node, StationId station, const PatientParameters& parameters);

} // namespace carina
