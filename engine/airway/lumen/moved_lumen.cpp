#include "engine/airway/lumen/moved_lumen.h"

#include "engine/airway/lumen/evened_way.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

constexpr auto kHalf = std::size_t(kLumenDirections / 2);
constexpr auto kQuarter = std::size_t(kLumenDirections / 4);

/// Sections on either side over which the direction of a way is taken, so that the planes of
/// neighbours hardly turn against each other where their middles lie beside each other: of ours.
constexpr std::size_t kEvenly = 3;

// evenOut: walls of the trunk are measured, those of the other ways are of usual widths. Of ours.
constexpr double kRoomInTrunk = 0.1e-3;
constexpr double kRoomInBranches = 2e-3;

/// Of a section the axes, and the corners from the middle between them.
/// @param room by which the corners are farther away than that
MovedSection middled(const Vec3& p_A_about, const AcrossWay& across,
                     const std::array<Vec3, kLumenDirections>& corners,
                     const std::array<double, kLumenDirections>& room, double give)
{
    MovedSection section{.side = across.side, .back = across.back, .give = give};
    const auto between = [&](const Vec3& axis, std::size_t k) {
        return 0.5 * (corners[k] + corners[k + kHalf] - 2.0 * p_A_about).dot(axis);
    };
    section.p_A_centre = p_A_about + between(across.side, 0) * across.side
                         + between(across.back, kQuarter) * across.back;
    std::array<double, kLumenDirections> reach{};
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        reach[k] = (corners[k] - section.p_A_centre).dot(across.direction(k)) + room[k];
    section.spare = 0.5 * (reach[0] + reach[kHalf]);
    for (std::size_t k = 0; k < kHalf; ++k)
        section.spare = std::min(section.spare, 0.5 * (reach[k] + reach[k + kHalf]));
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        section.reach[k] = std::max(reach[k], MovedSection::kLeastReach);
    return section;
}

MovedSection between(const MovedSection& a, const MovedSection& b, double share)
{
    MovedSection section{.p_A_centre = a.p_A_centre + share * (b.p_A_centre - a.p_A_centre),
                         .side = a.side + share * (b.side - a.side),
                         .back = a.back + share * (b.back - a.back)};
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        section.reach[k] = a.reach[k] + share * (b.reach[k] - a.reach[k]);
    section.spare = a.spare + share * (b.spare - a.spare);
    section.give = a.give + share * (b.give - a.give);
    return section;
}

/// By how much the corners of a section move: those between by the share of the others.
std::array<Vec3, kLumenDirections> movesOf(const LumenSection& section, const TissueMotion& motion)
{
    std::array<Vec3, kLumenDirections> moves;
    for (std::size_t k = 0; k < kLumenDirections; k += kQuarter) {
        const LumenLimit& limit = section.limits[k];
        moves[k] = motion(limit.p_A_wall, limit.tissue) - limit.p_A_wall;
    }
    for (std::size_t k = 0; k < kLumenDirections; k += kQuarter) {
        const Vec3& next = moves[(k + kQuarter) % kLumenDirections];
        for (std::size_t i = 1; i < kQuarter; ++i)
            moves[k + i] = moves[k] + double(i) / double(kQuarter) * (next - moves[k]);
    }
    return moves;
}

/// How far walls at these moves are pushed away from the way, in its directions.
std::array<double, kLumenDirections> roomOf(const LumenSection& section,
                                            const std::array<Vec3, kLumenDirections>& moves,
                                            const AcrossWay& across, const TissueMotion& push)
{
    std::array<double, kLumenDirections> room{};
    if (push)
        for (std::size_t k = 0; k < kLumenDirections; ++k) {
            const LumenLimit& limit = section.limits[k];
            const Vec3 p_A = limit.p_A_wall + moves[k];
            room[k] = std::max((push(p_A, limit.tissue) - p_A).dot(across.direction(k)), 0.0);
        }
    return room;
}

MovedWay movedWay(const std::vector<LumenSection>& sections, const TissueMotion& motion,
                  const TissueMotion& push, double mostRoom)
{
    MovedWay way;
    std::vector<std::array<Vec3, kLumenDirections>> corners(sections.size());
    std::vector<std::array<Vec3, kLumenDirections>> allMoves(sections.size());
    std::vector<Vec3> about(sections.size());
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const auto& moves = allMoves[i] = movesOf(sections[i], motion);
        about[i] = sections[i].p_A_centre
                   + 0.25 * (moves[0] + moves[kQuarter] + moves[kHalf] + moves[kHalf + kQuarter]);
        for (std::size_t k = 0; k < kLumenDirections; ++k) {
            const LumenLimit& limit = sections[i].limits[k];
            corners[i][k] = limit.p_A_wall + limit.fromWall + moves[k];
        }
    }
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const AcrossWay across = acrossWay(about[std::min(i + kEvenly, about.size() - 1)]
                                           - about[i > kEvenly ? i - kEvenly : 0]);
        way.sections.push_back(middled(about[i], across, corners[i],
                                       roomOf(sections[i], allMoves[i], across, push),
                                       sections[i].give.si));
        way.along.push_back(0.0);
        way.middles.push_back(way.sections.back().p_A_centre);
    }
    evenOut(way, mostRoom);
    return way;
}

} // namespace

