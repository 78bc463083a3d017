#pragma once

#include "engine/core/result.h"

#include <span>
#include <vector>

namespace carina
{

/// sum_i coefficients[i] x^i
struct Polynomial {
    std::vector<double> coefficients;

    [[nodiscard]] double at(double x) const;
};

/// The polynomial of a degree that minimises sum_i (y_i - p(x_i))^2: Householder QR of the
/// Vandermonde matrix in x mapped onto [-1, 1], where it is far better conditioned than in x.
///
/// @returns OutOfRange for fewer different x than coefficients; NotFinite.
/// @pre x and y have the same size; degree >= 0
[[nodiscard]] Result<Polynomial> fitPolynomial(std::span<const double> x, std::span<const double> y,
                                               int degree);

} // namespace carina
