#include "models/patient/laryngoscopy.h"

namespace carina
{
namespace
{

/// Of who looks into a mouth from kReadingDistance: 70 mm high.
constexpr Angle kDirectFieldOfView = degrees(13.3);

bool isOfThroat(PartRole role)
{
    return role == PartRole::Epiglottis || role == PartRole::Larynx
           || role == PartRole::LaryngealMucosa || role == PartRole::VocalFold
           || role == PartRole::Pharynx;
}

/// The parts by which upperAirwayOf finds its places.
std::vector<AnatomyPart> partsOfThroat(const PatientModel& patient)
{
    std::vector<AnatomyPart> parts;
    for (const PatientSurface& surface : patient.surfaces()) {
        if (!isOfThroat(surface.description.role))
            continue;
        parts.push_back(surface.description);
        parts.back().levels.push_back(*surface.levels.front());
    }
    return parts;
}

} // namespace

Result<Laryngoscopy> Laryngoscopy::of(const PatientModel& patient, BladeKind kind)
{
    return upperAirwayOf(partsOfThroat(patient), patient.landmarks())
        .map([&](UpperAirway&& airway) {
            Laryngoscopy made;
            made.m_patient = &patient;
            made.m_blade = &bladeOf(kind);
            made.m_airway = std::move(airway);
            return made;
        });
}

LaryngoscopyPose Laryngoscopy::pose(LaryngoscopyStep step, Length lift) const
{
    return laryngoscopyPose(m_airway, m_patient->throat(RigidTransform{}).field, *m_blade, step,
                            lift);
}

BladeField Laryngoscopy::tissueAt(const RigidTransform& X_AL, const RigidTransform& X_AJ) const
{
    return bladeInTissue(followed(m_airway, m_patient->throat(X_AJ)), *m_blade, X_AL);
}

GlotticLine Laryngoscopy::glottisAt(const LaryngoscopyPose& pose) const
{
    const UpperAirway moved = followed(m_airway, m_patient->throat(pose.X_AJ));
    const auto drawn = [&pose](const Vec3& p_A) {
        return Vec3{p_A + larynxTilt<double>(pose.field.frame(), p_A).d};
    };
    return {drawn(moved.p_A_commissure), drawn(moved.p_A_notch)};
}

RigidTransform Laryngoscopy::eyeAt(const LaryngoscopyPose& pose, ScopeEye eye) const
{
    if (eye == ScopeEye::Video)
        return pose.X_AL * cameraOnBlade(*m_blade);
    const GlotticLine glottis = glottisAt(pose);
    return eyePastBlade(*m_blade, pose.X_AL, m_airway.p_A_incisors,
                        0.5 * (glottis.p_A_commissure + glottis.p_A_notch));
}

Angle Laryngoscopy::fieldOfView(ScopeEye eye)
{
    return eye == ScopeEye::Video ? kScopeFieldOfView : kDirectFieldOfView;
}

} // namespace carina
