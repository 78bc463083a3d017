#include "engine/airway/lumen/moved_lumen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace carina
{
namespace
{

constexpr auto kHalf = std::size_t(kLumenDirections / 2);
constexpr auto kQuarter = std::size_t(kLumenDirections / 4);
static_assert(kLumenDirections == 16); // kAcross, wedgeOf and kRounding

/// cos and sin of the directions across a way.
constexpr double kDiagonal = 0.5 * std::numbers::sqrt2;
constexpr double kCos = 0.92387953251128674; ///< of 22.5 degrees
constexpr double kSin = 0.38268343236508977;
constexpr std::array<std::array<double, 2>, kLumenDirections> kAcross{{{1.0, 0.0},
                                                                       {kCos, kSin},
                                                                       {kDiagonal, kDiagonal},
                                                                       {kSin, kCos},
                                                                       {0.0, 1.0},
                                                                       {-kSin, kCos},
                                                                       {-kDiagonal, kDiagonal},
                                                                       {-kCos, kSin},
                                                                       {-1.0, 0.0},
                                                                       {-kCos, -kSin},
                                                                       {-kDiagonal, -kDiagonal},
                                                                       {-kSin, -kCos},
                                                                       {0.0, -1.0},
                                                                       {kSin, -kCos},
                                                                       {kDiagonal, -kDiagonal},
                                                                       {kCos, -kSin}}};

/// The eighth of a circle of (u, v), counter-clockwise.
std::size_t eighthOf(double u, double v)
{
    if (v >= 0.0) {
        if (u >= 0.0)
            return v < u ? 0 : 1;
        return v > -u ? 2 : 3;
    }
    if (u < 0.0)
        return -v < -u ? 4 : 5;
    return -v > u ? 6 : 7;
}

/// The direction before (u, v), counter-clockwise.
std::size_t wedgeOf(double u, double v)
{
    const std::size_t middle = 2 * eighthOf(u, v) + 1;
    const auto& [um, vm] = kAcross[middle];
    return um * v - vm * u >= 0.0 ? middle : middle - 1;
}

/// The corners of a section: at so far along a way that these change by `slope` to either side.
struct Reaches {
    const std::array<double, kLumenDirections>& reach;
    const std::array<double, kLumenDirections>& slope;
    double along = 0.0;

    [[nodiscard]] double at(std::size_t k) const
    {
        return std::max(reach[k] + along * slope[k], MovedSection::kLeastReach);
    }
    [[nodiscard]] double least() const
    {
        double least = at(0);
        for (std::size_t k = 1; k < kLumenDirections; ++k)
            least = std::min(least, at(k));
        return least;
    }
};

/// Depth beyond a rounded polygon about the origin, along the line from there, and its gradient.
struct PolygonDepth {
    double depth = 0.0;
    double byU = 0.0, byV = 0.0;
    double byAlong = 0.0;
    double curvature = 0.0; ///< second derivative along the wall, across the way; of places beyond
};
/// 1 / reach is a quadratic spline of the direction: round between the corners, and a circle where
/// these lie on one. Without kRounding a straight wall would be left behind by 2 percent of its
/// distance; with it by half of that, and a circle is as much too small.
PolygonDepth polygonDepth(double u, double v, const Reaches& corners)
{
    constexpr double kRounding = 1.01;
    const double r = std::sqrt(u * u + v * v);
    if (!(r > 0.0))
        return {.depth = -corners.least() / kRounding};
    const std::size_t k = wedgeOf(u, v);
    const auto& [uk, vk] = kAcross[k];
    const auto& [un, vn] = kAcross[(k + 1) % kLumenDirections];
    // The share of the way from direction k to the next.
    const double a = u * vn - v * un;
    const double b = uk * v - vk * u;
    const double share = b / (a + b);
    const double perBoth = 1.0 / ((a + b) * (a + b));
    const double shareByU = (-vk * a - b * vn) * perBoth;
    const double shareByV = (uk * a + b * un) * perBoth;
    const std::size_t m = share < 0.5 ? k : (k + 1) % kLumenDirections;
    const double f = share < 0.5 ? share : share - 1.0;
    const std::array at{(m + kLumenDirections - 1) % kLumenDirections, m,
                        (m + 1) % kLumenDirections};
    const std::array weight{0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f, 0.5 * (0.5 + f) * (0.5 + f)};
    const std::array change{f - 0.5, -2.0 * f, 0.5 + f};
    constexpr std::array kSecond{1.0, -2.0, 1.0};
    double inverse = 0.0;
    double byShare = 0.0;
    double second = 0.0; // by the share, twice
    double byAlong = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double perReach = 1.0 / corners.at(at[i]);
        const double one = kRounding * perReach;
        inverse += weight[i] * one;
        byShare += change[i] * one;
        second += kSecond[i] * one;
        byAlong -= weight[i] * one * corners.slope[at[i]] * perReach;
    }
    const double radius = 1.0 / inverse;
    const double steep = radius * radius;
    PolygonDepth depth{.depth = r - radius,
                       .byU = u / r + steep * byShare * shareByU,
                       .byV = v / r + steep * byShare * shareByV,
                       .byAlong = steep * byAlong};
    if (depth.depth > 0.0) {
        const double shareByAngle = u * shareByV - v * shareByU;
        const double first = byShare * shareByAngle;
        depth.curvature =
            1.0 / r
            + steep * (second * shareByAngle * shareByAngle - 2.0 * radius * first * first)
                  / (r * r);
    }
    return depth;
}

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
                  const TissueMotion& push)
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
        const Vec3 along = about[std::min(i + 1, about.size() - 1)] - about[i > 0 ? i - 1 : 0];
        const AcrossWay across = acrossWay(along);
        way.sections.push_back(middled(about[i], across, corners[i],
                                       roomOf(sections[i], allMoves[i], across, push),
                                       sections[i].give.si));
        way.along.push_back(
            i > 0 ? way.along.back()
                        + (way.sections[i].p_A_centre - way.sections[i - 1].p_A_centre).norm()
                  : 0.0);
    }
    return way;
}

} // namespace

