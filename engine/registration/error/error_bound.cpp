#include "engine/registration/error/error_bound.h"

#include "engine/core/expects.h"

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/SpecialFunctions>
#include <utility>

namespace carina
{
namespace
{

/// Where an increasing function of positive numbers passes a value, to a billionth.
template <class Function> double passes(const Function& f, double value)
{
    constexpr int kHalvings = 30;
    double high = 1.0;
    while (f(high) < value)
        high *= 2.0;
    double low = 0.0;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < value ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// P(r^2 <= x) of r^2 as errorBound has it.
double radiusBelow(double x, double degrees)
{
    if (degrees == kKnownExactly)
        return std::erf(std::sqrt(0.5 * x))
               - std::sqrt(2.0 * x / std::numbers::pi) * std::exp(-0.5 * x);
    return Eigen::numext::betainc(1.5, 0.5 * degrees, x / (x + degrees));
}

struct Direction {
    Vec3 squares; ///< of the three coordinates
    double weight;
};

/// Directions of one octant, which stands for the sphere where only squares count: the heights and
/// weights of Gauss and Legendre, with equally many turns about the third axis at each.
class Octant
{
public:
    static constexpr int kHeights = 12;
    static constexpr int kTurns = 8;

    Octant()
    {
        auto next = directions.begin();
        for (int i = 0; i < kHeights; ++i) {
            const auto [height, weight] = gauss(i);
            for (int k = 0; k < kTurns; ++k) {
                const double turn = 0.5 * std::numbers::pi * (k + 0.5) / kTurns;
                const double level = 1.0 - height * height;
                const double along = std::cos(turn) * std::cos(turn);
                *next++ = {{level * along, level * (1.0 - along), height * height},
                           weight / kTurns};
            }
        }
    }

    std::array<Direction, std::size_t(kHeights* kTurns)> directions;

private:
    /// The i-th positive zero of the Legendre polynomial of degree 2 kHeights, from above, and its
    /// weight on 0 .. 1.
    static std::pair<double, double> gauss(int i)
    {
        constexpr int kDegree = 2 * kHeights;
        double x = std::cos(std::numbers::pi * (i + 0.75) / (kDegree + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 6; ++step) {
            double before = 1.0;
            double value = x;
            for (int n = 2; n <= kDegree; ++n)
                before = std::exchange(value, ((2 * n - 1) * x * value - (n - 1) * before) / n);
            slope = kDegree * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        return {x, 2.0 / ((1.0 - x * x) * slope * slope)};
    }
};

} // namespace

Length errorBound(const Mat3& covariance, double degrees, double share)
{
    CARINA_EXPECTS(degrees > 0.0 && share > 0.0 && share < 1.0);
    static const Octant kOctant;
    const Vec3 variances = // ascending: the polar axis has the largest
        Eigen::SelfAdjointEigenSolver<Mat3>{covariance, Eigen::EigenvaluesOnly}.eigenvalues();
    if (!(variances[2] > 0.0))
        return {};
    const Vec3 shares = variances.cwiseMax(0.0) / variances[2];
    const auto below = [&](double square) {
        double sum = 0.0;
        for (const Direction& n : kOctant.directions)
            sum += n.weight * radiusBelow(square / shares.dot(n.squares), degrees);
        return sum;
    };
    return metres(std::sqrt(variances[2] * passes(below, share)));
}

double chiSquaredShare(double degrees, double share)
{
    CARINA_EXPECTS(degrees > 0.0 && share > 0.0 && share < 1.0);
    return passes([&](double x) { return Eigen::numext::igamma(0.5 * degrees, 0.5 * degrees * x); },
                  share);
}

double chiSquaredTail(double chiSquared, double degrees)
{
    CARINA_EXPECTS(degrees > 0.0 && chiSquared >= 0.0);
    return Eigen::numext::igammac(0.5 * degrees, 0.5 * chiSquared);
}

double varianceRatioTail(double ratio, double above, double below)
{
    CARINA_EXPECTS(ratio >= 0.0 && above > 0.0 && below > 0.0);
    return Eigen::numext::betainc(0.5 * below, 0.5 * above, below / (below + above * ratio));
}

} // namespace carina
