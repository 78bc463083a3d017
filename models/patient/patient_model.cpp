#include "models/patient/patient_model.h"

#include "engine/anatomy/airway/jaw_reach.h"
#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/events/mouth_opening.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/lungs/drawing/chest_drawing.h"

#include <algorithm>
#include <iterator>

namespace carina
{
namespace
{

std::shared_ptr<const TriangleMesh> shared(TriangleMesh mesh)
{
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

bool isIdentity(const RigidTransform& X)
{
    return X.translation().isZero(0.0) && X.rotation().vec().isZero(0.0);
}

TriangleMesh moved(TriangleMesh mesh, const RigidTransform& X)
{
    for (Vec3f& p : mesh.positions)
        p = (X * p.cast<double>()).cast<float>();
    for (Vec3f& n : mesh.normals)
        n = (X.rotation() * n.cast<double>()).cast<float>();
    return mesh;
}

AnatomyPart withoutMeshes(const AnatomyPart& part)
{
    return {.name = part.name,
            .role = part.role,
            .conceptId = part.conceptId,
            .levels = {},
            .deviations = part.deviations,
            .colors = part.colors};
}

} // namespace

Result<PatientModel> PatientModel::of(Anatomy anatomy, Length innerDiameter)
{
    auto lungs = LungPair::of(anatomy);
    if (!lungs)
        return tl::unexpected(lungs.error());
    auto tube = makeTube(innerDiameter, anatomy.landmarks.path_A, anatomy.landmarks.p_A_incisors,
                         usualTipAboveCarina(innerDiameter));
    if (!tube)
        return tl::unexpected(tube.error());
    PatientModel model;
    model.m_name = std::move(anatomy.name);
    model.m_heldJaw = heldJaw(anatomy.contentHash);
    model.m_contentHash = std::move(anatomy.contentHash);
    model.m_landmarks = std::move(anatomy.landmarks);
    model.m_throat = {model.m_landmarks.p_A_carina, model.m_landmarks.p_A_glottis,
                      model.m_landmarks.p_A_incisors};
    model.m_attributions = std::move(anatomy.attributions);
    model.m_lungs = std::make_shared<const LungPair>(std::move(*lungs));
    model.m_tube = std::move(*tube);
    model.addAnatomy(std::move(anatomy.parts));
    model.addTube();
    model.m_ownTube = model.m_tube;
    return model;
}

double PatientModel::size() const
{
    return (m_landmarks.p_A_glottis - m_landmarks.p_A_incisors).norm() / kReferenceWay.si;
}

bool PatientModel::reachesJaw(const RigidTransform& X_AJ) const
{
    return isInReachOfJaw(X_AJ, m_landmarks.p_A_incisors, size());
}

FollowingThroat PatientModel::throat(const std::optional<RigidTransform>& X_AJ,
                                     const HeadPosition& position, const AirwayEvents& events) const
{
    const auto most = mostMouthOpening(events, size());
    const bool isMeasured = X_AJ && reachesJaw(*X_AJ);
    if (!isMeasured && !most)
        return {m_throat, {}, neck(position)};
    const RigidTransform held = isMeasured ? *X_AJ : m_heldJaw;
    const RigidTransform within =
        most ? withinOpening(held, m_landmarks.p_A_incisors, *most) : held;
    return {m_throat, within * m_heldJaw.inverse(), neck(position)};
}

std::shared_ptr<const TriangleMesh> PatientModel::shutMesh(const PatientSurface& surface) const
{
    const TriangleMesh& finest = *surface.levels.front();
    const FollowingThroat shut = throat(RigidTransform{});
    if (surface.body == SurfaceBody::Mandible)
        return shared(moved(finest, shut.X_AJ));
    const auto tissue = tissueOf(regionOf(surface.description));
    if (surface.body != SurfaceBody::Anatomy || !tissue || isIdentity(shut.X_AJ))
        return surface.levels.front();
    return shared(deformed(finest, shut, *tissue));
}

Box PatientModel::reach() const
{
    constexpr double kFullest = 2.1; // of the gas at rest: 1.77 of it, and a breath
    constexpr double kRibShare = 0.4;
    ChestShape full{.lungs = {}, .mediastinalShift = {}, .ribShare = kRibShare};
    for (const Side side : {Side::Right, Side::Left}) {
        const Volume rest = m_lungs->restVolume(side);
        full.lungs[indexOf(side)] = {kFullest * rest, rest, kFullest * rest};
    }
    const std::size_t coarsest = std::max<std::size_t>(1, m_lungs->levelCount()) - 1;
    const ChestPose pose = drawnPose(*m_lungs, full, coarsest);
    Box reach;
    for (const BreathingPart& part : m_lungs->parts())
        reach.include(boundsOf(deformed(part.levels.back(), m_lungs->field(),
                                        motionOf(part.region, pose, m_lungs->field()))));
    if (!reach.empty())
        reach.max.z() = std::max(reach.max.z(), top());
    return reach;
}

std::vector<OrganGroup> PatientModel::groups() const
{
    std::vector<OrganGroup> groups;
    for (const auto& [group, bounds] : m_groups)
        groups.push_back(group);
    return groups;
}

std::optional<Vec3> PatientModel::centreOf(OrganGroup group) const
{
    const auto found = m_groups.find(group);
    return found == m_groups.end() ? std::nullopt : std::optional{found->second.centre()};
}

PatientModel PatientModel::withTube(std::span<const Vec3> p_E_centre, Length outerDiameter) const
{
    PatientModel model = *this;
    model.m_tube = tubeAlong(m_tube, p_E_centre, outerDiameter);
    model.takeTubeAway();
    model.addTube();
    return model;
}

PatientModel PatientModel::withTubeOf(const PatientModel& other) const
{
    PatientModel model = *this;
    model.takeTubeAway();
    model.m_tube = other.m_tube;
    model.m_ownTube = other.m_ownTube;
    model.m_tubeBounds = other.m_tubeBounds;
    std::ranges::copy_if(
        other.m_surfaces, std::back_inserter(model.m_surfaces),
        [](const PatientSurface& surface) { return surface.body == SurfaceBody::Tube; });
    return model;
}

double PatientModel::top() const
{
    Box all;
    for (const PatientSurface& surface : m_surfaces)
        if (surface.body != SurfaceBody::Tube)
            all.include(boundsOf(*surface.levels.back()));
    return all.max.z();
}

void PatientModel::addAnatomy(std::vector<AnatomyPart> parts)
{
    for (AnatomyPart& part : parts) {
        PatientSurface surface{.name = part.name, .description = withoutMeshes(part), .levels = {}};
        if (movesWithMandible(part))
            surface.body = SurfaceBody::Mandible;
        if (!lungSide(part.role))
            for (TriangleMesh& level : part.levels)
                surface.levels.push_back(shared(std::move(level)));
        m_surfaces.push_back(std::move(surface));
    }
    for (const BreathingPart& breathing : m_lungs->parts())
        for (const TriangleMesh& level : breathing.levels)
            m_surfaces[breathing.index].levels.emplace_back(m_lungs, &level);
    for (const PatientSurface& surface : m_surfaces)
        m_groups[groupOf(surface.description.role)].include(boundsOf(*surface.levels.front()));
}

void PatientModel::takeTubeAway()
{
    std::erase_if(m_surfaces,
                  [](const PatientSurface& surface) { return surface.body == SurfaceBody::Tube; });
    m_tubeBounds = {};
}

void PatientModel::addTube()
{
    for (const TubePiece& piece : m_tube.pieces)
        m_tubeBounds.include(boundsOf(piece.mesh));
    for (TubePiece& piece : m_tube.pieces)
        m_surfaces.push_back({.name = piece.name,
                              .description = {.name = piece.name, .conceptId = {}, .levels = {}},
                              .body = SurfaceBody::Tube,
                              .levels = {shared(std::move(piece.mesh))}});
    m_tube.pieces.clear(); // they are surfaces now
}

} // namespace carina
