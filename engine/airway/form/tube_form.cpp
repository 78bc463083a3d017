#include "engine/airway/form/tube_form.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr int kNumbers = 8;
using Numbers = Eigen::Matrix<double, kNumbers, 1>;
/// Of each number in the curvatures about x' and y' at one place.
using Share = Eigen::Matrix<double, 2, kNumbers>;

constexpr int kFirstInside = 2;
constexpr int kAside = kFirstInside + int(TubeForm::kInside);
constexpr int kAtTip = 6; ///< the power of u

/// From 0 to 1 within a width to either side of a place.
double rise(double s, double place, double width)
{
    const double x = std::clamp(0.5 * (s - place) / width + 0.5, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

Share shareAt(double s, double length, double entry, double plane)
{
    const double inside = rise(s, entry, TubeForm::kPassage.si);
    const double u = entry < length ? std::clamp((s - entry) / (length - entry), 0.0, 1.0) : 0.0;
    const double x = 2.0 * u - 1.0;
    Share share = Share::Zero();
    share.col(s < 0.5 * length ? 0 : 1) =
        (1.0 - inside) * Eigen::Vector2d{std::cos(plane), -std::sin(plane)};
    double before = 0.0;
    double legendre = 1.0;
    for (int n = 0; n < int(TubeForm::kInside); ++n) {
        share(0, kFirstInside + n) = inside * legendre;
        const double next = ((2.0 * n + 1.0) * x * legendre - n * before) / (n + 1.0);
        before = std::exchange(legendre, next);
    }
    share(1, kAside) = inside * std::pow(u, kAtTip);
    return share;
}

/// At each node but the tip, about x' and y'.
std::vector<Share> sharesOf(Length length, Length entry, Angle plane, int pieces)
{
    std::vector<Share> shares;
    for (int i = 0; i < pieces; ++i)
        shares.push_back(shareAt(length.si * i / pieces, length.si, entry.si, plane.si));
    return shares;
}

/// The turn between two segments is that about the node between them; the first has half of it.
double partOf(std::size_t node) { return node > 0 ? 1.0 : 0.5; }

std::vector<Vec3> lineOf(const Numbers& numbers, const std::vector<Share>& shares, double step)
{
    std::vector<Vec3> line{Vec3::Zero()};
    Quat q = Quat::Identity();
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const Eigen::Vector2d about = partOf(i) * step * (shares[i] * numbers);
        q = q * rotationFromVector(Vec3{about.x(), about.y(), 0.0});
        line.push_back(line.back() - step * (q * Vec3::UnitZ()));
    }
    return line;
}

/// The numbers that fit the curvatures of a line best.
Numbers ofCurvatures(std::span<const Vec3> p, const std::vector<Share>& shares, double step)
{
    Eigen::Matrix<double, kNumbers, kNumbers> normal;
    normal.setZero();
    Numbers right = Numbers::Zero();
    Quat frame = Quat::Identity();
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const Vec3 t = (p[i + 1] - p[i]).normalized();
        const Quat turn = Quat::FromTwoVectors(frame * -Vec3::UnitZ(), t);
        const Vec3 about = frame.inverse() * rotationVector(canonical(turn));
        normal += shares[i].transpose() * shares[i];
        right += shares[i].transpose() * about.head<2>() / (partOf(i) * step);
        frame = turn * frame;
    }
    constexpr double kDamping = 1e-6; // where a number has no share, as outside of the mouth
    normal.diagonal().array() += kDamping;
    return normal.ldlt().solve(right);
}

Eigen::VectorXd offsets(const std::vector<Vec3>& line, std::span<const Vec3> p)
{
    Eigen::VectorXd off(3 * Eigen::Index(p.size()));
    for (std::size_t i = 0; i < p.size(); ++i)
        off.segment<3>(3 * Eigen::Index(i)) = p[i] - line[i];
    return off;
}

/// Gauss and Newton's step.
Numbers improved(const Numbers& numbers, std::span<const Vec3> p, const std::vector<Share>& shares,
                 double step)
{
    constexpr double kSmall = 1e-3;   // per metre
    constexpr double kDamping = 1e-8; // of the normal equations: m^4
    const Eigen::VectorXd off = offsets(lineOf(numbers, shares, step), p);
    Eigen::MatrixXd slopes(off.size(), kNumbers);
    for (int k = 0; k < kNumbers; ++k) {
        Numbers other = numbers;
        other[k] += kSmall;
        slopes.col(k) = (off - offsets(lineOf(other, shares, step), p)) / kSmall;
    }
    Eigen::Matrix<double, kNumbers, kNumbers> normal = slopes.transpose() * slopes;
    normal.diagonal().array() += kDamping;
    return numbers + normal.ldlt().solve(slopes.transpose() * off);
}

RigidTransform turnedBy(Angle plane)
{
    return {rotationFromVector(plane.si * Vec3::UnitZ()), Vec3::Zero()};
}

std::vector<Vec3> takenBy(const RigidTransform& X, std::span<const Vec3> points)
{
    std::vector<Vec3> taken;
    taken.reserve(points.size());
    for (const Vec3& p : points)
        taken.push_back(X * p);
    return taken;
}

} // namespace

Angle medianPlane(const RigidTransform& X_AE)
{
    constexpr double kLeast = 0.1; // of a unit vector: of ours
    const Vec3 across_E = X_AE.rotation().inverse() * Vec3::UnitX();
    return across_E.head<2>().norm() < kLeast ? Angle{}
                                              : radians(std::atan2(across_E.y(), across_E.x()));
}

TubeForm formOf(std::span<const Vec3> p_E, Length length, Length entry, Angle plane)
{
    CARINA_EXPECTS(p_E.size() >= 3 && length > Length{});
    CARINA_EXPECTS(entry >= Length{} && entry <= length);
    constexpr int kRounds = 3;
    const auto pieces = int(p_E.size()) - 1;
    const double step = length.si / pieces;
    const std::vector<Vec3> p = takenBy(turnedBy(plane).inverse(), p_E);
    const std::vector<Share> shares = sharesOf(length, entry, plane, pieces);
    Numbers numbers = ofCurvatures(p, shares, step);
    for (int round = 0; round < kRounds; ++round)
        numbers = improved(numbers, p, shares, step);
    TubeForm form{.length = length, .entry = entry, .plane = plane, .perMetre = {}};
    std::copy_n(numbers.data(), kNumbers, form.perMetre.begin());
    return form;
}

std::vector<Vec3> lineOf(const TubeForm& form, int pieces)
{
    CARINA_EXPECTS(form.length > Length{} && pieces > 0);
    Numbers numbers;
    std::ranges::copy(form.perMetre, numbers.data());
    return takenBy(turnedBy(form.plane),
                   lineOf(numbers, sharesOf(form.length, form.entry, form.plane, pieces),
                          form.length.si / pieces));
}

} // namespace carina
