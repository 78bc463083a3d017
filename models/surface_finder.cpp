#include "models/surface_finder.h"

#include "engine/geometry/surface_query.h"

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
        const TriangleMesh& finest = *surface.levels.front();
        if (surface.body != SurfaceBody::Tube && surface.description.role != PartRole::Skin)
            m_surfaces.push_back({&surface.name, &finest, boundsOf(finest), std::nullopt});
    }
}

std::optional<SurfaceFinder::Found> SurfaceFinder::nearest(const Vec3& p_AQ) const
{
    std::optional<Found> found;
    for (const Surface& surface : m_surfaces) {
        if (found && distanceTo(surface.bounds, p_AQ) >= found->distance)
            continue;
        if (!surface.tree)
            surface.tree.emplace(*surface.mesh);
        const double distance = surface.tree->distanceTo(p_AQ);
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

} // namespace carina
