#include "evaluation/waveforms/lung_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace carina
{

std::optional<LinearLung> fitLinear(const LungSamples& samples)
{
    constexpr double kTellsApart = 1e-10; // least over greatest pivot
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < samples.volume_l.size(); ++i) {
        const Eigen::Vector3d row{1.0, samples.flow_lPerS[i], samples.volume_l[i]};
        normal += row * row.transpose();
        right += samples.pressure_cmH2O[i] * row;
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver{normal};
    const Eigen::Vector3d pivots = solver.vectorD();
    if (solver.info() != Eigen::Success || pivots.minCoeff() <= kTellsApart * pivots.maxCoeff())
        return std::nullopt;
    const Eigen::Vector3d found = solver.solve(right);
    if (!(found[1] > 0.0 && found[2] > 0.0))
        return std::nullopt;
    return LinearLung{cmH2O(found[0]), cmH2OSecondsPerLitre(found[1]),
                      litresPerCmH2O(1.0 / found[2])};
}

} // namespace carina
