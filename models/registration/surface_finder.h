#pragma once

#include "engine/geometry/mesh/surface_tree.h"
#include "models/patient/patient_model.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// Where a patient's surfaces are, at rest and with the mouth closed. The skin is looked through,
/// for landmarks are told by what it covers.
class SurfaceFinder
{
public:
    /// A surface, and how far away it is.
    struct Found {
        std::string name;
        double distance = 0.0; ///< metres
    };

    /// @pre patient outlives this.
    explicit SurfaceFinder(const PatientModel& patient);

    /// The surface nearest to a point; nothing for a patient without surfaces.
    [[nodiscard]] std::optional<Found> nearest(const Vec3& p_AQ) const;

    /// The first surface along a ray, its distance in metres; nothing where the ray meets none.
    [[nodiscard]] std::optional<Found> along(const Vec3& p_A_eye, const Vec3& dir_A) const;

    /// The place that a click means: where the ray first meets a surface, or of this surface the
    /// nearest tip, or else ridge, that a finger finds there.
    [[nodiscard]] std::optional<Vec3> picked(const Vec3& p_A_eye, const Vec3& dir_A,
                                             bool snaps) const;

    /// The surface of a name; nothing where there is none.
    [[nodiscard]] const SurfaceTree* surface(const std::string& name) const;

private:
    struct Surface {
        const std::string* name;
        std::shared_ptr<const TriangleMesh> mesh;
        Box bounds;
        mutable std::optional<SurfaceTree> tree; ///< once it was asked for the first time
    };

    [[nodiscard]] const SurfaceTree& treeOf(const Surface& surface) const;

    std::vector<Surface> m_surfaces;
};

} // namespace carina
