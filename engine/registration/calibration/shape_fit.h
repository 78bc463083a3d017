#pragma once

#include "engine/core/result.h"

#include <Eigen/Core>

#include <functional>

namespace carina
{

/// The least-squares fit of a shape with a few parameters.
struct ShapeFit {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
    /// (J^T J)^-1 with J the derivatives of the residuals: times the variance of a residual, the
    /// covariance of the parameters.
    Eigen::MatrixXd spread;

    /// Residuals less parameters: the degrees of freedom of a variance estimated from them.
    [[nodiscard]] double degrees() const
    {
        return double(residuals.size()) - double(parameters.size());
    }
    /// The variance of a residual, estimated from all. @pre degrees() is above 0.
    [[nodiscard]] double variance() const { return residuals.squaredNorm() / degrees(); }
};

using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd& parameters)>;

/// Minimises the sum of the squared residuals from a start, by Gauss-Newton steps that are halved
/// until they lessen it. The derivatives are central differences over 1 micrometre and microradian.
///
/// @returns NotFinite where a residual at the start is not finite; DegenerateLandmarks where the
///          residuals do not determine the parameters.
[[nodiscard]] Result<ShapeFit> fitShape(const Residuals& residuals, Eigen::VectorXd start);

/// The derivatives of a function of the parameters, by which an error of the parameters propagates.
[[nodiscard]] Eigen::MatrixXd derivatives(const Residuals& function,
                                          const Eigen::VectorXd& parameters);

} // namespace carina
