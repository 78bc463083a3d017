#include "evaluation/intubation/bent_tube.h"

#include "engine/geometry/rotation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kMostSteps = 20;
constexpr int kMostTries = 60;         ///< to find the walls that are touched, in a step
constexpr int kFreeTries = 8;          ///< of these, in which all may change
constexpr double kSettled = 1e-6;      ///< metres of the largest movement in a step
constexpr double kFarthest = 8e-3;     ///< metres that a node goes in a step
constexpr double kWallStiffness = 1e3; ///< against bending of a piece
constexpr int kMostHalvings = 8;       ///< of a step after which it is bent more
constexpr double kMoreBent = 1.01;     ///< which is not said of so little, nor of kHardlyBent
constexpr double kHardlyBent = 0.01;   ///< of energy, radians squared per metre

/// A symmetric system with so many entries from the diagonal on: two unknowns of a node depend on
/// those of the two nodes to either side.
class BandedEquations
{
public:
    static constexpr std::size_t kBand = 6;

    explicit BandedEquations(std::size_t unknowns) : m_rows(unknowns), m_right(unknowns, 0.0)
    {
        for (auto& row : m_rows)
            row.fill(0.0);
    }

    /// At most kBand - 1 before `row`.
    double& at(std::size_t row, std::size_t column) { return m_rows[row][row - column]; }
    double& right(std::size_t row) { return m_right[row]; }

    /// By Cholesky's factors. @pre positive definite
    [[nodiscard]] std::vector<double> solved() &&
    {
        const std::size_t n = m_rows.size();
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = firstOf(i); j <= i; ++j) {
                double sum = at(i, j);
                for (std::size_t k = std::max(firstOf(i), firstOf(j)); k < j; ++k)
                    sum -= at(i, k) * at(j, k);
                at(i, j) = j < i ? sum / at(j, j) : std::sqrt(sum);
            }
            for (std::size_t k = firstOf(i); k < i; ++k)
                m_right[i] -= at(i, k) * m_right[k];
            m_right[i] /= at(i, i);
        }
        for (std::size_t i = n; i-- > 0;) {
            m_right[i] /= at(i, i);
            for (std::size_t k = firstOf(i); k < i; ++k)
                m_right[k] -= at(i, k) * m_right[i];
        }
        return std::move(m_right);
    }

private:
    static std::size_t firstOf(std::size_t row) { return row < kBand ? 0 : row - kBand + 1; }

    std::vector<std::array<double, kBand>> m_rows;
    std::vector<double> m_right;
};

/// A tube's centre line at rest.
class RestLine
{
public:
    explicit RestLine(std::span<const Vec3> p_E) : m_p_E{p_E}, m_along{0.0}
    {
        for (std::size_t i = 1; i < p_E.size(); ++i)
            m_along.push_back(m_along.back() + (p_E[i] - p_E[i - 1]).norm());
    }

    [[nodiscard]] double length() const { return m_along.back(); }
    [[nodiscard]] const Vec3& tip() const { return m_p_E.back(); }
    /// The place at an arc length, and beyond the ends straight on.
    [[nodiscard]] Vec3 at(double along) const
    {
        const auto after = std::upper_bound(m_along.begin() + 1, m_along.end() - 1, along);
        const auto i = std::size_t(after - m_along.begin());
        const double share = (along - m_along[i - 1]) / (m_along[i] - m_along[i - 1]);
        return m_p_E[i - 1] + share * (m_p_E[i] - m_p_E[i - 1]);
    }

private:
    std::span<const Vec3> m_p_E;
    std::vector<double> m_along;
};

/// Axes at each piece of a line, with its direction as the third, carried along it.
std::vector<Mat3> carriedAxes(std::span<const Vec3> directions, const Vec3& across)
{
    std::vector<Mat3> axes;
    Vec3 first = across;
    for (const Vec3& direction : directions) {
        if (!axes.empty())
            first = Quat::FromTwoVectors(axes.back().col(2), direction) * first;
        first = (first - first.dot(direction) * direction).normalized();
        axes.emplace_back();
        axes.back() << first, direction.cross(first), direction;
    }
    return axes;
}

