#pragma once

#include "evaluation/intubation/intubation_motion.h"
#include "evaluation/intubation/motion_parameters.h"

namespace carina
{

/// A motion of a kind with the parameters of one run. The same arguments give the same motion, bit
/// for bit.
///
/// It knows nothing of how an intubation is recognised: what it is made of are people's movements,
/// and its ways are those of the patient's surfaces.
///
/// @param seed of the hand's tremor
/// @param bending of the tube between the walls of its way
/// @returns the errors of IntubationMotion::make
[[nodiscard]] Result<IntubationMotion> scriptedMotion(MotionKind kind,
                                                      const MotionParameters& parameters,
                                                      std::shared_ptr<const MotionPatient> patient,
                                                      TubeShape tube, std::uint32_t seed,
                                                      TubeBending bending = TubeBending::Rigid);

/// The generator from which the parameters of a run are drawn, and what else it needs: another one
/// for each motion and seed.
[[nodiscard]] std::mt19937 generatorOf(MotionKind kind, std::uint32_t seed);

} // namespace carina
