#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/anatomy/shapes/implicit_shape.h"
#include "engine/geometry/rigid_transform.h"

#include <array>

namespace carina
{

/// The windpipe's frame W in A: origin at the carina, +x as in A, +z up the trachea's axis and +y
/// to its back. The trachea leans 12 degrees forward on its way up.
[[nodiscard]] RigidTransform windpipeInAnatomy();

/// A rod that tapers, in W, metres.
struct AirwayRod {
    Vec3 p_W_from;
    Vec3 p_W_to;
    double radiusFrom = 0.0;
    double radiusTo = 0.0;
};

/// The trachea, both main bronchi and their lobar branches as one solid, and its parts.
///
/// The inner walls of the two main bronchi meet at the origin, the carina. There each part ends in
/// a plane square to its bronchus, so that the parts meet without overlap or gap and the trachea
/// reaches down to exactly the carina.
class AirwaySolid
{
public:
    explicit AirwaySolid(const PatientDimensions& dimensions);

    /// C-shaped cartilages stand out between the gaps; the back wall is flat.
    [[nodiscard]] ImplicitShape trachea() const;
    /// A main bronchus with its lobar branches.
    [[nodiscard]] ImplicitShape bronchus(Side side) const;

    /// The main bronchus of a side and its branches, in W: right the upper lobe's, the intermediate
    /// bronchus down to the lower lobe, and the middle lobe's; left the upper lobe's, the lower
    /// lobe's, and the lingula's.
    [[nodiscard]] const std::array<AirwayRod, 4>& rods(Side side) const
    {
        return side == Side::Right ? m_right.rods : m_left.rods;
    }

    /// Distance in A to the trachea and both main bronchi without lobar branches: where no lung is.
    [[nodiscard]] double outsideLungs(const Vec3& p_A) const;

private:
    [[nodiscard]] double tracheaDistance(const Vec3& p_WQ) const;
    [[nodiscard]] double bronchusDistance(Side side, const Vec3& p_WQ) const;
    [[nodiscard]] double wholeDistance(const Vec3& p_WQ) const;
    /// Below zero where the solid belongs to that bronchus and not to the trachea.
    [[nodiscard]] double territory(Side side, const Vec3& p_WQ) const;

    struct Branches {
        Vec3 direction_W;              ///< of the main bronchus, away from the carina
        std::array<AirwayRod, 4> rods; ///< the main bronchus first
    };
    [[nodiscard]] Branches branchesOf(Side side) const;
    [[nodiscard]] Box boundsInA(const Box& bounds_W) const;

    PatientDimensions m_dimensions;
    RigidTransform m_X_AW;
    RigidTransform m_X_WA;
    double m_scale; ///< of this trachea's length to the adult's: for what has no figure of its own
    Branches m_right;
    Branches m_left;
};

} // namespace carina