/// The curve while it goes to where its energy is least.
class RelaxingCurve
{
public:
    RelaxingCurve(const TubeCorridor& corridor, std::span<const Vec3> p_E_rest, Angle roll)
        : m_corridor{corridor},
          m_rest{p_E_rest},
          m_roll{roll},
          m_aside(corridor.size(), {0.0, 0.0}),
          m_touched(2 * (corridor.size() - 2), Touched::Nothing)
    {
        measure();
    }

    void relax()
    {
        for (int i = 0; i < kMostSteps; ++i)
            if (step() < kSettled)
                break;
        for (std::size_t i = 0; i < m_touched.size(); ++i)
            aside(i) = std::clamp(aside(i), least(i), most(i));
        measure();
    }

    [[nodiscard]] std::optional<BentTube> tube() const
    {
        if (m_outside < 0.0 || m_axes.empty())
            return std::nullopt;
        const Quat q_AE{Mat3{m_axes.front() * m_restAxes.front().transpose()}};
        const Vec3 p_E_held = m_rest.at(m_outside);
        return BentTube{{q_AE, m_nodes.front() - q_AE * p_E_held}, m_nodes, metres(m_outside)};
    }

private:
    /// Which of its two walls an unknown touches.
    enum class Touched : std::uint8_t { Nothing, Least, Most };

    [[nodiscard]] std::size_t pieces() const { return m_nodes.size() - 1; }

    /// Nodes, pieces and axes as the curve lies.
    void measure()
    {
        m_nodes.clear();
        for (std::size_t i = 0; i < m_corridor.size(); ++i)
            m_nodes.push_back(m_corridor[i].p_A
                              + m_corridor[i].axes.leftCols<2>()
                                    * Eigen::Vector2d{m_aside[i][0], m_aside[i][1]});
        m_lengths.clear();
        m_directions.clear();
        double inside = 0.0;
        for (std::size_t i = 0; i < pieces(); ++i) {
            const Vec3 piece = m_nodes[i + 1] - m_nodes[i];
            m_lengths.push_back(piece.norm());
            m_directions.emplace_back(piece / m_lengths.back());
            inside += m_lengths.back();
        }
        m_outside = m_rest.length() - inside;
        measureAxes();
    }

    void measureAxes()
    {
        std::vector<Vec3> atRest; // directions of the same pieces
        double along = m_outside;
        const Vec3 p_E_held = m_rest.at(along);
        Vec3 before = p_E_held;
        for (const double length : m_lengths) {
            along += length;
            const Vec3 p_E = m_rest.at(along);
            atRest.push_back((p_E - before).normalized());
            before = p_E;
        }
        const Vec3 chord_A = m_nodes.back() - m_nodes.front();
        const auto axes_A = acrossAxesOf(chord_A);
        const auto axes_E = acrossAxesOf(m_rest.tip() - p_E_held);
        m_axes.clear();
        if (!axes_A || !axes_E)
            return;
        m_restAxes = carriedAxes(atRest, Vec3::UnitX());
        const Quat roll = rotationFromVector(m_roll.si * chord_A.normalized());
        const Quat q_AE_rigid = roll * Quat{Mat3{*axes_A * axes_E->transpose()}};
        m_axes = carriedAxes(m_directions, q_AE_rigid * m_restAxes.front().col(0));
    }

    /// Bending is linearised where the curve lies, and of this the least energy is found between
    /// the walls.
    /// @returns the farthest that a node went, metres
    double step()
    {
        if (m_axes.empty())
            return 0.0;
        BandedEquations bending{2 * (pieces() - 1)};
        for (std::size_t node = 1; node < pieces(); ++node)
            addBending(bending, node);
        std::vector<double> ways;
        for (int i = 0; i < kMostTries; ++i) {
            BandedEquations equations = bending;
            addWalls(equations);
            ways = std::move(equations).solved();
            if (!(i < kFreeTries ? touchOthers(ways) : touchMoreOrOneLess(ways)))
                break;
        }
        double farthest = 0.0;
        for (const double way : ways)
            farthest = std::max(farthest, std::abs(way));
        return go(ways, farthest > kFarthest ? kFarthest / farthest : 1.0) * farthest;
    }

