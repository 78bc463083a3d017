#include "ui/scene/lifted_figures.h"

#include "models/objects/object_words.h"
#include "ui/scene/scene_parts.h"

#include <utility>

namespace carina
{
namespace
{

/// Above the ids of the parts of people.
constexpr std::uint16_t kFirstLiftedId = 0xf000;
/// The second tube lies this far to the patient's left of the first.
const Vec3 kBesidePatient{0.2, 0.0, 0.0};

/// The body whose frame is that of the object.
std::string bodyOfLifted(ObjectId object) { return "lifted " + std::to_string(object.value); }
/// The body of the second tube's surfaces, in the frame of a connector.
std::string bodyOfTube(ObjectId object) { return "tube " + std::to_string(object.value); }

/// What moves an object by its actions, about a centre.
PlacedBody motionAbout(const Vec3& centre, const ActedPose& acted)
{
    const PlacedBody turned{RigidTransform{acted.X_AO.rotation(), acted.X_AO.translation()},
                            acted.scale};
    return PlacedBody{RigidTransform::translation(centre)} * turned
           * PlacedBody{RigidTransform::translation(-centre)};
}

PlacedBody inverse(const PlacedBody& placed)
{
    const RigidTransform back = placed.X_AF.inverse();
    return {RigidTransform{back.rotation(), back.translation() / placed.scale}, 1.0 / placed.scale};
}

void liftGroup(SceneFrame& frame, const LiftedObject& lifted, const Vec3& centre_V,
               const PlacedBody& patient)
{
    const PlacedBody motion_V = motionAbout(centre_V, lifted.acted);
    frame.lifted[groupName(*lifted.group)] = patient * motion_V * inverse(patient);
    frame.bodies[bodyOfLifted(lifted.object)] =
        patient * motion_V * PlacedBody{RigidTransform::translation(centre_V)};
}

void liftTube(SceneFrame& frame, const LiftedObject& lifted, const PatientModel& patient)
{
    const RigidTransform& X_AE = patient.tube().X_AE;
    const RigidTransform X_AE_beside{X_AE.rotation(), X_AE.translation() + kBesidePatient};
    const Vec3 centre_A = X_AE_beside * patient.tubeCentre();
    const PlacedBody motion_A = motionAbout(centre_A, lifted.acted);
    frame.bodies[bodyOfTube(lifted.object)] = motion_A * PlacedBody{X_AE_beside};
    frame.bodies[bodyOfLifted(lifted.object)] =
        motion_A * PlacedBody{RigidTransform::translation(centre_A)};
}

} // namespace

std::vector<DrawnLift> drawnLifts(const StationMoment& moment, const PatientModel& patient)
{
    std::vector<DrawnLift> lifts;
    for (const LiftedObject& lifted : moment.lifted)
        if (!lifted.group || patient.centreOf(*lifted.group))
            lifts.push_back({lifted.object, lifted.group, liftedWord(lifted)});
    return lifts;
}

std::vector<SceneFigure> liftedFigures(const std::vector<DrawnLift>& lifts,
                                       const PatientModel& patient)
{
    std::vector<SceneFigure> figures;
    std::uint16_t nextId = kFirstLiftedId;
    for (const DrawnLift& lift : lifts) {
        figures.push_back({.body = bodyOfLifted(lift.object), .name = lift.name});
        if (lift.group)
            continue;
        figures.back().parts = tubeParts(patient, bodyOfTube(lift.object), nextId);
        nextId += std::uint16_t(figures.back().parts.size());
    }
    return figures;
}

void addLifted(SceneFrame& frame, const StationMoment& moment, const PatientModel& patient)
{
    const PlacedBody X_AV = frame.bodies.at(kPatientBody);
    for (const LiftedObject& lifted : moment.lifted) {
        const auto centre = lifted.group ? patient.centreOf(*lifted.group) : std::nullopt;
        if (!lifted.group)
            liftTube(frame, lifted, patient);
        else if (centre)
            liftGroup(frame, lifted, *centre, X_AV);
    }
}

std::vector<LiftedInFrame> liftedIn(const SceneFrame& frame, const StationMoment& moment)
{
    std::vector<LiftedInFrame> all;
    for (const LiftedObject& lifted : moment.lifted)
        if (const auto body = frame.bodies.find(bodyOfLifted(lifted.object));
            body != frame.bodies.end())
            all.push_back({lifted.object, lifted.owner, lifted.group, body->second});
    return all;
}

} // namespace carina
