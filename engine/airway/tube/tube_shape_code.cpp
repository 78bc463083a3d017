#include "engine/airway/tube/tube_shape_code.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

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

std::vector<Vec3> lineOf(const Numbers& numbers, double length, int pieces)
{
    const double step = length / pieces;
    std::vector<Vec3> line{Vec3::Zero()};
    Quat q = Quat::Identity();
    // The turn between two segments is that about the node between them; the first has half of it.
    for (int i = 0; i < pieces; ++i) {
        const auto p = legendre(2.0 * i / pieces - 1.0);
        double aboutX = 0.0;
        double aboutY = 0.0;
        for (std::size_t n = 0; n < TubeShapeCode::kAboutX; ++n)
            aboutX += numbers[Eigen::Index(n)] * p[n];
        for (std::size_t n = 0; n < TubeShapeCode::kAboutY; ++n)
            aboutY += numbers[Eigen::Index(TubeShapeCode::kAboutX + n)] * p[n];
        const double share = i > 0 ? 1.0 : 0.5;
        q = q * rotationFromVector(share * step * Vec3{aboutX, aboutY, 0.0});
        line.push_back(line.back() - step * (q * Vec3::UnitZ()));
    }
    return line;
}

/// The curvatures of a line, as far as the polynomials have them.
Numbers projected(std::span<const Vec3> p_E, double length)
{
    Numbers numbers = Numbers::Zero();
    Quat frame = Quat::Identity();
    const auto pieces = p_E.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Vec3 t = (p_E[i + 1] - p_E[i]).normalized();
        const Quat turn = Quat::FromTwoVectors(frame * -Vec3::UnitZ(), t);
        const Vec3 about = frame.inverse() * rotationVector(canonical(turn));
        const auto p = legendre(2.0 * double(i) / double(pieces) - 1.0);
        for (std::size_t n = 0; n < TubeShapeCode::kAboutX; ++n)
            numbers[Eigen::Index(n)] += (2.0 * double(n) + 1.0) / length * about.x() * p[n];
        for (std::size_t n = 0; n < TubeShapeCode::kAboutY; ++n)
            numbers[Eigen::Index(TubeShapeCode::kAboutX + n)] +=
                (2.0 * double(n) + 1.0) / length * about.y() * p[n];
        frame = turn * frame;
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

} // namespace

std::vector<Vec3> decoded(const TubeShapeCode& code, Length length, int pieces)
{
    CARINA_EXPECTS(length > Length{} && pieces > 0);
    Numbers numbers;
    for (std::size_t i = 0; i < kNumbers; ++i)
        numbers[Eigen::Index(i)] = double(code.perMetre[i]);
    return lineOf(numbers, length.si, pieces);
}

EncodedShape encoded(std::span<const Vec3> p_A, const RigidTransform& X_AE, Length length)
{
    CARINA_EXPECTS(p_A.size() >= 3 && length > Length{});
    constexpr int kRounds = 4;
    constexpr double kStep = 1e-3;    // per metre
    constexpr double kDamping = 1e-9; // of the normal equations: m^4
    const auto pieces = int(p_A.size()) - 1;
    const RigidTransform X_EA = X_AE.inverse();
    std::vector<Vec3> p_E;
    for (const Vec3& p : p_A)
        p_E.push_back(X_EA * p);
    Numbers numbers = projected(p_E, length.si);
    for (int round = 0; round < kRounds; ++round) {
        const Eigen::VectorXd off = offsets(lineOf(numbers, length.si, pieces), p_E);
        Eigen::MatrixXd slopes(off.size(), Eigen::Index(kNumbers));
        for (Eigen::Index k = 0; k < slopes.cols(); ++k) {
            Numbers other = numbers;
            other[k] += kStep;
            slopes.col(k) = (off - offsets(lineOf(other, length.si, pieces), p_E)) / kStep;
        }
        Eigen::Matrix<double, int(kNumbers), int(kNumbers)> normal = slopes.transpose() * slopes;
        normal.diagonal().array() += kDamping;
        numbers += normal.ldlt().solve(slopes.transpose() * off);
    }
    EncodedShape shape;
    for (std::size_t i = 0; i < kNumbers; ++i)
        shape.code.perMetre[i] = float(numbers[Eigen::Index(i)]);
    const std::vector<Vec3> line = decoded(shape.code, length, pieces);
    for (std::size_t i = 0; i < line.size(); ++i)
        shape.error = std::max(shape.error, metres((p_E[i] - line[i]).norm()));
    return shape;
}

} // namespace carina
