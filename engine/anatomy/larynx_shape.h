#pragma once

#include "engine/anatomy/implicit_shape.h"
#include "engine/anatomy/patient_dimensions.h"

namespace carina
{

/// Thyroid and cricoid cartilage, arytenoids and vocal cords of the built-in patient, in A. The
/// cricoid sits on the trachea's upper end; the cords lie at their height above the carina, parted
/// as for breathing, on both sides of the trachea's axis produced.
[[nodiscard]] ImplicitShape larynxShape(const PatientDimensions& dimensions);

/// The epiglottis, raised, in front of the way into the larynx, in A.
[[nodiscard]] ImplicitShape epiglottisShape(const PatientDimensions& dimensions);

} // namespace carina
