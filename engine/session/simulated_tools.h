#pragma once

#include "engine/anatomy/shapes/tube.h"
#include "engine/registration/calibration/blade_calibration.h"
#include "engine/registration/calibration/tube_rest.h"

namespace carina
{

/// What the simulated tube and laryngoscope truly are, and where their markers are on them: what a
/// calibration of them is to find.
struct SimulatedTools {
    RigidTransform X_NE; ///< the connector in the frame of the tube's markers
    TubeRest tube;
    RigidTransform X_NL; ///< the blade in the frame of the laryngoscope's markers
    BladeShape blade;
};

/// @param tube of the patient, whose length and thickness the real one has; its curvature is that
///             of tubes as they are sold, a radius of 140 mm (ISO 5361). The sizes of the
///             laryngoscope are of ours, about those of an adult's, curved as that of Macintosh
[[nodiscard]] SimulatedTools simulatedTools(const TubeShape& tube);

} // namespace carina
