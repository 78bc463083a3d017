#include "engine/airway/lumen/measured_lumen.h"

#include "engine/airway/lumen/wall_surfaces.h"
#include "engine/anatomy/airway/centreline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace carina
{
namespace
{

constexpr Length kSpacing = millimetres(4.0);
constexpr double kFunnel = 0.03;                ///< metres in front of the teeth
constexpr Length kRightMain = millimetres(7.0); ///< radius in an adult, of textbooks
constexpr Length kLeftMain = millimetres(6.0);
constexpr double kAtCarina = 0.012;      ///< metres of an adult above it
constexpr double kRoundOfFunnel = 0.015; ///< metres: radius of its edge at the teeth
constexpr double kLeastBall = 5e-4;      ///< metres
constexpr double kAboveCords = 0.012;    ///< metres of an adult, within which the cords yield
constexpr double kBelowCords = 0.006;
constexpr double kPharynxFrom = 0.05; ///< before the glottis: the mouth ends
constexpr double kBranchOff = 0.014;  ///< above the carina, where main bronchi leave the trunk
constexpr double kEntrance = 0.03;    ///< above the cords, where the way to the oesophagus does
constexpr double kBehindArytenoids = 0.017; ///< behind the middle of the cords
constexpr double kOesophagusLength = 0.2;

/// Of one patient.
struct Patient {
    std::span<const AnatomyPart> parts;
    const AirwayLandmarks& landmarks;
    double radius; ///< of the tube, metres
    double size;   ///< kReferenceDepth being 1
};

/// Where a place of the trunk is, in metres of an adult.
struct TrunkPlace {
    double pastTeeth, pastGlottis;
};

double mostReach(const TrunkPlace& at)
{
    if (at.pastTeeth < 0.0)
        return kMouth.si + 0.5 * at.pastTeeth * at.pastTeeth / kRoundOfFunnel;
    if (at.pastGlottis < -kPharynxFrom)
        return kMouth.si;
    return at.pastGlottis < -kAboveCords ? kPharynx.si : kLarynx.si;
}

Length giveAt(const TrunkPlace& at)
{
    if (at.pastGlottis < -kAboveCords)
        return kGiveOfThroat;
    return at.pastGlottis < kBelowCords ? kGiveOfCords : kGiveOfWall;
}

AirwayTissue usualTissue(const TrunkPlace& at)
{
    if (at.pastTeeth < 0.0)
        return AirwayTissue::Teeth;
    if (at.pastGlottis < -kAboveCords)
        return AirwayTissue::Pharynx;
    return at.pastGlottis < kBelowCords ? AirwayTissue::Larynx : AirwayTissue::Windpipe;
}

constexpr double kMostAside = 6e-3; ///< metres, from a section to the next; of ours
constexpr double kBackToLine = 0.85;

/// Away from walls that are nearer than the tube's radius, across the way.
Vec3 takenOff(Vec3 p_A, const WallSurfaces& walls, const AcrossWay& across, double radius)
{
    constexpr int kRounds = 12;
    for (int i = 0; i < kRounds; ++i) {
        const auto wall = walls.nearestTo(p_A);
        if (!wall || wall->distance >= radius)
            break;
        Vec3 away = wall->distance > 0.0 ? Vec3{p_A - wall->p_A} : Vec3{wall->p_A - p_A};
        away -= away.dot(across.along) * across.along;
        if (!(away.norm() > 1e-9))
            break;
        p_A += 0.5 * (radius - wall->distance) * away.normalized();
    }
    return p_A;
}

/// The ball that fits at a place, no thicker than the tube.
double ballAt(const Vec3& p_A, const WallSurfaces& walls, double radius)
{
    const auto wall = walls.nearestTo(p_A);
    return wall ? std::clamp(wall->distance - 1e-4, kLeastBall, radius) : radius;
}

Vec3 toTheMiddle(Vec3 p_A, const WallSurfaces& walls, const AcrossWay& across, double radius,
                 double most)
{
    const double ball = ballAt(p_A, walls, radius);
    for (const Vec3& axis : {across.side, across.back}) {
        const double there = walls.wayOfBall(p_A, axis, ball, most);
        const double back = walls.wayOfBall(p_A, -axis, ball, most);
        p_A += 0.5 * (there - back) * axis;
    }
    return p_A;
}

LumenSection measured(const Vec3& p_A_centre, const WallSurfaces& walls, const AcrossWay& across,
                      double radius, double most, AirwayTissue usual)
{
    LumenSection section{.p_A_centre = p_A_centre};
    const double ball = ballAt(p_A_centre, walls, radius);
    for (std::size_t k = 0; k < kLumenDirections; ++k) {
        const Vec3 direction = across.direction(k);
        const double way = walls.wayOfBall(p_A_centre, direction, ball, most - ball);
        const Vec3 p_A = p_A_centre + (way + ball - radius) * direction;
        const auto wall = walls.nearestTo(p_A_centre + way * direction);
        const bool touches = wall && std::abs(wall->distance) < ball + 2e-4;
        const Vec3 p_A_wall = touches ? wall->p_A : Vec3{p_A_centre + (way + ball) * direction};
        // Far from the pharynx's wall at the front is its tongue.
        const bool isTongue = usual == AirwayTissue::Pharynx && k > kLumenDirections / 2;
        section.limits[k] = {p_A_wall, p_A - p_A_wall,
                             touches    ? wall->tissue
                             : isTongue ? AirwayTissue::Throat
                                        : usual};
    }
    return section;
}

LumenSection round(const Vec3& p_A_centre, const AcrossWay& across, double lumenRadius,
                   double tubeRadius, AirwayTissue tissue)
{
    LumenSection section{.p_A_centre = p_A_centre};
    for (std::size_t k = 0; k < kLumenDirections; ++k)
        section.limits[k] = {p_A_centre + lumenRadius * across.direction(k),
                             -tubeRadius * across.direction(k), tissue};
    return section;
}

/// From the centre of a section to its nearest corner, metres.
double leastWidth(const LumenSection& section)
{
    double least = std::numeric_limits<double>::infinity();
    for (const LumenLimit& limit : section.limits)
        least = std::min(least, (limit.p_A_wall + limit.fromWall - section.p_A_centre).norm());
    return least;
}

AcrossWay acrossAt(std::span<const Vec3> line, std::size_t i)
{
    return acrossWay(line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]);
}

/// The point of a line nearest to a place.
std::size_t nearestOf(std::span<const Vec3> line, const Vec3& p_A)
{
    const auto nearest =
        std::ranges::min_element(line, {}, [&](const Vec3& p) { return (p - p_A).squaredNorm(); });
    return std::size_t(nearest - line.begin());
}

/// Of a path from in front of the teeth what a funnel and the airway need.
Centreline trunkOf(const AirwayLandmarks& landmarks)
{
    const Centreline fine = evenlySpaced(landmarks.path_A, 0.25 * kSpacing);
    const std::size_t teeth = nearestOf(fine, landmarks.p_A_incisors);
    const auto funnel = std::size_t(kFunnel / (0.25 * kSpacing.si));
    return evenlySpaced(std::span{fine}.subspan(teeth > funnel ? teeth - funnel : 0), kSpacing);
}

void measureTrunk(AirwayLumen& lumen, const Patient& patient, const Centreline& line,
                  const WallSurfaces& walls)
{
    lumen.teeth = nearestOf(line, patient.landmarks.p_A_incisors);
    lumen.glottis = nearestOf(line, patient.landmarks.p_A_glottis);
    const double step = lengthOf(line).si / double(line.size() - 1) / patient.size;
    std::vector<LumenSection>& sections = lumen.ways[std::size_t(AirwayWay::Trunk)];
    for (std::size_t i = 0; i < line.size(); ++i) {
        const TrunkPlace at{(double(i) - double(lumen.teeth)) * step,
                            (double(i) - double(lumen.glottis)) * step};
        const AcrossWay across = acrossAt(line, i);
        const double most = patient.size * mostReach(at);
        if (at.pastTeeth < 0.0) {
            sections.push_back(round(line[i], across, most, patient.radius, AirwayTissue::Teeth));
        } else {
            // The ridge of the carina is in the way of balls, not of tubes, which go by its sides.
            const bool isAtCarina =
                (double(line.size()) - double(i)) * step < kAtCarina && !sections.empty();
            if (isAtCarina) {
                const LumenSection& above = sections.back();
                sections.push_back(round(line[i], across, leastWidth(above) + patient.radius,
                                         patient.radius, AirwayTissue::Windpipe));
                sections.back().give = above.give;
                continue;
            }
            const auto middleFrom = [&](const Vec3& p_A) {
                return toTheMiddle(takenOff(p_A, walls, across, patient.radius), walls, across,
                                   patient.radius, 0.5 * most);
            };
            // Where the line crosses palate or epiglottis the way stays on its side of that, and
            // comes back to the line behind it.
            const Vec3 before = sections.back().p_A_centre - line[i - 1];
            const Vec3 off = before - before.dot(across.along) * across.along;
            Vec3 p_A = middleFrom(line[i]);
            if ((p_A - line[i] - off).norm() > kMostAside * patient.size)
                p_A = middleFrom(line[i] + kBackToLine * off);
            sections.push_back(measured(p_A, walls, across, patient.radius, most, usualTissue(at)));
        }
        sections.back().give = patient.size * giveAt(at);
    }
}

/// The middle of a part's corners between two distances from the carina; nothing without any.
std::optional<Vec3> middleAt(std::span<const AnatomyPart> parts, PartRole role, double from,
                             double until, const Vec3& p_A_carina)
{
    Vec3 sum = Vec3::Zero();
    std::size_t count = 0;
    for (const AnatomyPart& part : parts) {
        if (part.role != role)
            continue;
        for (const Vec3f& corner : part.levels.front().positions) {
            const Vec3 p = corner.cast<double>();
            const double distance = (p - p_A_carina).norm();
            if (distance >= from && distance < until && p.z() < p_A_carina.z()) {
                sum += p;
                ++count;
            }
        }
    }
    return count > 0 ? std::optional{Vec3{sum / double(count)}} : std::nullopt;
}

/// From the trunk above the carina into a main bronchus.
Centreline bronchusLine(const Patient& patient, const Centreline& trunk, bool isRight)
{
    const Vec3& p_A_carina = trunk.back();
    const Vec3 down = (trunk.back() - trunk[trunk.size() - 4]).normalized();
    const Vec3 start = trunk[nearestOf(trunk, p_A_carina - patient.size * kBranchOff * down)];
    const PartRole role = isRight ? PartRole::RightMainBronchus : PartRole::LeftMainBronchus;
    // Right 25 degrees from the trachea and 25 mm long, left 45 and 45: of textbooks.
    const double length = (isRight ? 0.028 : 0.045) * patient.size;
    const double angle = (isRight ? degrees(25.0) : degrees(45.0)).si;
    const Vec3 usual =
        std::cos(angle) * down + (isRight ? -1.0 : 1.0) * std::sin(angle) * Vec3::UnitX();
    Centreline line{start};
    for (const double share : {0.35, 0.65, 0.95}) {
        const auto middle = middleAt(patient.parts, role, (share - 0.15) * length,
                                     (share + 0.15) * length, p_A_carina);
        line.push_back(middle ? *middle : Vec3{p_A_carina + share * length * usual});
    }
    return evenlySpaced(line, kSpacing);
}

void addBronchus(AirwayLumen& lumen, const Patient& patient, const Centreline& trunk,
                 AirwayWay which)
{
    const bool isRight = which == AirwayWay::RightMain;
    const Centreline line = bronchusLine(patient, trunk, isRight);
    std::vector<LumenSection>& sections = lumen.ways[std::size_t(which)];
    const double radius = patient.size * (isRight ? kRightMain : kLeftMain).si;
    for (std::size_t i = 0; i < line.size(); ++i) {
        // The first lies within the trunk, at its corners.
        const double there = i == 0 ? patient.radius : radius;
        sections.push_back(
            round(line[i], acrossAt(line, i), there, patient.radius, AirwayTissue::Windpipe));
        sections.back().give = patient.size * kGiveOfWall;
    }
    lumen.begins[std::size_t(which)] = nearestOf(line, trunk.back());
}

/// From the trunk behind the larynx into the oesophagus.
Centreline oesophagusLine(const Patient& patient, const Centreline& trunk, std::size_t glottis)
{
    const auto above = std::size_t(patient.size * kEntrance / kSpacing.si);
    const Vec3 back = acrossAt(trunk, glottis).back;
    Centreline line{trunk[glottis > above ? glottis - above : 0]};
    const Vec3 behind = trunk[glottis] + patient.size * kBehindArytenoids * back;
    line.push_back(behind);
    const double band = 0.01 * patient.size;
    // In levels below the cords: the middle of its surface, or behind the trachea.
    for (double below = 0.03; below <= kOesophagusLength; below += 0.02) {
        const double z = trunk[glottis].z() - below * patient.size;
        Vec3 sum = Vec3::Zero();
        std::size_t count = 0;
        for (const AnatomyPart& part : patient.parts)
            if (part.role == PartRole::Oesophagus)
                for (const Vec3f& p : part.levels.front().positions)
                    if (std::abs(double(p.z()) - z) < 0.5 * band) {
                        sum += p.cast<double>();
                        ++count;
                    }
        const auto beside = std::size_t(below * patient.size / kSpacing.si);
        if (count > 0)
            line.push_back(sum / double(count));
        else if (glottis + beside < trunk.size())
            line.push_back(trunk[glottis + beside] + patient.size * kBehindArytenoids * back);
        else
            break;
    }
    return evenlySpaced(line, kSpacing);
}

void addOesophagus(AirwayLumen& lumen, const Patient& patient, const Centreline& trunk)
{
    const Centreline line = oesophagusLine(patient, trunk, lumen.glottis);
    std::vector<LumenSection>& sections = lumen.ways[std::size_t(AirwayWay::Oesophagus)];
    std::size_t& begins = lumen.begins[std::size_t(AirwayWay::Oesophagus)];
    const double lumenRadius = std::max(patient.size * kOesophagus.si, patient.radius + kLeastBall);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool isAbove = line[i].z() > trunk[lumen.glottis].z();
        if (isAbove)
            begins = i + 1;
        sections.push_back(round(line[i], acrossAt(line, i), lumenRadius, patient.radius,
                                 isAbove ? AirwayTissue::Pharynx : AirwayTissue::Windpipe));
        sections.back().give = patient.size * kGiveOfThroat;
    }
}

} // namespace

