#include "models/surface_finder.h"

#include "engine/geometry/surface_query.h"

namespace carina
{

SurfaceFinder::SurfaceFinder(const PatientModel& patient)
{
    for (const PatientSurface& surface : patient.surfaces()) {
        const TriangleMesh& finest = *surface.levels.front();
        if (surface.body != SurfaceBody::Tube && surface.description.role != PartRole::Skin)
            m_surfaces.push_back({&surface.name, &finest, boundsOf(finest)});
    }
}

std::optional<SurfaceFinder::Found> SurfaceFinder::nearest(const Vec3& p_AQ) const
{
    std::optional<Found> found;
    for (const Surface& surface : m_surfaces) {
        if (found && distanceTo(surface.bounds, p_AQ) >= found->distance)
            continue;
        const double distance = distanceTo(*surface.mesh, p_AQ);
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
        const auto hit = rayHit(*surface.mesh, p_A_eye, dir_A.normalized());
        if (hit && (!found || *hit < found->distance))
            found = Found{*surface.name, *hit};
    }
    return found;
}

} // namespace carina