    /// By such a share of the ways, or less where the curve would be bent more there.
    /// @returns the share; 0 where it stays
    double go(std::span<const double> ways, double share)
    {
        const double allowed = kMoreBent * energy() + kHardlyBent;
        const auto before = m_aside;
        for (int i = 0; i < kMostHalvings; ++i) {
            m_aside = before;
            for (std::size_t k = 0; k < ways.size(); ++k)
                aside(k) += share * ways[k];
            measure();
            if (!m_axes.empty() && energy() <= allowed)
                return share;
            share *= 0.5;
        }
        m_aside = before;
        measure();
        return 0.0;
    }

    [[nodiscard]] double energy() const
    {
        double sum = 0.0;
        for (std::size_t node = 1; node < pieces(); ++node)
            for (const Eigen::Index c : {0, 1})
                sum += weightOf(node) * turnAt(node, c) * turnAt(node, c);
        return sum;
    }
    [[nodiscard]] double weightOf(std::size_t node) const
    {
        return 2.0 / (m_lengths[node - 1] + m_lengths[node]);
    }
    /// Between the pieces before and behind a node, beyond that at rest.
    [[nodiscard]] double turnAt(std::size_t node, Eigen::Index axis) const
    {
        return m_axes[node - 1].col(axis).dot(m_directions[node])
               - m_restAxes[node - 1].col(axis).dot(m_restAxes[node].col(2));
    }

    /// Of the turn between the pieces before and behind a node.
    void addBending(BandedEquations& equations, std::size_t node)
    {
        const Vec3& before = m_directions[node - 1];
        const Vec3& behind = m_directions[node];
        for (const Eigen::Index c : {0, 1}) {
            const Vec3 axis = m_axes[node - 1].col(c);
            // By the way of the node before, the node, and the one behind.
            const Vec3 byBehind = (axis - axis.dot(behind) * behind) / m_lengths[node];
            const Vec3 byBefore = before.dot(behind) / m_lengths[node - 1] * axis;
            const std::array<Vec3, 3> by{byBefore, Vec3{-byBehind - byBefore}, byBehind};
            add(equations, node, by, turnAt(node, c));
        }
    }

    void add(BandedEquations& equations, std::size_t node, const std::array<Vec3, 3>& by,
             double turn)
    {
        const double weight = weightOf(node);
        std::array<double, 6> slopes{};
        for (std::size_t i = 0; i < slopes.size(); ++i)
            slopes[i] = by[i / 2].dot(m_corridor[node - 1 + i / 2].axes.col(Eigen::Index(i % 2)));
        // The first and last node stay.
        const std::size_t from = node == 1 ? 2 : 0;
        const std::size_t until = node + 1 == pieces() ? 4 : 6;
        const std::size_t unknown = 2 * (node - 1); // of the node; its slopes begin at 2
        for (std::size_t i = from; i < until; ++i) {
            const std::size_t row = unknown + i - 2;
            equations.right(row) -= weight * slopes[i] * turn;
            for (std::size_t j = from; j <= i; ++j)
                equations.at(row, unknown + j - 2) += weight * slopes[i] * slopes[j];
        }
    }

    /// The walls that are touched, as springs.
    void addWalls(BandedEquations& equations)
    {
        const double length = (m_rest.length() - m_outside) / double(pieces());
        const double stiffness = kWallStiffness / (length * length * length);
        for (std::size_t i = 0; i < m_touched.size(); ++i) {
            if (m_touched[i] == Touched::Nothing)
                continue;
            equations.at(i, i) += stiffness;
            equations.right(i) -= stiffness * beyond(i, 0.0);
        }
    }

