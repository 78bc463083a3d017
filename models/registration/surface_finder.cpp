#include "models/registration/surface_finder.h"

#include "engine/geometry/mesh/surface_feature.h"
#include "engine/geometry/mesh/surface_query.h"

#include <algorithm>

namespace carina
{
namespace
{

/// Whether a ray stays outside the ball around a box.
bool passesBy(const Box& box, const Vec3& p_eye, const Vec3& dir)
{
    const Vec3 towards = box.centre() - p_eye;
    return towards.cross(dir.normalized()).norm() > 0.5 * box.size().norm();
}

} // namespace

SurfaceFinder::SurfaceFinder(const PatientModel& patient)
{
    for (const PatientSurface& surface : patient.surfaces()) {
        if (surface.body == SurfaceBody::Tube || surface.description.role == PartRole::Skin)
            continue;
        auto mesh = patient.shutMesh(surface);
        const Box bounds = boundsOf(*mesh);
        m_surfaces.push_back({&surface.name, std::move(mesh), bounds, std::nullopt});
    }
}

std::optional<SurfaceFinder::Found> SurfaceFinder::nearest(const Vec3& p_AQ) const
{
    std::optional<Found> found;
    for (const Surface& surface : m_surfaces) {
        if (found && distanceTo(surface.bounds, p_AQ) >= found->distance)
            continue;
        const double distance = treeOf(surface).distanceTo(p_AQ);
        if (!found || distance < found->distance)
            found = Found{*surface.name, distance};
    }
    return found;
}

std::optional<SurfaceFinder::Found> SurfaceFinder::along(const Vec3& p_A_eye,
                                                         const Vec3& dir_A) const
{
    std::optional<Found> found;
    for (const Surface& surface : m_surfaces) {
        if (passesBy(surface.bounds, p_A_eye, dir_A))
            continue;
        const auto hit = rayHit(*surface.mesh, p_A_eye, dir_A.normalized());
        if (hit && (!found || *hit < found->distance))
            found = Found{*surface.name, *hit};
    }
    return found;
}

std::optional<Vec3> SurfaceFinder::picked(const Vec3& p_A_eye, const Vec3& dir_A, bool snaps) const
{
    const auto hit = along(p_A_eye, dir_A);
    if (!hit)
        return std::nullopt;
    const Vec3 p_AQ = p_A_eye + hit->distance * dir_A.normalized();
    if (!snaps)
        return p_AQ;
    const auto surface =
        std::ranges::find(m_surfaces, hit->name, [](const Surface& each) { return *each.name; });
    for (const SurfaceFeature kind : {SurfaceFeature::Tip, SurfaceFeature::Ridge})
        if (const auto feature = nearestFeature(*surface->mesh, p_AQ, kind))
            return feature->p;
    return p_AQ;
}

const SurfaceTree* SurfaceFinder::surface(const std::string& name) const
{
    const auto found =
        std::ranges::find(m_surfaces, name, [](const Surface& each) { return *each.name; });
    return found == m_surfaces.end() ? nullptr : &treeOf(*found);
}

const SurfaceTree& SurfaceFinder::treeOf(const Surface& surface) const
{
    if (!surface.tree)
        surface.tree.emplace(*surface.mesh);
    return *surface.tree;
}

} // namespace carina
