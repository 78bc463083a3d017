#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "engine/geometry/rigid_transform.h"

#include <span>
#include <vector>

namespace carina
{

/// A small motion of the anatomy: shares of a turn about the swab's centre and of a shift, as the
/// RMS ways that they move the swab by. Their squares add up to 1.
struct SmallMotion {
    Vec3 turn_A = Vec3::Zero(); ///< along the axis of the turn
    Vec3 shift_A = Vec3::Zero();
};

/// A registration brought nearer to a surface that was swabbed with the stylus.
struct SurfaceRefinement {
    RigidTransform X_AM;
    double startRms = 0.0; ///< of the distances from the surface before, metres
    double rms = 0.0;      ///< of those that count, after; says nothing about motions along it
    int outliers = 0;      ///< points left out
    int iterations = 0;
    double moved = 0.0; ///< the longest way that a point of the swab went, metres
    /// Of a turn in radians and a shift in metres, in axes of A, about the swab's centre; without
    /// the loose motions.
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
    Vec3 p_AC = Vec3::Zero(); ///< the swab's centre
    double extent = 0.0;      ///< RMS distance of the swab from its centre, metres
    /// Motions that the swab does not hold: the surface slides along itself. They were left as the
    /// landmarks had them.
    std::vector<SmallMotion> loose{};

    /// RMS error that the covariance makes at a point of the anatomy, metres.
    [[nodiscard]] double uncertaintyAt(const Vec3& p_A) const;
};

struct RefinementSettings {
    Length farthestMove = millimetres(15.0); ///< that a point of the swab may go
    Length largestRms = millimetres(3.0);
    double mostOutliers = 0.15; ///< share of the points that may be left out
    int mostSteps = 100;
    /// A motion that moves the swab by 1 mm (RMS) and off the surface by less than this share of
    /// it is loose.
    double leastHold = 0.07;
};

inline constexpr std::size_t kFewestSwabPoints = 20;

/// Refines a registration by points anywhere on a surface: iterated closest points (Besl and McKay
/// 1992) with the steps of Chen and Medioni (1992). It lessens
///
///     sum_i min(d_i^2, limit^2),  d_i the distance of X_AM p_MQ_i from the surface
///
/// by Gauss-Newton steps, where d_i grows along the line from the nearest point of the surface to
/// the swabbed one. The limit begins with twice the farthest move and narrows, by two fifths in a
/// step, to three standard deviations as the median distance tells them; a point beyond it does not
/// count. It ends where no step of a micrometre lessens the sum.
///
/// How well a motion is held is the eigenvalue of mean_i j_i j_i^T, j_i = (r_i x n_i / L, n_i),
/// with r_i from the swab's centre and L the RMS of |r_i| (Gelfand et al. 2003). The covariance is
/// s^2 / n of its inverse, s^2 = sum of the d_i^2 that count / (n - 6).
///
/// @param surface_A the surface that was swabbed, in A
/// @param p_MQ      the tip on the swab, in M, metres
/// @param X_AM      from landmarks: the refinement finds the nearest way to the surface, no other
/// @returns TooFewPoints below kFewestSwabPoints; NotFinite for NaN or infinity and OutOfRange for
///          a kilometre or more in a point; NoSurfaceFit for an empty surface, where no point lies
///          within twice the farthest move of it, and where the points would move too far, do not
///          come near enough or leave out too many, or keep on moving.
[[nodiscard]] Result<SurfaceRefinement> refineOnSurface(const SurfaceTree& surface_A,
                                                        std::span<const Vec3> p_MQ,
                                                        const RigidTransform& X_AM,
                                                        const RefinementSettings& settings = {});

} // namespace carina
