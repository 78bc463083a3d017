#include "apps/lab/intubation/intubation_subject.h"

#include "engine/airway/lumen/measured_lumen.h"
#include "engine/airway/tube/tube_size.h"
#include "engine/anatomy/patient/builtin_patient.h"

#include <utility>

namespace carina::lab
{

Result<IntubationSubject> intubationSubject(const Anatomy& anatomy, const PatientBuild& build,
                                            Length innerDiameter, TubeBending bending)
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
    IntubationSubject subject{.name = anatomy.name,
                              .build = build,
                              .motion = std::make_shared<const MotionPatient>(*motion),
                              .ways = patientWays(anatomy.landmarks, motion->upper, anatomy.parts),
                              .innerDiameter = {},
                              .tube = {},
                              .bending = bending,
                              .lumen = {}};
    takeTube(subject, anatomy, *std::move(tube));
    return subject;
}

void takeTube(IntubationSubject& subject, const Anatomy& anatomy, TubeShape tube)
{
    subject.lumen = nullptr;
    if (!tube.fitsAirway || subject.bending == TubeBending::Elastic)
        if (auto lumen = measuredLumen(anatomy.parts, anatomy.landmarks, 0.5 * tube.outerDiameter))
            subject.lumen = std::make_shared<const AirwayLumen>(*std::move(lumen));
    subject.innerDiameter = tube.innerDiameter;
    subject.tube = std::move(tube);
}

} // namespace carina::lab
