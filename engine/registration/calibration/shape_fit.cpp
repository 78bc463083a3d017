#include "engine/registration/calibration/shape_fit.h"

#include <Eigen/Eigenvalues>

namespace carina
{
namespace
{

constexpr int kMostSteps = 60;
constexpr int kMostHalvings = 12;
constexpr double kDifference = 1e-6;   ///< of metres and radians
constexpr double kShareOfGain = 1e-12; ///< a step that lessens the sum by less is the last
/// Smallest eigenvalue of J^T J over its largest, with parameters in units of about equal effect.
constexpr double kUndetermined = 1e-9;

} // namespace

Eigen::MatrixXd derivatives(const Residuals& function, const Eigen::VectorXd& parameters)
{
    Eigen::MatrixXd J;
    for (Eigen::Index i = 0; i < parameters.size(); ++i) {
        const Eigen::VectorXd step =
            kDifference * Eigen::VectorXd::Unit(parameters.size(), i).eval();
        const Eigen::VectorXd column =
            (function(parameters + step) - function(parameters - step)) / (2.0 * kDifference);
        if (i == 0)
            J.resize(column.size(), parameters.size());
        J.col(i) = column;
    }
    return J;
}

Result<ShapeFit> fitShape(const Residuals& residuals, Eigen::VectorXd start)
{
    ShapeFit fit{.parameters = std::move(start), .residuals = {}, .spread = {}};
    fit.residuals = residuals(fit.parameters);
    if (!fit.residuals.allFinite())
        return fail(Errc::NotFinite, "a shape to begin with");
    for (int step = 0; step < kMostSteps; ++step) {
        const Eigen::MatrixXd J = derivatives(residuals, fit.parameters);
        const Eigen::MatrixXd normal = J.transpose() * J;
        const Eigen::VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt();
        const Eigen::MatrixXd scaled =
            scale.cwiseInverse().asDiagonal() * normal * scale.cwiseInverse().asDiagonal();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{scaled};
        if (!scaled.allFinite()
            || solver.eigenvalues().minCoeff() < kUndetermined * solver.eigenvalues().maxCoeff())
            return fail(Errc::DegenerateLandmarks);
        fit.spread = scale.cwiseInverse().asDiagonal() * solver.eigenvectors()
                     * solver.eigenvalues().cwiseInverse().asDiagonal()
                     * solver.eigenvectors().transpose() * scale.cwiseInverse().asDiagonal();
        Eigen::VectorXd change = -fit.spread * (J.transpose() * fit.residuals);
        const double before = fit.residuals.squaredNorm();
        double after = before;
        for (int halving = 0; halving < kMostHalvings && !(after < before); ++halving) {
            const Eigen::VectorXd next = residuals(fit.parameters + change);
            after = next.allFinite() ? next.squaredNorm() : before;
            if (after < before) {
                fit.parameters += change;
                fit.residuals = next;
            }
            change *= 0.5;
        }
        if (!(after < before * (1.0 - kShareOfGain)))
            break;
    }
    return fit;
}

} // namespace carina
