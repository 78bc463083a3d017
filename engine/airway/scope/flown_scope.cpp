#include "engine/airway/scope/flown_scope.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kPieceOfRoom = 0.25; ///< of the room
constexpr double kMostAway = 0.75;    ///< likewise
constexpr double kSpare = 1e-5;       ///< metres beyond what is needed, so that rounds end
constexpr double kHeldBelow = 1e-5;   ///< metres, below which it is held
constexpr double kGoesOn = 0.02;      ///< of a piece, below which it is stopped
constexpr int kRoundsOffWalls = 12;   ///< off walls, for each piece
constexpr int kRoundsOfTissue = 40;   ///< off walls that have moved
constexpr int kMostPieces = 4000;

} // namespace

void FlownScope::turn(Angle right, Angle up)
{
    const Quat turned = m_X_AD.rotation() * Quat{Eigen::AngleAxisd{-right.si, Vec3::UnitY()}}
                        * Quat{Eigen::AngleAxisd{up.si, Vec3::UnitX()}};
    m_X_AD = {turned, m_X_AD.translation()};
}

void FlownScope::roll(Angle clockwise)
{
    m_X_AD = {m_X_AD.rotation() * Quat{Eigen::AngleAxisd{-clockwise.si, Vec3::UnitZ()}},
              m_X_AD.translation()};
}

/// Where the ball is that was to go from one place to another; nothing where it finds no room
/// within kMostAway of that which it had.
std::optional<Vec3> FlownScope::slid(const Vec3& from, const Vec3& to, double room,
                                     ScopeWalls& walls) const
{
    Vec3 p_A = to;
    for (int round = 0; round < kRoundsOffWalls; ++round) {
        const ScopeWalls::Nearest wall = walls.nearestTo(p_A);
        if (wall.distance >= room)
            return (p_A - from).norm() <= kMostAway * room ? std::optional{p_A} : std::nullopt;
        if (wall.distance < 0.1 * kHeldBelow)
            break;
        p_A += (room + kSpare - wall.distance) / wall.distance * (p_A - wall.p_A);
    }
    return std::nullopt;
}

void FlownScope::advance(Length way, ScopeWalls& walls)
{
    const Vec3 ahead = m_X_AD.rotation() * Vec3{0.0, 0.0, way.si > 0.0 ? -1.0 : 1.0};
    const double room = std::min(m_radius, walls.nearestTo(m_X_AD.translation()).distance);
    if (room < kHeldBelow)
        return;
    double left = std::abs(way.si);
    for (int i = 0; i < kMostPieces && left > 0.0; ++i) {
        const double piece = std::min(left, kPieceOfRoom * room);
        const Vec3 from = m_X_AD.translation();
        const auto to = slid(from, from + piece * ahead, room, walls);
        if (!to || (*to - from).dot(ahead) < kGoesOn * piece || !walls.isWithin(*to, kLeash))
            break;
        goTo(*to);
        left -= piece;
    }
    makeRoom(walls);
}

/// Up to its radius; no step is longer than half the room, so that none passes a wall.
void FlownScope::makeRoom(ScopeWalls& walls)
{
    for (int round = 0; round < kRoundsOfTissue; ++round) {
        const Vec3 p_A = m_X_AD.translation();
        const ScopeWalls::Nearest wall = walls.nearestTo(p_A);
        if (wall.distance >= m_radius || wall.distance < 0.1 * kHeldBelow)
            return;
        double step = std::min(m_radius + kSpare - wall.distance, 0.5 * wall.distance);
        const Vec3 away = (p_A - wall.p_A) / wall.distance;
        while (step > kHeldBelow && walls.nearestTo(p_A + step * away).distance <= wall.distance)
            step *= 0.5;
        if (step <= kHeldBelow)
            return;
        goTo(p_A + step * away);
    }
}

void FlownScope::follow(ScopeWalls& walls)
{
    m_X_AD = walls.carriedFrom(m_X_AD.translation()) * m_X_AD;
    makeRoom(walls);
}

bool FlownScope::isAtWall(ScopeWalls& walls) const
{
    return walls.nearestTo(m_X_AD.translation()).distance < m_radius + kTouching.si;
}

} // namespace carina
