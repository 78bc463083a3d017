#include "engine/airway/tube/tube_shape_code.h"

#include "engine/anatomy/shapes/swept_surface.h"
#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carina
{
namespace
{

constexpr std::size_t kNumbers = TubeShapeCode::kAboutX + TubeShapeCode::kAboutY;
using Numbers = Eigen::Matrix<double, int(kNumbers), 1>;

/// P_0 to P_5 at x.
std::array<double, TubeShapeCode::kAboutX> legendre(double x)
{
    std::array<double, TubeShapeCode::kAboutX> p{1.0, x};
    for (std::size_t n = 1; n + 1 < p.size(); ++n) {
        const auto k = double(n);
        p[n + 1] = ((2.0 * k + 1.0) * x * p[n] - k * p[n - 1]) / (k + 1.0);
    }
    return p;
}

/// A curve at rest, as it is needed to bend it.
struct RestCurve {
    std::vector<double> lengths; ///< of the segments, metres
    std::vector<Vec3> turns;     ///< from each segment to the next, in the frame carried to there

    [[nodiscard]] double mean() const
    {
        return std::accumulate(lengths.begin(), lengths.end(), 0.0) / double(lengths.size());
    }
};

/// The turns of a line, whose frame begins as E; the first is that from -z.
std::vector<Vec3> turnsOf(std::span<const Vec3> p_E)
{
    std::vector<Vec3> turns;
    Quat frame = Quat::Identity();
    for (std::size_t i = 0; i + 1 < p_E.size(); ++i) {
        const Vec3 t = (p_E[i + 1] - p_E[i]).normalized();
        const Quat turn = Quat::FromTwoVectors(frame * -Vec3::UnitZ(), t);
        turns.push_back(frame.inverse() * rotationVector(canonical(turn)));
        frame = turn * frame;
    }
    return turns;
}

RestCurve restCurveOf(std::span<const Vec3> p_E)
{
    RestCurve rest{{}, turnsOf(p_E)};
    for (std::size_t i = 0; i + 1 < p_E.size(); ++i)
        rest.lengths.push_back((p_E[i + 1] - p_E[i]).norm());
    return rest;
}

/// Of segment i the place in the polynomials.
double placeOf(std::size_t i, std::size_t pieces) { return 2.0 * double(i) / double(pieces) - 1.0; }

std::vector<Vec3> lineOf(const Numbers& numbers, const RestCurve& rest)
{
    const std::size_t pieces = rest.turns.size();
    const double each = rest.mean();
    std::vector<Vec3> line{Vec3::Zero()};
    Quat q = Quat::Identity();
    // The turn between two segments is that about the node between them; the first has half of it.
    for (std::size_t i = 0; i < pieces; ++i) {
        const auto p = legendre(placeOf(i, pieces));
        double aboutX = 0.0;
        double aboutY = 0.0;
        for (std::size_t n = 0; n < TubeShapeCode::kAboutX; ++n)
            aboutX += numbers[Eigen::Index(n)] * p[n];
        for (std::size_t n = 0; n < TubeShapeCode::kAboutY; ++n)
            aboutY += numbers[Eigen::Index(TubeShapeCode::kAboutX + n)] * p[n];
        const double share = i > 0 ? 1.0 : 0.5;
        q = q * rotationFromVector(rest.turns[i] + share * each * Vec3{aboutX, aboutY, 0.0});
        line.push_back(line.back() - rest.lengths[i] * (q * Vec3::UnitZ()));
    }
    return line;
}

/// The differences of the curvatures of a line, as far as the polynomials have them.
Numbers projected(std::span<const Vec3> p_E, const RestCurve& rest)
{
    Numbers numbers = Numbers::Zero();
    const std::vector<Vec3> turns = turnsOf(p_E);
    const double length = rest.mean() * double(turns.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const Vec3 about = turns[i] - rest.turns[i];
        const auto p = legendre(placeOf(i, turns.size()));
        for (std::size_t n = 0; n < TubeShapeCode::kAboutX; ++n)
            numbers[Eigen::Index(n)] += (2.0 * double(n) + 1.0) / length * about.x() * p[n];
        for (std::size_t n = 0; n < TubeShapeCode::kAboutY; ++n)
            numbers[Eigen::Index(TubeShapeCode::kAboutX + n)] +=
                (2.0 * double(n) + 1.0) / length * about.y() * p[n];
    }
    return numbers;
}

Eigen::VectorXd offsets(const std::vector<Vec3>& line, std::span<const Vec3> p_E)
{
    Eigen::VectorXd off(3 * Eigen::Index(p_E.size()));
    for (std::size_t i = 0; i < p_E.size(); ++i)
        off.segment<3>(3 * Eigen::Index(i)) = p_E[i] - line[i];
    return off;
}

/// By how much the numbers are to change, of Gauss and Newton's method.
Numbers improvement(const Numbers& numbers, const RestCurve& rest, std::span<const Vec3> p_E)
{
    constexpr double kStep = 1e-3;    // per metre
    constexpr double kDamping = 1e-9; // of the normal equations: m^4
    const Eigen::VectorXd off = offsets(lineOf(numbers, rest), p_E);
    Eigen::MatrixXd slopes(off.size(), Eigen::Index(kNumbers));
    for (Eigen::Index k = 0; k < slopes.cols(); ++k) {
        Numbers other = numbers;
        other[k] += kStep;
        slopes.col(k) = (off - offsets(lineOf(other, rest), p_E)) / kStep;
    }
    Eigen::Matrix<double, int(kNumbers), int(kNumbers)> normal = slopes.transpose() * slopes;
    normal.diagonal().array() += kDamping;
    return normal.ldlt().solve(slopes.transpose() * off);
}

/// Of improvements that go too far a half is tried, once.
Numbers fitted(Numbers numbers, const RestCurve& rest, std::span<const Vec3> p_E)
{
    constexpr int kRounds = 4;
    const auto squares = [&](const Numbers& of) {
        return offsets(lineOf(of, rest), p_E).squaredNorm();
    };
    double least = squares(numbers);
    for (int round = 0; round < kRounds; ++round) {
        const Numbers change = improvement(numbers, rest, p_E);
        for (const double share : {1.0, 0.5}) {
            const Numbers other = numbers + share * change;
            const double sum = squares(other);
            if (sum >= least)
                continue;
            numbers = other;
            least = sum;
            break;
        }
    }
    return numbers;
}

std::vector<Vec3> decodedWith(const TubeShapeCode& code, const RestCurve& rest)
{
    Numbers numbers;
    for (std::size_t i = 0; i < kNumbers; ++i)
        numbers[Eigen::Index(i)] = double(code.perMetre[i]);
    return lineOf(numbers, rest);
}

} // namespace

std::vector<Vec3> inPieces(std::span<const Vec3> line, int pieces)
{
    CARINA_EXPECTS(line.size() >= 2 && pieces > 0);
    const SweptLine swept = sweptLine(line);
    std::vector<Vec3> points;
    for (int i = 0; i <= pieces; ++i)
        points.push_back(placeAt(swept, swept.along.back() * i / pieces).point);
    return points;
}

std::vector<Vec3> decoded(const TubeShapeCode& code, std::span<const Vec3> p_E_rest)
{
    CARINA_EXPECTS(p_E_rest.size() >= 3);
    return decodedWith(code, restCurveOf(p_E_rest));
}

EncodedShape encoded(std::span<const Vec3> p_A, const RigidTransform& X_AE,
                     std::span<const Vec3> p_E_rest)
{
    CARINA_EXPECTS(p_A.size() >= 3 && p_A.size() == p_E_rest.size());
    const RestCurve rest = restCurveOf(p_E_rest);
    const RigidTransform X_EA = X_AE.inverse();
    std::vector<Vec3> p_E;
    for (const Vec3& p : p_A)
        p_E.push_back(X_EA * p);
    const Numbers numbers = fitted(projected(p_E, rest), rest, p_E);
    EncodedShape shape;
    for (std::size_t i = 0; i < kNumbers; ++i)
        shape.code.perMetre[i] = float(numbers[Eigen::Index(i)]);
    const std::vector<Vec3> line = decodedWith(shape.code, rest);
    for (std::size_t i = 0; i < line.size(); ++i)
        shape.error = std::max(shape.error, metres((p_E[i] - line[i]).norm()));
    return shape;
}

} // namespace carina
