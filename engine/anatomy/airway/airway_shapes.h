#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/anatomy/shapes/implicit_shape.h"
#include "engine/geometry/rigid_transform.h"

#include <array>

namespace carina
{

/// X_AW of the trachea's frame W: origin at the carina, +x as in A, +z up the trachea's axis, +y to
/// its back. The trachea leans forward by 12 degrees on its way up.
[[nodiscard]] RigidTransform windpipeInAnatomy();

/// A tapered rod in W, metres.
struct AirwayRod {
    Vec3 p_W_from;
    Vec3 p_W_to;
    double radiusFrom = 0.0;
    double radiusTo = 0.0;
};

/// The trachea, both main bronchi and their lobar branches as one solid, and its three parts.
///
/// The medial walls of the two main bronchi meet at the origin, the carina. There the solid is
/// divided by a plane perpendicular to each bronchus, so that the parts meet without overlap or
/// gap, and the trachea reaches exactly down to the carina.
class AirwaySolid
{
public:
    explicit AirwaySolid(const PatientDimensions& dimensions);

    /// The trachea in A, with protruding C-shaped cartilages and a flat posterior wall: a tube with
    /// an open upper end, so that its rings are seen from the larynx. Below the cricoid it widens
    /// (UpperTrachea).
    [[nodiscard]] ImplicitShape trachea() const;
    /// A main bronchus with its lobar branches, in A.
    [[nodiscard]] ImplicitShape bronchus(Side side) const;

    /// The main bronchus of a side and its branches, in W. Right: to the upper lobe, the
    /// intermediate bronchus down to the lower lobe, and to the middle lobe. Left: to the upper
    /// lobe, to the lower lobe, and to the lingula.
    [[nodiscard]] const std::array<AirwayRod, 4>& rods(Side side) const
    {
        return side == Side::Right ? m_right.rods : m_left.rods;
    }

    /// Signed distance to the trachea and both main bronchi without lobar branches, metres: the
    /// region that the lungs leave free.
    [[nodiscard]] double outsideLungs(const Vec3& p_A) const;

private:
    /// 0 at the upper end of the trachea, 1 where it is as wide as its dimensions say.
    [[nodiscard]] double belowUpperEnd(double z) const;
    /// How much deeper it is at a height than at its upper end, metres.
    [[nodiscard]] double deeperAt(double z) const;
    [[nodiscard]] double tracheaDistance(const Vec3& p_WQ) const;
    [[nodiscard]] double bronchusDistance(Side side, const Vec3& p_WQ) const;
    [[nodiscard]] double wholeDistance(const Vec3& p_WQ) const;
    /// Below zero in the air of the trachea, which is open towards the larynx.
    [[nodiscard]] double lumenDistance(const Vec3& p_WQ) const;
    /// Below zero where the solid belongs to the bronchus of that side.
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
    double m_scale; ///< this trachea's length over the adult's: scales sizes without an own figure
    Branches m_right;
    Branches m_left;
};

} // namespace carina