bool tellsLumen(PartRole role) { return isAirwayWall(role) || role == PartRole::Oesophagus; }

Result<AirwayLumen> measuredLumen(std::span<const AnatomyPart> parts,
                                  const AirwayLandmarks& landmarks, Length tubeRadius)
{
    constexpr Length kLeastPath = millimetres(50.0);
    constexpr Length kAround = millimetres(45.0);
    const double radius_mm = inMillimetres(tubeRadius);
    if (!(radius_mm >= 1.0 && radius_mm <= 10.0))
        return fail(Errc::OutOfRange, "a tube's radius of " + std::to_string(radius_mm) + " mm");
    if (landmarks.path_A.size() < 2 || lengthOf(landmarks.path_A) < kLeastPath)
        return fail(Errc::NoAirway, "it is too short");
    const Centreline trunk = trunkOf(landmarks);
    const std::size_t teeth = nearestOf(trunk, landmarks.p_A_incisors);
    const Length depth = lengthOf(std::span{trunk}.subspan(teeth));
    if (depth < kLeastPath)
        return fail(Errc::NoAirway, "it is too short");
    const Patient patient{parts, landmarks, tubeRadius.si, depth / kReferenceDepth};
    const WallSurfaces walls{parts, trunk, kAround};
    AirwayLumen lumen;
    lumen.tubeRadius = tubeRadius;
    lumen.isMeasured = !walls.isEmpty();
    measureTrunk(lumen, patient, trunk, walls);
    for (const AirwayWay which : {AirwayWay::RightMain, AirwayWay::LeftMain})
        addBronchus(lumen, patient, trunk, which);
    addOesophagus(lumen, patient, trunk);
    return lumen;
}

} // namespace carina
