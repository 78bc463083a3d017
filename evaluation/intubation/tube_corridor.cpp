#include "evaluation/intubation/tube_corridor.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// The walls of a way at a moment.
class MovedWalls
{
public:
    MovedWalls(const MotionPatient& patient, const TipWay& way, const TissueAroundWay& tissue)
        : m_way{way},
          m_tissue{tissue},
          m_throat{patient.throat, tissue.X_AJ * patient.held.inverse()}
    {
    }

    [[nodiscard]] WallsAround at(double along) const
    {
        const std::vector<WallsAround>& walls = m_way.walls;
        const auto after = std::ranges::upper_bound(walls, along, {}, &WallsAround::along);
        const WallsAround& b = after == walls.end() ? walls.back() : *after;
        const WallsAround& a = after == walls.begin() ? walls.front() : *std::prev(after);
        const double length = b.along - a.along;
        const double share = length > 0.0 ? (along - a.along) / length : 0.0;
        WallsAround moved{.along = along, .p_A_walls = {}};
        for (const WallSide side : kWallSides)
            moved.p_A_walls[static_cast<std::size_t>(side)] =
                placed(a.at(side) + share * (b.at(side) - a.at(side)), side, along);
        return moved;
    }

private:
    /// In mouth and throat the wall at the back is palate and pharynx; tongue and jaw are around.
    [[nodiscard]] Vec3 placed(const Vec3& p_A_wall, WallSide side, double along) const
    {
        const bool isInThroat = along < m_way.fork;
        const bool isPharynx = isInThroat && side == WallSide::Back;
        const Vec3 p_A =
            p_A_wall
            + throatPull(m_throat, isPharynx ? ThroatTissue::Pharynx : ThroatTissue::Airway,
                         p_A_wall)
                  .d;
        if (!isInThroat || side != WallSide::Front || !m_tissue.blade.isThere())
            return p_A;
        return p_A + bladePull<double>(m_tissue.blade.frame(), AirwayTissue::Throat, p_A).d;
    }

    const TipWay& m_way;
    const TissueAroundWay& m_tissue;
    FollowingThroat m_throat;
};

/// A place of a way, and straight on in front of its beginning.
Vec3 placeOf(const MotionPatient& patient, const TipWay& way, double along, const HeldTissue& held)
{
    if (along >= 0.0)
        return placeOnWay(patient, way, along, held);
    const Vec3 first = placeOnWay(patient, way, 0.0, held);
    const Vec3 ahead = placeOnWay(patient, way, kWallsEach.si, held) - first;
    return first + along / kWallsEach.si * ahead;
}

/// Along the way, from one end of a corridor to the other.
std::vector<double> stepsBetween(const CorridorEnds& ends)
{
    std::vector<double> steps;
    for (double along = ends.held; along < ends.tip - 0.5 * kWallsEach.si;
         along = ends.held + double(steps.size()) * kWallsEach.si)
        steps.push_back(along);
    steps.push_back(ends.tip);
    return steps;
}

/// The line from one end of a corridor to the other at these steps.
std::vector<Vec3> lineBetween(const MotionPatient& patient, const TipWay& way,
                              const TissueAroundWay& tissue, const CorridorEnds& ends,
                              std::span<const double> steps)
{
    const HeldTissue held{tissue.X_AJ, {}};
    const double straight = std::min(ends.tip, way.fork); // the corner is left before the larynx
    const Vec3 offWay = ends.p_A_tip - placeOnWay(patient, way, ends.tip, held);
    std::vector<Vec3> line;
    for (const double along : steps) {
        const double share = (along - ends.held) / (ends.tip - ends.held);
        const double u = std::clamp((along - ends.held) / (straight - ends.held), 0.0, 1.0);
        const double corner = 1.0 - u * u * (3.0 - 2.0 * u);
        line.push_back(placeOf(patient, way, along, held) + corner * ends.corner_A
                       + share * offWay);
    }
    return line;
}

/// How sharply a line bends at one of its points, per metre, and to where.
Vec3 bendAt(std::span<const Vec3> line, std::size_t i)
{
    constexpr std::size_t kReach = 3; // points to either side
    const std::size_t first = i > kReach ? i - kReach : 0;
    const std::size_t last = std::min(i + kReach, line.size() - 1);
    if (first == i || last == i)
        return Vec3::Zero();
    const Vec3 before = line[i] - line[first];
    const Vec3 behind = line[last] - line[i];
    return 2.0 * (behind.normalized() - before.normalized()) / (before.norm() + behind.norm());
}

/// No farther to the inside of a bend than kInsideOfBend of its radius.
void limitInside(CorridorPlace& place, const Vec3& bend)
{
    for (const std::size_t c : {0U, 1U}) {
        const double perMetre = bend.dot(place.axes.col(Eigen::Index(c)));
        const double most = kInsideOfBend / std::abs(perMetre);
        if (perMetre > 0.0)
            place.most[c] = std::min(place.most[c], most);
        if (perMetre < 0.0)
            place.least[c] = std::max(place.least[c], -most);
    }
}

} // namespace

TubeCorridor tubeCorridor(const MotionPatient& patient, const TipWay& way,
                          const TissueAroundWay& tissue, const CorridorEnds& ends,
                          Length tubeRadius)
{
    const MovedWalls walls{patient, way, tissue};
    const std::vector<double> steps = stepsBetween(ends);
    const std::vector<Vec3> line = lineBetween(patient, way, tissue, ends, steps);
    TubeCorridor corridor;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec3 direction = line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0];
        CorridorPlace place{.p_A = line[i],
                            .axes = acrossAxesOf(direction).value_or(Mat3::Identity())};
        const WallsAround around = walls.at(std::max(steps[i], way.teeth));
        const double less = tubeRadius.si - kFunnel * std::max(way.teeth - steps[i], 0.0);
        const auto roomTo = [&](WallSide side, const Vec3& axis) {
            return std::max((around.at(side) - place.p_A).dot(axis) - less, 0.0);
        };
        const Vec3 left = place.axes.col(0);
        const Vec3 front = place.axes.col(1);
        place.most = {roomTo(WallSide::Left, left), roomTo(WallSide::Front, front)};
        place.least = {-roomTo(WallSide::Right, -left), -roomTo(WallSide::Back, -front)};
        limitInside(place, bendAt(line, i));
        corridor.push_back(place);
    }
    return corridor;
}

} // namespace carina