    [[nodiscard]] Touched touchedAfter(std::size_t unknown, double way) const
    {
        const double there = m_aside[1 + unknown / 2][unknown % 2] + way;
        return there > most(unknown)    ? Touched::Most
               : there < least(unknown) ? Touched::Least
                                        : Touched::Nothing;
    }

    /// Those beyond which nodes would be after these ways.
    /// @returns whether they are others than before
    bool touchOthers(std::span<const double> ways)
    {
        bool areOthers = false;
        for (std::size_t i = 0; i < m_touched.size(); ++i) {
            const Touched touched = touchedAfter(i, ways[i]);
            areOthers = areOthers || touched != m_touched[i];
            m_touched[i] = touched;
        }
        return areOthers;
    }

    /// Where that goes round in circles: those beyond which nodes would be, too; and if there are
    /// none, all but the one that would be left farthest.
    /// @returns whether they are others than before
    bool touchMoreOrOneLess(std::span<const double> ways)
    {
        bool areMore = false;
        double farthest = 0.0;
        std::size_t left = m_touched.size();
        for (std::size_t i = 0; i < m_touched.size(); ++i) {
            const Touched touched = touchedAfter(i, ways[i]);
            if (m_touched[i] == Touched::Nothing) {
                areMore = areMore || touched != Touched::Nothing;
                m_touched[i] = touched;
            } else if (touched != m_touched[i] && std::abs(beyond(i, ways[i])) > farthest) {
                farthest = std::abs(beyond(i, ways[i]));
                left = i;
            }
        }
        if (areMore || left == m_touched.size())
            return areMore;
        m_touched[left] = Touched::Nothing;
        return true;
    }

    /// Of the wall that an unknown touches.
    [[nodiscard]] double beyond(std::size_t unknown, double way) const
    {
        const double wall = m_touched[unknown] == Touched::Most ? most(unknown) : least(unknown);
        return m_aside[1 + unknown / 2][unknown % 2] + way - wall;
    }

    // Of an unknown: two for each node but the first and the last.
    double& aside(std::size_t unknown) { return m_aside[1 + unknown / 2][unknown % 2]; }
    [[nodiscard]] double least(std::size_t unknown) const
    {
        return m_corridor[1 + unknown / 2].least[unknown % 2];
    }
    [[nodiscard]] double most(std::size_t unknown) const
    {
        return m_corridor[1 + unknown / 2].most[unknown % 2];
    }

    const TubeCorridor& m_corridor;
    RestLine m_rest;
    Angle m_roll;
    std::vector<std::array<double, 2>> m_aside; ///< of the corridor's line, metres
    std::vector<Touched> m_touched;             ///< of each unknown
    std::vector<Vec3> m_nodes;
    std::vector<double> m_lengths; ///< of the pieces
    std::vector<Vec3> m_directions;
    std::vector<Mat3> m_axes; ///< of the pieces; none where no axes can be told
    std::vector<Mat3> m_restAxes;
    double m_outside = 0.0;
};

} // namespace

std::vector<Vec3> BentTube::line(std::span<const Vec3> p_E_rest) const
{
    std::vector<Vec3> whole;
    double along = 0.0;
    for (std::size_t i = 0; i < p_E_rest.size(); ++i) {
        if (i > 0)
            along += (p_E_rest[i] - p_E_rest[i - 1]).norm();
        if (along >= outside.si)
            break;
        whole.push_back(X_AE * p_E_rest[i]);
    }
    whole.insert(whole.end(), p_A_inside.begin(), p_A_inside.end());
    return whole;
}

std::optional<BentTube> bentTube(const TubeCorridor& corridor, std::span<const Vec3> p_E_rest,
                                 Angle roll)
{
    RelaxingCurve curve{corridor, p_E_rest, roll};
    curve.relax();
    return curve.tube();
}

} // namespace carina
