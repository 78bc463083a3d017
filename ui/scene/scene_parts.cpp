#include "ui/scene/scene_parts.h"

#include "widgets/scene/look/appearance.h"

namespace carina
{
namespace
{

constexpr const char* kMandible = "mandible";
constexpr const char* kMeasuredTube = "measured tube";
/// Below those of what lies in a throat, and far above those of people.
constexpr std::uint16_t kFirstIdOfMeasured = 0xd000;

std::string bodyOf(const PatientSurface& surface)
{
    switch (surface.body) {
    case SurfaceBody::Anatomy:
        return kPatientBody;
    case SurfaceBody::Mandible:
        return kMandible;
    case SurfaceBody::Tube:
        return surface.name == kInflatedCuff ? kCuffBody : kTubeBody;
    }
    return {};
}

/// Views show what intubation is about: head, airway and lungs.
bool isFramed(const PatientSurface& surface)
{
    if (surface.body == SurfaceBody::Tube)
        return false;
    switch (surface.description.role) {
    case PartRole::Spine:
    case PartRole::Rib:
    case PartRole::Diaphragm:
    case PartRole::Oesophagus:
    case PartRole::Heart:
    case PartRole::Vessel:
    case PartRole::Muscle:
    case PartRole::Skin:
    case PartRole::Other:
        return false;
    default:
        return true;
    }
}

/// What is fixed to the lower jaw goes with it alone.
ChestRegion drawnRegionOf(const PatientSurface& surface)
{
    const ChestRegion region = regionOf(surface.description);
    return surface.body == SurfaceBody::Mandible && region == ChestRegion::Teeth
               ? ChestRegion::Still
               : region;
}

/// A clear tube with dark marks, a bluish cuff and a white connector, as they are sold.
Appearance tubeAppearance(const std::string& piece)
{
    if (piece == "Depth marks")
        return {MaterialGroup::Tool, {28, 32, 44}};
    if (piece == "Cuff" || piece == kInflatedCuff)
        return {MaterialGroup::Tool, {112, 176, 216}};
    if (piece == "Connector")
        return {MaterialGroup::Tool, {238, 240, 242}};
    return {MaterialGroup::Tool, {217, 225, 150}};
}

/// Where something with the pose X_VF in the patient is drawn while the patient is at X_AV.
PlacedBody inPatient(const ActedPose& patient, const RigidTransform& X_VF)
{
    const RigidTransform X_VF_scaled{X_VF.rotation(), patient.scale * X_VF.translation()};
    return {patient.X_AO * X_VF_scaled, patient.scale};
}

} // namespace

std::vector<ScenePart> sceneParts(const PatientModel& patient)
{
    std::vector<ScenePart> parts;
    for (const PatientSurface& surface : patient.surfaces()) {
        const Appearance look = surface.body == SurfaceBody::Tube
                                    ? tubeAppearance(surface.name)
                                    : appearanceOf(surface.description);
        parts.push_back({.name = surface.name,
                         .id = static_cast<std::uint16_t>(parts.size() + 1),
                         .group = look.group,
                         .color = look.color,
                         .listedUnder = surface.body == SurfaceBody::Tube
                                            ? BodyRegion::Tools
                                            : bodyRegionOf(surface.description.role),
                         .region = drawnRegionOf(surface),
                         .body = bodyOf(surface),
                         .liftedWith = surface.body == SurfaceBody::Tube
                                           ? ""
                                           : groupName(groupOf(surface.description.role)),
                         .framed = isFramed(surface),
                         .levels = surface.levels,
                         .deviations = surface.description.deviations,
                         .colors = surface.description.colors,
                         .sharesLevel = lungSide(surface.description.role).has_value()});
    }
    return parts;
}

std::vector<ScenePart> tubeParts(const PatientModel& patient, const std::string& body,
                                 std::uint16_t firstId)
{
    std::vector<ScenePart> parts;
    for (ScenePart part : sceneParts(patient))
        if (part.body == kTubeBody) {
            part.id = static_cast<std::uint16_t>(firstId + parts.size());
            part.body = body;
            parts.push_back(std::move(part));
        }
    return parts;
}

void bendTube(SceneFrame& frame, const PatientModel& patient, const std::string& body)
{
    if (!patient.tube().fitsAirway)
        return;
    frame.bentInPlace[body] = patient.tube().X_AE;
    if (body == kTubeBody)
        frame.bentInPlace[kCuffBody] = patient.tube().X_AE;
}

SceneFigure measuredTubeFigure(const PatientModel& patient)
{
    SceneFigure figure{.body = kMeasuredTube,
                       .name = {},
                       .parts = tubeParts(patient, kMeasuredTube, kFirstIdOfMeasured)};
    for (ScenePart& part : figure.parts)
        part.group = MaterialGroup::Ghost;
    return figure;
}

void addMeasuredTube(SceneFrame& frame, const PatientModel& patient)
{
    frame.bodies[kMeasuredTube] = frame.bodies.at(kTubeBody);
    if (frame.throat.neck.isBent())
        frame.bentAlong[kMeasuredTube] = std::make_shared<const LineBend>(
            patient.tube().p_E_centre, centreIn(frame.throat.neck, patient.tube()));
}

SceneFrame sceneFrame(const StationMoment& moment, const ChestField& chest,
                      const FollowingThroat& throat)
{
    SceneFrame frame;
    frame.time = moment.time;
    frame.chest.field = chest;
    for (std::size_t region = 0; region < kChestRegions; ++region)
        frame.chest.motion[region] = motionOf(static_cast<ChestRegion>(region), moment.pose, chest);
    const ActedPose patient = moment.patient ? moment.patient->acted : ActedPose{};
    frame.bodies[kPatientBody] = inPatient(patient, {});
    frame.throat = throat;
    frame.bends = kPatientBody;
    frame.bodies[kMandible] = inPatient(patient, throat.neck.X_AU() * throat.X_AJ);
    if (moment.tube && moment.tube->validity != Validity::Lost)
        frame.bodies[kTubeBody] = moment.tube->X_FO;
    if (frame.bodies.contains(kTubeBody) && moment.isCuffInflated)
        frame.bodies[kCuffBody] = frame.bodies.at(kTubeBody);
    return frame;
}

} // namespace carina
