#include "engine/airway/lumen/evened_way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace carina
{
namespace
{

constexpr int kEvenRounds = 12; ///< of ours, as kEvenShare
constexpr double kEvenShare = 0.9;
constexpr double kMostOfApart = 0.7;   ///< of the way to the plane of a neighbour
constexpr double kMostBeyond = 0.3e-3; ///< metres that a corner may go inwards
constexpr double kLeastCornerCosine =
    0.3; ///< between the way to a corner and across its neighbours
constexpr std::size_t kMostCuts = 64;
constexpr double kMostSlope = 0.4;    ///< of the sides along the way
constexpr double kLeastRoom = 0.4e-3; ///< metres: in what a tube fills
constexpr double kLeastToEven = 1e-3; ///< metres: what is narrower keeps its middle

using AcrossSection = Eigen::Vector2d;
using SectionCorners = std::array<AcrossSection, kLumenDirections>;

const SectionCorners& sectionDirections()
{
    static const SectionCorners made = [] {
        const AcrossWay plane{Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()};
        SectionCorners all;
        for (std::size_t k = 0; k < kLumenDirections; ++k)
            all[k] = plane.direction(k).head<2>();
        return all;
    }();
    return made;
}

SectionCorners cornersOf(const MovedSection& section)
{
    SectionCorners corners;
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        corners[k] = section.reach[k] * sectionDirections()[k];
    return corners;
}

double crossOf(const AcrossSection& a, const AcrossSection& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// How far it is from a place within a polygon to its nearest side in a direction.
double reachFrom(const AcrossSection& from, const AcrossSection& direction,
                 const SectionCorners& corners)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kLumenDirections; ++k) {
        const AcrossSection side = corners[(k + 1) % kLumenDirections] - corners[k];
        const double across = crossOf(direction, side);
        if (across <= 0.0) // it is seen from outside
            continue;
        const AcrossSection there = corners[k] - from;
        const double share = crossOf(there, direction) / across;
        const double way = crossOf(there, side) / across;
        if (share >= -1e-9 && share <= 1.0 + 1e-9 && way >= 0.0)
            nearest = std::min(nearest, way);
    }
    return nearest < std::numeric_limits<double>::infinity() ? nearest : MovedSection::kLeastReach;
}

/// How far it is from the centre to the side before a direction, unit.
double reachOfCorners(const AcrossSection& direction, const SectionCorners& corners)
{
    constexpr double kEach = 2.0 * std::numbers::pi / kLumenDirections;
    const double turns = std::atan2(direction.y(), direction.x()) / kEach;
    const auto k = std::size_t(std::floor(turns) + kLumenDirections) % kLumenDirections;
    const AcrossSection side = corners[(k + 1) % kLumenDirections] - corners[k];
    return crossOf(corners[k], side) / crossOf(direction, side);
}

/// No farther from the old centre than a share of the way to the wall.
AcrossSection kept(const AcrossSection& off, const SectionCorners& corners)
{
    const double length = off.norm();
    if (!(length > 0.0))
        return off;
    const double most = kMostOfReach * reachOfCorners(off / length, corners);
    return length > most ? AcrossSection{off * (most / length)} : off;
}

Vec3 alongSection(const MovedSection& section) { return section.back.cross(section.side); }

/// Planes of neighbours meet at the inner side of a bend: so far, and no farther, a section goes.
void keepBefore(MovedSection& section, const MovedSection& neighbour)
{
    const Vec3 normal = alongSection(neighbour);
    const double apart = (neighbour.p_A_centre - section.p_A_centre).dot(normal);
    for (std::size_t k = 0; k < kLumenDirections; ++k) {
        const Vec3 out =
            sectionDirections()[k].x() * section.side + sectionDirections()[k].y() * section.back;
        const double nearer = out.dot(normal) / apart; // of `apart`, per metre
        if (nearer * section.reach[k] > kMostOfApart)
            section.reach[k] = kMostOfApart / nearer;
    }
}

/// Distances from a centre in the directions: of corners, or of sides across them.
using Reach = std::array<double, kLumenDirections>;

/// Cosines between a direction and the next ones, as far as they are above 0.
constexpr auto kAcute = std::size_t(kLumenDirections / 4);
const std::array<double, kAcute>& cosinesBeside()
{
    static const auto cosines = [] {
        std::array<double, kAcute> made{};
        for (std::size_t k = 0; k < kAcute; ++k)
            made[k] = std::cos(2.0 * std::numbers::pi * double(k) / double(kLumenDirections));
        return made;
    }();
    return cosines;
}

/// Calls with each direction that is less than a right angle from another one, and the cosine.
template <class Call> void forBeside(std::size_t k, Call&& call)
{
    const std::array<double, kAcute>& cosines = cosinesBeside();
    call(k, 1.0);
    for (std::size_t i = 1; i < kAcute; ++i) {
        call((k + i) % kLumenDirections, cosines[i]);
        call((k + kLumenDirections - i) % kLumenDirections, cosines[i]);
    }
}

/// Without what lies beyond the line through a corner that goes inwards.
/// @param isAcross the line stands across the way to the corner; else it goes along its neighbours
void cutAt(std::size_t corner, bool isAcross, Reach& corners)
{
    const std::size_t next = (corner + 1) % kLumenDirections;
    const std::size_t before = (corner + kLumenDirections - 1) % kLumenDirections;
    const AcrossSection along =
        corners[next] * sectionDirections()[next] - corners[before] * sectionDirections()[before];
    AcrossSection out = AcrossSection{along.y(), -along.x()}.normalized();
    double cosine = out.dot(sectionDirections()[corner]);
    if (isAcross || !(cosine > kLeastCornerCosine)) {
        out = sectionDirections()[corner];
        cosine = 1.0;
    }
    const double distance = cosine * corners[corner];
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        if (const double there = out.dot(sectionDirections()[k]); there * corners[k] > distance)
            corners[k] = distance / there;
}

/// The distances of sides that enclose all corners.
Reach sidesOf(const Reach& corners)
{
    Reach sides{};
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        forBeside(k, [&](std::size_t i, double cosine) {
            sides[k] = std::max(sides[k], cosine * corners[i]);
        });
    return sides;
}

/// How far these sides are from the centre in a direction.
double reachOf(const Reach& sides, std::size_t k)
{
    double nearest = std::numeric_limits<double>::infinity();
    forBeside(
        k, [&](std::size_t i, double cosine) { nearest = std::min(nearest, sides[i] / cosine); });
    return nearest;
}

/// The largest part without inward corners that is found by cutting one after the other.
Reach convexSides(Reach corners)
{
    std::array<bool, kLumenDirections> isCut{};
    for (std::size_t cuts = 0;; ++cuts) {
        const Reach sides = sidesOf(corners);
        double most = kMostBeyond;
        std::size_t worst = kLumenDirections;
        for (std::size_t k = 0; k < kLumenDirections; ++k)
            if (const double beyond = reachOf(sides, k) - corners[k]; beyond > most) {
                most = beyond;
                worst = k;
            }
        if (worst == kLumenDirections || cuts == kMostCuts)
            return sides;
        cutAt(worst, std::exchange(isCut[worst], true), corners);
    }
}

/// And what is far beside a narrow place of the way.
void keepNear(MovedSection& section, const MovedSection& neighbour, double apart)
{
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        section.reach[k] = std::min(section.reach[k], neighbour.reach[k] + kMostSlope * apart);
}

} // namespace

