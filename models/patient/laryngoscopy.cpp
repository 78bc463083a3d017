#include "models/patient/laryngoscopy.h"

#include "engine/anatomy/events/mouth_opening.h"

#include <algorithm>

namespace carina
{
namespace
{

/// Of who looks into a mouth from kReadingDistance: 70 mm high.
constexpr Angle kDirectFieldOfView = degrees(13.3);

bool isLookedThrough(PartRole role)
{
    return role == PartRole::Epiglottis || role == PartRole::Larynx
           || role == PartRole::LaryngealMucosa || role == PartRole::VocalFold
           || role == PartRole::Hyoid || role == PartRole::Pharynx || role == PartRole::Tongue
           || role == PartRole::Tooth || role == PartRole::Trachea || role == PartRole::Skin;
}

/// The parts by which upperAirwayOf finds its places.
std::vector<AnatomyPart> partsOfThroat(const PatientModel& patient)
{
    std::vector<AnatomyPart> parts;
    for (const PatientSurface& surface : patient.surfaces()) {
        if (!isLookedThrough(surface.description.role) && !isLip(surface.description))
            continue;
        parts.push_back(surface.description);
        parts.back().levels.push_back(*surface.levels.front());
    }
    return parts;
}

} // namespace

Result<Laryngoscopy> Laryngoscopy::of(const PatientModel& patient, const Blade& blade)
{
    return upperAirwayOf(partsOfThroat(patient), patient.landmarks())
        .map([&](UpperAirway&& airway) {
            Laryngoscopy made;
            made.m_patient = &patient;
            made.m_blade = blade;
            made.m_airway = std::move(airway);
            made.m_changed = made.m_airway;
            return made;
        });
}

void Laryngoscopy::changeAirway(const AirwayEvents& events, double inspiration)
{
    m_events = events;
    m_changes = airwayChanges(m_airway, events, inspiration);
    m_changed = changed(m_airway, m_changes);
    m_changed.mostOpening = mostMouthOpening(events, m_airway.size());
}

void Laryngoscopy::layHead(const HeadPosition& position)
{
    m_position = m_patient->neck(position).position();
}

AirwayAxes Laryngoscopy::axes() const
{
    const NeckField neck = m_patient->neck(m_position);
    return airwayAxes(bent(m_changed, neck), neck);
}

Vec3 Laryngoscopy::p_A_edge() const
{
    return m_patient->neck(m_position).placed(m_changed.p_A_edge());
}

FollowingThroat Laryngoscopy::throatIn(const LaryngoscopyPose& pose) const
{
    return m_patient->throat(pose.X_AJ, m_position);
}

LaryngoscopyPose Laryngoscopy::pose(LaryngoscopyStep step, Length lift) const
{
    const LaryngoscopyScript all = script();
    return laryngoscopyPose(m_changed, all.throat, m_blade, step, lift, all.held,
                            m_patient->neck(m_position));
}

LaryngoscopyPose Laryngoscopy::leveredPose(LaryngoscopyStep step, Angle angle) const
{
    LaryngoscopyPose pose = this->pose(step, {});
    const double share = liftShare(step);
    if (share == 0.0)
        return pose;
    pose.X_AL = levered(m_blade.form, pose.X_AL, p_A_edge(), share * angle);
    pose.field = tissueAt(pose.X_AL, throatIn(pose));
    return pose;
}

BladeEffort Laryngoscopy::effortAt(const RigidTransform& X_AL, const FollowingThroat& throat,
                                   LeveringWatch& watch) const
{
    return watch.take(followed(m_changed, throat), m_blade, X_AL, throat.neck.X_AU());
}

BladeEffort Laryngoscopy::effortIn(LaryngoscopyStep step, Length lift) const
{
    LeveringWatch watch;
    const LaryngoscopyPose at = pose(step, lift);
    return effortAt(at.X_AL, throatIn(at), watch);
}

/// From where nothing was turned.
BladeEffort Laryngoscopy::effortLevered(LaryngoscopyStep step, Angle angle) const
{
    constexpr int kSteps = 200;
    LeveringWatch watch;
    BladeEffort effort;
    for (int i = 0; i <= kSteps; ++i) {
        const LaryngoscopyPose at = leveredPose(step, double(i) / kSteps * angle);
        effort = effortAt(at.X_AL, throatIn(at), watch);
    }
    return effort;
}

/// What the mandible is moved by when the mouth shuts is the inverse of how it is held.
LaryngoscopyScript Laryngoscopy::script() const
{
    const FollowingThroat shut = m_patient->throat(RigidTransform{});
    return {
        .airway = m_airway, .throat = shut.field, .held = shut.X_AJ.inverse(), .blade = m_blade};
}

BladeField Laryngoscopy::tissueAt(const RigidTransform& X_AL, const FollowingThroat& throat) const
{
    return bladeInTissue(followed(m_changed, throat), m_blade, X_AL);
}

bool Laryngoscopy::isInMouth(const RigidTransform& X_AL, const FollowingThroat& throat) const
{
    return carina::isInMouth(followed(m_changed, throat), m_blade, X_AL);
}

GlotticLine Laryngoscopy::glottisAt(const FollowingThroat& throat, const BladeField& tissue) const
{
    const UpperAirway moved = followed(m_changed, throat);
    const auto drawn = [&tissue](const Vec3& p_A) {
        return Vec3{p_A + larynxTilt<double>(tissue.frame(), p_A).d};
    };
    return {drawn(moved.p_A_commissure), drawn(moved.p_A_notch)};
}

GlotticLine Laryngoscopy::glottisAt(const LaryngoscopyPose& pose) const
{
    return glottisAt(throatIn(pose), pose.field);
}

Vec3 Laryngoscopy::drawnAtLarynx(Vec3 p_A, const FollowingThroat& throat,
                                 const BladeField& tissue) const
{
    p_A += airwayPull<double>(m_changes.frame(), AirwayTissue::Larynx, p_A).d;
    p_A = throat.neck.placed(p_A);
    p_A += throatPull(throat, ThroatTissue::Airway, p_A).d;
    return p_A + larynxTilt<double>(tissue.frame(), p_A).d;
}

std::vector<ThroatContent> Laryngoscopy::contentsAt(const FollowingThroat& throat,
                                                    const BladeField& tissue) const
{
    std::vector<ThroatContent> contents = fluidsIn(bent(m_airway, throat.neck), m_events);
    for (ThroatContent fluid : valleculaFluidsIn(m_airway, m_events)) {
        fluid.p_AF = drawnAtLarynx(fluid.p_AF, throat, tissue);
        contents.push_back(fluid);
    }
    if (auto solid = foreignBodyIn(m_airway, m_events)) {
        solid->p_AF = drawnAtLarynx(solid->p_AF, throat, tissue);
        contents.push_back(*solid);
    }
    return contents;
}

std::vector<ThroatContent> Laryngoscopy::contentsAt(const LaryngoscopyPose& pose) const
{
    return contentsAt(throatIn(pose), pose.field);
}

RigidTransform Laryngoscopy::eyeAt(const LaryngoscopyPose& pose, ScopeEye eye) const
{
    if (eye == ScopeEye::Video)
        return pose.X_AL * cameraOnBlade(m_blade);
    const GlotticLine glottis = glottisAt(pose);
    return eyePastBlade(m_blade, pose.X_AL, p_A_edge(),
                        0.5 * (glottis.p_A_commissure + glottis.p_A_notch));
}

Angle Laryngoscopy::fieldOfView(ScopeEye eye)
{
    return eye == ScopeEye::Video ? kScopeFieldOfView : kDirectFieldOfView;
}

} // namespace carina
