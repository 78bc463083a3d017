#include "engine/airway/tube/walled_ways.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kMostTrials = 4;       ///< of a share of a way: of ours
constexpr double kFlatEnough = 0.1;  ///< of the slope at its begin
constexpr double kLeastOfRest = 0.2; ///< of the part of a way in which the least sum is looked for

} // namespace

WalledWays::WalledWays(std::size_t count, double wall)
    : nodes(count),
      m_wall(wall),
      m_touches(count),
      m_ways(count, Vec3::Zero()),
      m_found(count, Vec3::Zero()),
      m_tried(count, Vec3::Zero())
{
    system.resize(count);
}

/// The walls before the nodes where they are by some ways.
/// @param areKept those that held them stay, also where they would not
void WalledWays::touch(std::size_t first, std::span<const Vec3> ways, bool areKept)
{
    for (std::size_t i = first; i < nodes.size(); ++i) {
        const auto& [section, slope, across, place] = nodes[i];
        if (section.isFree)
            m_touches[i] = {};
        else
            m_touches[i] = section.wallsAt(place.u + across.byU.dot(ways[i]),
                                           place.v + across.byV.dot(ways[i]),
                                           areKept ? m_touches[i].sides : 0U);
    }
}

void WalledWays::addWalls(std::size_t first)
{
    for (std::size_t i = first; i < nodes.size(); ++i) {
        const GuideSection::Walls& walls = m_touches[i];
        if (walls.sides == 0U)
            continue;
        const auto& [u, v] = nodes[i].across;
        const Mat3 stiff = walls.byUU * (u * u.transpose()) + walls.byVV * (v * v.transpose())
                           + walls.byUV * (u * v.transpose() + v * u.transpose());
        system.rows[i].diagonal += m_wall * stiff;
        system.rows[i].right += m_wall * (stiff * m_ways[i] - walls.byU * u - walls.byV * v);
    }
}

/// Slope along the ways found of the walls' part of the sum, at the touches.
double WalledWays::wallsAlong(std::size_t first) const
{
    double slope = 0.0;
    for (std::size_t i = first; i < nodes.size(); ++i)
        if (m_touches[i].sides != 0U)
            slope += m_touches[i].byU * nodes[i].across.byU.dot(m_found[i])
                     + m_touches[i].byV * nodes[i].across.byV.dot(m_found[i]);
    return m_wall * slope;
}

/// Slope and curvature along the ways found of the other part, where they begin.
WalledWays::AlongWays WalledWays::squaresAlong(std::size_t first) const
{
    AlongWays along;
    for (std::size_t i = first; i < nodes.size(); ++i) {
        const BandedSystem::Row& row = m_squares[i];
        Vec3 byFound = row.diagonal * m_found[i];
        Vec3 byWays = row.diagonal * m_ways[i];
        if (i > first) {
            byFound += 2.0 * (row.before * m_found[i - 1]);
            byWays += row.before * m_ways[i - 1];
        }
        if (i > first + 1) {
            byFound += 2.0 * (row.secondBefore * m_found[i - 2]);
            byWays += row.secondBefore * m_ways[i - 2];
        }
        if (i + 1 < nodes.size())
            byWays += m_squares[i + 1].before.transpose() * m_ways[i + 1];
        if (i + 2 < nodes.size())
            byWays += m_squares[i + 2].secondBefore.transpose() * m_ways[i + 2];
        along.curve += m_found[i].dot(byFound);
        along.slope += m_found[i].dot(byWays - row.right);
    }
    return along;
}

/// Goes along the ways found to where the slope of the sum, which rises on the way, is about zero.
void WalledWays::search(std::size_t first)
{
    const AlongWays squares = squaresAlong(first);
    const double begin = squares.slope + wallsAlong(first);
    double less = 0.0; // a share at which the sum still falls, and its slope
    double slopeAtLess = begin;
    double more = 1.0;
    double share = 1.0;
    for (int trial = 0;; ++trial) {
        for (std::size_t i = first; i < nodes.size(); ++i)
            m_tried[i] = m_ways[i] + share * m_found[i];
        touch(first, m_tried, false);
        const double slope = squares.slope + share * squares.curve + wallsAlong(first);
        const bool isWhole = share == 1.0 && slope <= 0.0;
        if (isWhole || std::abs(slope) <= kFlatEnough * std::abs(begin) || trial == kMostTrials)
            break;
        (slope > 0.0 ? more : less) = share;
        if (slope <= 0.0)
            slopeAtLess = slope;
        const double straight = slope > 0.0 ? slopeAtLess / (slopeAtLess - slope) : 0.5;
        share = less + (more - less) * std::clamp(straight, kLeastOfRest, 1.0 - kLeastOfRest);
    }
    std::swap(m_ways, m_tried);
}

bool WalledWays::find(std::size_t first, double nearEnough)
{
    m_squares = system.rows;
    for (Vec3& way : m_ways)
        way.setZero();
    touch(first, m_ways, true);
    m_isLeast = false;
    for (int solution = 0; solution < kMostSolutions && !m_isLeast; ++solution) {
        system.rows = m_squares;
        addWalls(first);
        if (!system.solve(first, m_found))
            return false;
        double change = 0.0;
        for (std::size_t i = first; i < nodes.size(); ++i) {
            m_found[i] -= m_ways[i];
            change = std::max(change, m_found[i].squaredNorm());
        }
        m_isLeast = change < nearEnough * nearEnough;
        if (solution > 0) {
            search(first);
        } else {
            std::swap(m_ways, m_found);
            touch(first, m_ways, false);
        }
    }
    return true;
}

} // namespace carina