TissueMotion tissueMotion(const AirwayField& changes, const FollowingThroat& throat)
{
    return [&](const Vec3& p_A_made, AirwayTissue tissue) {
        Vec3 p_A = p_A_made + airwayPull<double>(changes.frame(), tissue, p_A_made).d;
        p_A = throat.neck.placed(p_A);
        if (((kUpperTeethTissues | only(AirwayTissue::Skin)) & only(tissue)) == 0)
            p_A += throatPull(throat,
                              tissue == AirwayTissue::Pharynx ? ThroatTissue::Pharynx
                                                              : ThroatTissue::Airway,
                              p_A)
                       .d;
        return p_A;
    };
}

TissueMotion bladePushing(const BladeField& blade)
{
    if (!blade.isThere())
        return {};
    return [&](const Vec3& p_A, AirwayTissue tissue) {
        return Vec3{p_A + bladePull<double>(blade.frame(), tissue, p_A).d};
    };
}

MovedLumen moved(const AirwayLumen& lumen, const TissueMotion& motion, const TissueMotion& push)
{
    MovedLumen made;
    made.tubeRadius = lumen.tubeRadius;
    for (std::size_t w = 0; w < kAirwayWays; ++w) {
        // Of the ways only the trunk leads along a tongue.
        const bool isTrunk = w == std::size_t(AirwayWay::Trunk);
        made.ways[w] = movedWay(lumen.ways[w], motion, isTrunk ? push : TissueMotion{},
                                isTrunk ? kRoomInTrunk : kRoomInBranches);
        if (made.ways[w].isThere())
            made.begins[w] = made.ways[w].along[lumen.begins[w]];
    }
    made.teeth = made.ways.front().along[lumen.teeth];
    made.glottis = made.ways.front().along[lumen.glottis];
    return made;
}

std::size_t MovedWay::nearestSegment(const Vec3& p_A) const
{
    // Every fourth section, then step by step.
    constexpr std::size_t kStride = 4;
    std::size_t best = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sections.size(); i += kStride) {
        const double squared = (sections[i].p_A_centre - p_A).squaredNorm();
        if (squared < nearest) {
            nearest = squared;
            best = i;
        }
    }
    std::size_t segment = std::min(best, sections.size() - 2);
    static_cast<void>(alongAt(p_A, segment));
    return segment;
}

double MovedWay::fromMiddles(const Vec3& p_A) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < middles.size(); ++i) {
        const Vec3 step = middles[i + 1] - middles[i];
        const double share =
            std::clamp((p_A - middles[i]).dot(step) / step.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p_A - middles[i] - share * step).squaredNorm());
    }
    return std::sqrt(nearest);
}

double MovedWay::alongAt(const Vec3& p_A, std::size_t& segment) const
{
    constexpr int kMostSteps = 12;
    double share = 0.0;
    int last = 0;
    for (int i = 0; i < kMostSteps; ++i) {
        const Vec3 step = sections[segment + 1].p_A_centre - sections[segment].p_A_centre;
        share = (p_A - sections[segment].p_A_centre).dot(step) / step.squaredNorm();
        const int towards = share < 0.0 && segment > 0                     ? -1
                            : share > 1.0 && segment + 2 < sections.size() ? 1
                                                                           : 0;
        // Where it is beyond both, at the outside of a bend, the place between them is the nearest.
        if (towards == 0 || towards == -last)
            break;
        segment = towards > 0 ? segment + 1 : segment - 1;
        last = towards;
    }
    const double length = along[segment + 1] - along[segment];
    return along[segment] + std::clamp(share, 0.0, 1.0) * length;
}

double MovedWay::stopBehind(double from) const
{
    const auto over = [this](std::size_t i) { return sections[i].spare + sections[i].give; };
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (along[i] < from || over(i) >= 0.0)
            continue;
        if (i == 0 || over(i - 1) <= 0.0)
            return std::max(along[i > 0 ? i - 1 : 0], from);
        const double share = over(i - 1) / (over(i - 1) - over(i));
        return std::max(along[i - 1] + share * (along[i] - along[i - 1]), from);
    }
    return along.back();
}

MovedSection MovedLumen::sectionAt(AirwayWay which, double along) const
{
    const MovedWay& it = way(which);
    const auto after = std::ranges::upper_bound(it.along, along);
    const auto s = std::size_t(std::clamp<std::ptrdiff_t>(after - it.along.begin(), 1,
                                                          std::ptrdiff_t(it.along.size()) - 1))
                   - 1;
    return between(it.sections[s], it.sections[s + 1],
                   std::clamp((along - it.along[s]) / (it.along[s + 1] - it.along[s]), 0.0, 1.0));
}

} // namespace carina
