#include "tests/evaluation/intubation/tube_patient.h"

#include "engine/anatomy/patient/patient_landmarks.h"
#include "engine/anatomy/shapes/swept_surface.h"
#include "evaluation/intubation/intubation_motion.h"

namespace carina::test
{
namespace
{

/// With a section every millimetre.
AnatomyPart tubePart(const char* name, PartRole role, const Vec3& from, const Vec3& to,
                     double radius)
{
    const std::array ends{from, to};
    const SweptLine line = sweptLine(ends);
    std::vector<Ring> rings;
    for (double along = 0.0; along < line.along.back(); along += 1e-3)
        rings.push_back({along, radius});
    return {name, role, {}, {sweptSurface(line, rings)}};
}

} // namespace

AirwayRod mainBronchusOf(const PatientDimensions& dimensions, Side side)
{
    AirwayRod rod = AirwaySolid{dimensions}.rods(side)[0];
    rod.p_W_from = windpipeInAnatomy() * rod.p_W_from;
    rod.p_W_to = windpipeInAnatomy() * rod.p_W_to;
    return rod;
}

Anatomy tubePatient(const PatientDimensions& dimensions)
{
    Anatomy patient;
    patient.name = "tubes";
    patient.landmarks = landmarksOf(bodyPlanOf(dimensions, Posture::Laryngoscopy)).airway;
    const auto add = [&](const char* name, PartRole role, const Vec3& from, const Vec3& to,
                         double radius) {
        patient.parts.push_back(tubePart(name, role, from, to, radius));
    };
    for (const Side side : {Side::Right, Side::Left}) {
        const AirwayRod rod = mainBronchusOf(dimensions, side);
        const bool isRight = side == Side::Right;
        add(isRight ? "Right main bronchus" : "Left main bronchus",
            isRight ? PartRole::RightMainBronchus : PartRole::LeftMainBronchus, rod.p_W_from,
            rod.p_W_to, rod.radiusFrom);
    }
    const Vec3 up = windpipeInAnatomy().rotation() * Vec3::UnitZ();
    const Vec3 back = windpipeInAnatomy().rotation() * Vec3::UnitY();
    const Vec3 glottis = patient.landmarks.p_A_glottis;
    const double larynx = dimensions.cordsToCarina / millimetres(127.0);
    add("Oesophagus", PartRole::Oesophagus,
        dimensions.tracheaLength.si * up + kBehindTrachea * back,
        -0.08 * up + kBehindTrachea * back, 0.006);
    for (const double side : {1.0, -1.0})
        add(side > 0.0 ? "Left vocal ligament" : "Right vocal ligament", PartRole::VocalFold,
            glottis + larynx * Vec3{0.001 * side, -0.010, 0.0},
            glottis + larynx * Vec3{0.004 * side, 0.010, 0.0}, 0.0005);
    const Vec3 root = glottis + larynx * (0.012 * up - 0.012 * back);
    add("Epiglottis", PartRole::Epiglottis, root, root + larynx * (0.028 * up + 0.006 * back),
        0.002);
    add("Uvula", PartRole::Pharynx, patient.landmarks.p_A_incisors + Vec3{0.0, 0.05, 0.0},
        patient.landmarks.p_A_incisors + Vec3{0.0, 0.05, -0.012}, 0.002);
    return patient;
}

TubeShape tubeOfBoy()
{
    constexpr Length kWhole = millimetres(300.0);
    return motionTube(boyOfTubes()->airway, millimetres(6.5), kWhole).value();
}

std::shared_ptr<const MotionPatient> boyOfTubes()
{
    static const auto boy = std::make_shared<const MotionPatient>(
        motionPatient(tubePatient(dimensionsOf(BuiltinPatient::TwelveYears)), {}).value());
    return boy;
}

} // namespace carina::test