TissueMotion tissueMotion(const AirwayField& changes, const FollowingThroat& throat)
{
    return [&](const Vec3& p_A_made, AirwayTissue tissue) {
        Vec3 p_A = p_A_made + airwayPull<double>(changes.frame(), tissue, p_A_made).d;
        p_A = throat.neck.placed(p_A);
        if (tissue != AirwayTissue::Teeth && tissue != AirwayTissue::Skin)
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
        made.ways[w] = movedWay(lumen.ways[w], motion, isTrunk ? push : TissueMotion{});
        if (made.ways[w].isThere())
            made.begins[w] = made.ways[w].along[lumen.begins[w]];
    }
    made.teeth = made.ways.front().along[lumen.teeth];
    made.glottis = made.ways.front().along[lumen.glottis];
    return made;
}

MovedLumen unmoved(const AirwayLumen& lumen)
{
    return moved(lumen, [](const Vec3& p_A, AirwayTissue /*tissue*/) { return p_A; });
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

WallTouch MovedPiece::touch(const Vec3& p_A) const
{
    const Vec3 from = p_A - section.p_A_centre;
    const double u = from.dot(section.side);
    const double v = from.dot(section.back);
    const double ahead = from.dot(along);
    const double there = std::clamp(ahead, -before, after);
    const PolygonDepth across = polygonDepth(u, v, {section.reach, slope, there});
    Vec3 out = across.byU * section.side + across.byV * section.back;
    if (there == ahead)
        out += across.byAlong * along;
    const double perLength =
        across.curvature > 0.0 ? std::sqrt(across.curvature) / std::hypot(u, v) : 0.0;
    const Vec3 round = perLength * (u * section.back - v * section.side);
    return {across.depth, out, round};
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

MovedPiece MovedLumen::pieceAt(AirwayWay which, std::size_t segment, double along) const
{
    const MovedWay& it = way(which);
    const MovedSection& a = it.sections[segment];
    const MovedSection& b = it.sections[segment + 1];
    const double length = it.along[segment + 1] - it.along[segment];
    MovedPiece piece{.section = between(a, b, (along - it.along[segment]) / length),
                     .along = (b.p_A_centre - a.p_A_centre) / length,
                     .before = along - it.along[segment],
                     .after = it.along[segment + 1] - along};
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        piece.slope[k] = (b.reach[k] - a.reach[k]) / length;
    return piece;
}

WallTouch MovedLumen::touchIn(AirwayWay which, double stop, const Vec3& p_A,
                              std::size_t& segment) const
{
    const MovedWay& it = way(which);
    const double place = std::min(it.alongAt(p_A, segment), stop);
    std::size_t s = segment;
    while (s > 0 && it.along[s] > place)
        --s;
    const MovedPiece piece = pieceAt(which, s, place);
    const double beyond = (p_A - piece.section.p_A_centre).dot(piece.along);
    if (which == AirwayWay::Trunk && place <= 0.0 && beyond < 0.0)
        return {};
    const WallTouch across = piece.touch(p_A);
    const bool isAtEnd = place >= std::min(stop, it.along.back()) && beyond > 0.0;
    if (!isAtEnd)
        return across;
    const double beside = std::max(across.depth, 0.0);
    const double depth = std::hypot(beside, beyond);
    return {depth, (beside * across.out + beyond * piece.along) / depth, Vec3::Zero()};
}

} // namespace carina
