#pragma once

#include "engine/geometry/fit/motion_covariance.h"

namespace carina
{

/// The error of a registration at all points as one matrix. For a small motion (w, v) of A's points
/// with covariance C (see Mat6) the mean squared error at p is
///
///     E |w x p + v|^2 = [p 1] Q [p 1]^T        Q = [ tr(C_ww) I - C_ww   c        ]
///                                                  [ c^T                 tr(C_vv) ]
///
/// with c = E[v x w]: the trace of pointCovariance, expanded. Points of equal error lie on
/// ellipsoids about the point of the smallest error.
///
/// @returns Q in A: [p 1] Q [p 1]^T in m^2 for p in metres; symmetric, and positive semidefinite
///          where the covariance is.
[[nodiscard]] Mat4 errorQuadric(const Mat6& covariance_A);

} // namespace carina
