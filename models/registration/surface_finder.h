#pragma once

#include "engine/geometry/mesh/surface_tree.h"
#include "models/patient/patient_model.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// Finds points on a patient's surfaces, at rest and with the mouth closed. The skin and the tube
/// are ignored: landmarks are defined on the structures under the skin.
class SurfaceFinder
{
public:
    /// A surface and its distance.
    struct Found {
        std::string name;
        double distance = 0.0; ///< metres
    };

    /// @pre patient outlives this.
    explicit SurfaceFinder(const PatientModel& patient);

    /// The surface nearest to a point; std::nullopt for a patient without surfaces.
    [[nodiscard]] std::optional<Found> nearest(const Vec3& p_AQ) const;

    /// The first surface along a ray; std::nullopt if the ray meets none.
    [[nodiscard]] std::optional<Found> along(const Vec3& p_A_eye, const Vec3& dir_A) const;

    /// The point selected by a click: where the ray first meets a surface or, if `snaps`, the
    /// nearest tip, or else ridge, of that surface.
    [[nodiscard]] std::optional<Vec3> picked(const Vec3& p_A_eye, const Vec3& dir_A,
                                             bool snaps) const;

    /// The surface of this name; null if there is none.
    [[nodiscard]] const SurfaceTree* surface(const std::string& name) const;

private:
    struct Surface {
        const std::string* name;
        std::shared_ptr<const TriangleMesh> mesh;
        Box bounds;
        mutable std::optional<SurfaceTree> tree; ///< built at first use
    };

    [[nodiscard]] const SurfaceTree& treeOf(const Surface& surface) const;

    std::vector<Surface> m_surfaces;
};

} // namespace carina