void evenOut(MovedWay& way, double mostRoom)
{
    const std::size_t count = way.sections.size();
    std::vector<SectionCorners> corners(count);
    std::vector<AcrossSection> offs(count, AcrossSection::Zero());
    std::vector<Vec3> line(count);
    for (std::size_t i = 0; i < count; ++i) {
        corners[i] = cornersOf(way.sections[i]);
        line[i] = way.sections[i].p_A_centre;
    }
    for (int round = 0; round < kEvenRounds; ++round)
        for (std::size_t i = 1; i + 1 < count; ++i) {
            const MovedSection& section = way.sections[i];
            if (section.spare < kLeastToEven)
                continue;
            const Vec3 towards = kEvenShare * (0.5 * (line[i - 1] + line[i + 1]) - line[i]);
            offs[i] =
                kept(offs[i] + AcrossSection{towards.dot(section.side), towards.dot(section.back)},
                     corners[i]);
            line[i] = section.p_A_centre + offs[i].x() * section.side + offs[i].y() * section.back;
        }
    for (std::size_t i = 0; i < count; ++i) {
        MovedSection& section = way.sections[i];
        if (offs[i] != AcrossSection::Zero())
            for (std::size_t k = 0; k < kLumenDirections; ++k)
                section.reach[k] = std::max(reachFrom(offs[i], sectionDirections()[k], corners[i]),
                                            MovedSection::kLeastReach);
        section.p_A_centre = line[i];
        way.along[i] = i > 0 ? way.along[i - 1] + (line[i] - line[i - 1]).norm() : 0.0;
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
        keepBefore(way.sections[i], way.sections[i + 1]);
        keepBefore(way.sections[i + 1], way.sections[i]);
    }
    for (MovedSection& section : way.sections) {
        section.reach = convexSides(section.reach);
        // What is too narrow yields to the tube, which need not be in its middle then.
        const double room = kLeastRoom + std::clamp(-section.spare, 0.0, mostRoom);
        for (double& side : section.reach)
            side = std::max(side, room);
    }
    for (std::size_t i = 1; i < count; ++i)
        keepNear(way.sections[i], way.sections[i - 1], way.along[i] - way.along[i - 1]);
    for (std::size_t i = count; i-- > 1;)
        keepNear(way.sections[i - 1], way.sections[i], way.along[i] - way.along[i - 1]);
}

} // namespace carina
