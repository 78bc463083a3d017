#pragma once

#include <cmath>

namespace carina::vision_test
{

/// The noise of a corner along each axis that fitBody assumes before it has seen residuals, as
/// body_pose.h documents it: pixels, and the degrees of freedom as which it counts.
inline constexpr double kAssumedNoise = 0.15;
inline constexpr double kAssumedFreedom = 4.0;

/// The expectation of e^T C^-1 e / 6 for the error e of a pose and its stated covariance C, where
/// the corners are off by independent Gaussian noise. With f degrees of freedom of the residuals
///
///     E[(4 + f) / (4 (assumed / noise)^2 + x)],   x ~ chi^2(f)
///
/// because e^T (J^T J) e / noise^2 ~ chi^2(6) is independent of the residuals. Integrated over the
/// density of x by the midpoint rule.
inline double expectedSquare(double noise, int freedom)
{
    constexpr int kSteps = 4000;
    const double half = 0.5 * freedom;
    const double step = (freedom + 20.0 * std::sqrt(2.0 * freedom)) / kSteps;
    const double prior = kAssumedFreedom * std::pow(kAssumedNoise / noise, 2);
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double x = (i + 0.5) * step;
        const double density = std::exp((half - 1.0) * std::log(x) - 0.5 * x - half * std::log(2.0)
                                        - std::lgamma(half));
        sum += step * density * (kAssumedFreedom + freedom) / (prior + x);
    }
    return sum;
}

/// What a chi-squared variable exceeds with probability 0.001, divided by its degrees of freedom
/// (Wilson and Hilferty 1931).
inline double rareShare(double freedom)
{
    constexpr double kOneInAThousand = 3.09; // of the normal distribution
    const double variance = 2.0 / (9.0 * freedom);
    return std::pow(1.0 - variance + kOneInAThousand * std::sqrt(variance), 3);
}

} // namespace carina::vision_test
