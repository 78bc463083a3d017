#include "engine/lungs/drawing/chest_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

// At amplitude 1, as shares of the lungs' height.
constexpr double kDescent = 0.075;
constexpr double kForward = 0.018;
constexpr double kFlare = 0.012;
constexpr double kLift = 0.018;
constexpr double kSag = 0.04;
constexpr double kSlide = 0.0015;
/// Along the oblique fissure from behind, in the middle plane of a lung.
constexpr double kSlideForward = 0.8;
constexpr double kSlideDown = 0.6;

/// Half width and depth of the chest in units of the lungs' height.
struct Proportions {
    double width;
    double depth;
};

Proportions proportionsOf(const ChestField& field)
{
    const Shares<double>& perMetre = field.frame().perMetre;
    return {-perMetre.h / perMetre.u, -perMetre.h / perMetre.v};
}

ChestTerms<double> lungTerms(const LungPose& pose, double shift, const Proportions& proportions)
{
    ChestTerms<double> c;
    c.descent = kDescent * pose.diaphragm;
    c.forward = -kForward / proportions.depth * pose.ribs;
    c.flare = kFlare / proportions.width * pose.ribs;
    c.bulkBack = kSag / proportions.depth * pose.gravity;
    c.shrink = pose.collapse;
    c.shift = shift;
    return c;
}

ChestTerms<double> sliding(ChestTerms<double> c, const LungPose& pose,
                           const Proportions& proportions)
{
    c.bulkBack -= kSlide * kSlideForward / proportions.depth * pose.diaphragm;
    c.bulkDown += kSlide * kSlideDown * pose.diaphragm;
    return c;
}

ChestTerms<double> wallTerms(const LungPose& pose, const Proportions& proportions)
{
    ChestTerms<double> c;
    c.forward = -kForward / proportions.depth * pose.ribs;
    c.flare = kFlare / proportions.width * pose.ribs;
    c.lift = -kLift * pose.ribs;
    return c;
}

/// Of a number between a negative and a positive limit, the share of the way to its limit.
double share(double s, double least, double greatest) { return std::max(s / least, s / greatest); }

bool onlyCollapses(const LungPose& lung) { return lung == LungPose{.collapse = lung.collapse}; }

double takenBy(const LungPose& lung, double shiftInto)
{
    return std::max({share(lung.diaphragm, kLeastBreath, kMostDescent),
                     share(lung.ribs, kLeastBreath, kGreatestBreath),
                     share(lung.gravity, -kMostGravity, kMostGravity)})
           + share(lung.collapse, kLeastCollapse,
                   onlyCollapses(lung) ? kMostCollapseAlone : kMostCollapse)
           + std::max(shiftInto, 0.0) / kMostShift;
}

/// Lower and upper bounds on s from a s <= b.
void limitBy(double a, double b, AmplitudeRange& range)
{
    if (a > 0.0)
        range.greatest = std::min(range.greatest, b / a);
    else if (a < 0.0)
        range.least = std::max(range.least, b / a);
    else if (b < 0.0)
        range = {1.0, 0.0};
}

} // namespace

ChestMotion motionOf(ChestRegion region, const ChestPose& pose, const ChestField& field)
{
    const Proportions proportions = proportionsOf(field);
    const auto& [right, left] = pose.lungs;
    const auto& [rightWall, leftWall] = pose.walls ? *pose.walls : pose.lungs;
    const double shift = pose.mediastinalShift;
    const auto lung = [&](const LungPose& own) { return lungTerms(own, shift, proportions); };
    const auto both = [](const ChestTerms<double>& own) { return ChestMotion{own, own}; };
    switch (region) {
    case ChestRegion::RightUpperLung:
        return both(lung(right));
    case ChestRegion::LeftUpperLung:
        return both(lung(left));
    case ChestRegion::RightLowerLung:
        return both(sliding(lung(right), right, proportions));
    case ChestRegion::LeftLowerLung:
        return both(sliding(lung(left), left, proportions));
    case ChestRegion::Bronchi:
        return {lung(right), lung(left)};
    case ChestRegion::Diaphragm: {
        ChestMotion motion{lung(rightWall), lung(leftWall)};
        motion.right.shrink = 0.0;
        motion.left.shrink = 0.0;
        return motion;
    }
    case ChestRegion::Wall:
    case ChestRegion::Skin:
        return {wallTerms(rightWall, proportions), wallTerms(leftWall, proportions)};
    case ChestRegion::Mediastinum: {
        ChestTerms<double> c;
        c.shift = shift;
        return both(c);
    }
    case ChestRegion::Still:
    case ChestRegion::LooseTooth:
    case ChestRegion::Teeth:
    case ChestRegion::Throat:
    case ChestRegion::Pharynx:
    case ChestRegion::Larynx:
        break;
    }
    return {};
}

std::optional<AmplitudeRange> amplitudesWithin(const LungPose& given, const LungPose& along,
                                               double shiftInto)
{
    if (shiftInto < -kMostShift)
        return std::nullopt;
    constexpr double kAll = std::numeric_limits<double>::infinity();
    AmplitudeRange range{-kAll, kAll};
    const double room = 1.0 - std::max(shiftInto, 0.0) / kMostShift;
    const double mostCollapse =
        onlyCollapses(given) && onlyCollapses(along) ? kMostCollapseAlone : kMostCollapse;
    const auto limit = [&](double LungPose::*mode, double least, double greatest) {
        for (const double most : {least, greatest})
            for (const double collapsed : {kLeastCollapse, mostCollapse})
                limitBy(along.*mode / most + along.collapse / collapsed,
                        room - given.*mode / most - given.collapse / collapsed, range);
    };
    limit(&LungPose::diaphragm, kLeastBreath, kMostDescent);
    limit(&LungPose::ribs, kLeastBreath, kGreatestBreath);
    limit(&LungPose::gravity, -kMostGravity, kMostGravity);
    if (!(range.least <= range.greatest))
        return std::nullopt;
    return range;
}

double rangeTaken(const ChestPose& pose)
{
    if (std::abs(pose.mediastinalShift) > kMostShift)
        return std::numeric_limits<double>::infinity();
    double taken = std::max(takenBy(pose.lungs[0], -pose.mediastinalShift),
                            takenBy(pose.lungs[1], pose.mediastinalShift));
    if (pose.walls)
        for (const LungPose& wall : *pose.walls)
            taken = std::max(taken, takenBy(wall, 0.0));
    return taken;
}

ChestPose exaggerated(const ChestPose& pose, double factor)
{
    const double taken = rangeTaken(pose);
    const double k = factor * taken > 1.0 ? 1.0 / taken : factor;
    ChestPose larger{{k * pose.lungs[0], k * pose.lungs[1]}, k * pose.mediastinalShift};
    if (pose.walls)
        larger.walls = {k * pose.walls->at(0), k * pose.walls->at(1)};
    return larger;
}

} // namespace carina
