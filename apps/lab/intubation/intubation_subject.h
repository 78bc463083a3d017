#pragma once

#include "engine/airway/lumen/airway_lumen.h"
#include "engine/airway/monitor/patient_ways.h"
#include "engine/anatomy/patient/patient_build.h"
#include "engine/anatomy/shapes/tube.h"
#include "evaluation/intubation/intubation_motion.h"

#include <memory>

namespace carina::lab
{

/// Whom scripted motions intubate, with which tube.
struct IntubationSubject {
    std::string name;
    PatientBuild build;
    std::shared_ptr<const MotionPatient> motion; ///< as those who move know the patient,
    PatientWays ways;                            ///< and as the monitor does
    Length innerDiameter{};
    TubeShape tube;
    TubeBending bending = TubeBending::Rigid; ///< as the hands move it
    bool isBendKnown = true; ///< of the tube; else it is only taken to have the form of the airway
    /// For tubes as thick as that, where it bends or was touched; else null, and where it cannot be
    /// measured (measuredLumen).
    std::shared_ptr<const AirwayLumen> lumen;
};

/// That another tube is used, in the lumen for it.
/// @param anatomy of the subject
void takeTube(IntubationSubject& subject, const Anatomy& anatomy, TubeShape tube);

/// @param innerDiameter of the tube; 0: the usual one
/// @returns the errors of motionPatient, tubeOfSize and motionTube
[[nodiscard]] Result<IntubationSubject> intubationSubject(const Anatomy& anatomy,
                                                          const PatientBuild& build,
                                                          Length innerDiameter,
                                                          TubeBending bending = TubeBending::Rigid);

} // namespace carina::lab
