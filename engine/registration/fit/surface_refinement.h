#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "engine/geometry/rigid_transform.h"

#include <span>
#include <vector>

namespace carina
{

/// The direction of a small motion of the anatomy: a rotation about the swab's centre, scaled by
/// the swab's extent, and a shift. Their squared lengths add up to 1.
struct SmallMotion {
    Vec3 turn_A = Vec3::Zero(); ///< along the axis of rotation
    Vec3 shift_A = Vec3::Zero();
};

/// A registration refined by points that were swabbed on a surface with the stylus.
struct SurfaceRefinement {
    RigidTransform X_AM;
    double startRms = 0.0; ///< RMS distance from the surface before, all points, metres
    double rms = 0.0; ///< RMS distance of the inliers after, metres; tells nothing about sliding
    int outliers = 0; ///< number of rejected points
    int iterations = 0;
    double moved = 0.0; ///< largest displacement of a swabbed point, metres
    /// Of a rotation (radians) about the swab's centre and a shift (metres), in axes of A; without
    /// the loose motions.
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
    Vec3 p_AC = Vec3::Zero(); ///< the swab's centre
    double extent = 0.0;      ///< RMS distance of the swab from its centre, metres
    /// Motions that the swab does not constrain, as the surface slides along itself. They keep the
    /// values of the registration by landmarks.
    std::vector<SmallMotion> loose{};

    /// RMS error at a point of the anatomy by this covariance, metres.
    [[nodiscard]] double uncertaintyAt(const Vec3& p_A) const;
};

/// The limits of a refinement.
struct RefinementSettings {
    Length farthestMove = millimetres(15.0); ///< largest allowed displacement of a swabbed point
    Length largestRms = millimetres(3.0);
    double mostOutliers = 0.15; ///< largest allowed share of rejected points
    int mostSteps = 100;
    /// A motion is loose where it moves the swab off the surface by less than this share of the
    /// swab's total (RMS) displacement.
    double leastHold = 0.07;
};

/// The smallest number of points for a refinement.
inline constexpr std::size_t kFewestSwabPoints = 20;

/// Refines a registration by points anywhere on a surface: iterative closest points (ICP, Besl and
/// McKay 1992) with point-to-plane steps (Chen and Medioni 1992). It reduces
///
///     sum_i min(d_i^2, limit^2),  d_i the distance of X_AM p_MQ_i from the surface
///
/// by Gauss-Newton steps, with d_i linearised along the line from the nearest point of the surface
/// to the swabbed point. The limit starts at twice farthestMove and decreases, by at most two
/// fifths per step, to three standard deviations as estimated from the median distance, but not
/// below 0.3 mm; points beyond it are rejected. The iteration ends when no step of a micrometre or
/// more reduces the sum.
///
/// The eigenvalues of the matrix
///
///     mean_i j_i j_i^T        j_i = (r_i x n_i / L, n_i)
///
/// tell how strongly the swab constrains each motion (Gelfand et al. 2003), with n_i the unit
/// direction of d_i, r_i from the swab's centre and L the RMS of |r_i|. The covariance is s^2 / n
/// times the inverse of this matrix, with s^2 the sum of d_i^2 of the n inliers divided by n - 6.
///
/// @param surface_A the surface that was swabbed, in A
/// @param p_MQ      positions of the tip on the surface, in M, metres
/// @param X_AM      registration by landmarks; the refinement converges to the minimum next to it
/// @returns TooFewPoints below kFewestSwabPoints; NotFinite for NaN or infinity and OutOfRange for
///          a kilometre or more in a point; NoSurfaceFit for an empty surface, where no point lies
///          within twice farthestMove of it, where the limits of the settings are exceeded, or
///          where the iteration does not converge.
[[nodiscard]] Result<SurfaceRefinement> refineOnSurface(const SurfaceTree& surface_A,
                                                        std::span<const Vec3> p_MQ,
                                                        const RigidTransform& X_AM,
                                                        const RefinementSettings& settings = {});

} // namespace carina
