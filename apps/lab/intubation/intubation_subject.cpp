#include "apps/lab/intubation/intubation_subject.h"

#include "engine/airway/tube/tube_size.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "evaluation/intubation/intubation_motion.h"

namespace carina::lab
{

Result<IntubationSubject> intubationSubject(const Anatomy& anatomy, const PatientBuild& build,
                                            Length innerDiameter)
{
    const auto motion = motionPatient(anatomy, heldJaw(anatomy.contentHash));
    if (!motion)
        return tl::unexpected(motion.error());
    const Length inner =
        innerDiameter.si > 0.0 ? innerDiameter : usualTube(build.ageInYears, build.sex);
    const auto size = tubeOfSize(inner);
    if (!size)
        return tl::unexpected(size.error());
    auto tube = motionTube(anatomy.landmarks, inner, size->length);
    if (!tube)
        return tl::unexpected(tube.error());
    return IntubationSubject{.name = anatomy.name,
                             .build = build,
                             .motion = std::make_shared<const MotionPatient>(*motion),
                             .ways = patientWays(anatomy.landmarks, motion->upper, anatomy.parts),
                             .innerDiameter = inner,
                             .tube = *std::move(tube)};
}

} // namespace carina::lab
