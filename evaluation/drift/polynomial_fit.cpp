#include "evaluation/drift/polynomial_fit.h"

#include "engine/core/expects.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <set>

namespace carina
{
namespace
{

/// The coefficients in x of a polynomial in (x - middle) / half, by Horner's rule on polynomials.
std::vector<double> unmapped(const Eigen::VectorXd& mapped, double middle, double half)
{
    std::vector<double> sum{mapped[mapped.size() - 1]};
    for (Eigen::Index power = mapped.size() - 2; power >= 0; --power) {
        std::vector<double> next(sum.size() + 1, 0.0);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            next[i] -= sum[i] * middle / half;
            next[i + 1] += sum[i] / half;
        }
        next[0] += mapped[power];
        sum = std::move(next);
    }
    return sum;
}

} // namespace

double Polynomial::at(double x) const
{
    double value = 0.0;
    for (auto coefficient = coefficients.rbegin(); coefficient != coefficients.rend();
         ++coefficient)
        value = value * x + *coefficient;
    return value;
}

Result<Polynomial> fitPolynomial(std::span<const double> x, std::span<const double> y, int degree)
{
    CARINA_EXPECTS(x.size() == y.size() && degree >= 0);
    const auto isFinite = [](double value) { return std::isfinite(value); };
    if (!std::ranges::all_of(x, isFinite) || !std::ranges::all_of(y, isFinite))
        return fail(Errc::NotFinite, "a point of a trend");
    if (std::ssize(std::set<double>{x.begin(), x.end()}) <= degree)
        return fail(Errc::OutOfRange, "a trend of order " + std::to_string(degree)
                                          + " needs more different points than its order.");
    const auto [least, greatest] = std::ranges::minmax(x);
    const double middle = 0.5 * (least + greatest);
    const double half = greatest > least ? 0.5 * (greatest - least) : 1.0;
    const auto points = static_cast<Eigen::Index>(x.size());
    const Eigen::ArrayXd u = (Eigen::Map<const Eigen::ArrayXd>(x.data(), points) - middle) / half;
    Eigen::MatrixXd powers(points, degree + 1);
    powers.col(0).setOnes();
    for (int power = 1; power <= degree; ++power)
        powers.col(power) = powers.col(power - 1).array() * u;
    const Eigen::VectorXd mapped =
        powers.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(y.data(), points));
    return Polynomial{unmapped(mapped, middle, half)};
}

} // namespace carina
