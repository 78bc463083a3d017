#include "engine/airway/monitor/airway_moment.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr Length kAtTeeth = millimetres(20.0); ///< of an adult's way, which is straight so far

/// At the teeth and in front of them the distance from their plane, further on that along the way:
/// a way that bends down comes back through that plane, in grown people above the carina, and
/// higher when the neck is flexed.
double pastIncisors(const PatientWays& ways, const Vec3& p_A)
{
    const double along = nearestOnWay(ways.overTongue, p_A).along.si;
    return along > ways.size * kAtTeeth.si ? along
                                           : (p_A - ways.p_A_incisors()).dot(ways.inward_A());
}

double pastCordsPlane(const PatientWays& ways, const Vec3& p_A)
{
    return -(p_A - ways.p_A_glottis()).dot(ways.up_A());
}

/// How far within reach of trachea, oesophagus or bronchi; negative outside.
double inWindpipes(const PatientWays& ways, const Vec3& p_A)
{
    const std::array right{ways.p_A_carina(), ways.p_A_rightEnd};
    const std::array left{ways.p_A_carina(), ways.p_A_leftEnd};
    double off = distanceFrom(ways.trachea, p_A).si;
    for (const std::span<const Vec3> line :
         {std::span<const Vec3>{ways.oesophagus}, std::span<const Vec3>{right},
          std::span<const Vec3>{left}})
        off = std::min(off, distanceFrom(line, p_A).si);
    return ways.size * kMostFromWindpipe.si - off;
}

double inBody(const PatientWays& ways, const Vec3& p_A)
{
    const double inThroat =
        ways.size * kMostFromTongueWay.si - distanceFrom(ways.overTongue, p_A).si;
    return std::max(inThroat, inWindpipes(ways, p_A));
}

/// Of a place past a plane; negative where it is not within reach of the ways.
Length withinReach(double past, double inReach)
{
    return metres(inReach < 0.0 ? std::min(past, inReach) : past);
}

Length pastTeeth(const PatientWays& ways, const Vec3& p_A)
{
    return withinReach(pastIncisors(ways, p_A), inBody(ways, p_A));
}

/// The way over the tongue from kToVallecula of it on.
std::span<const Vec3> wayAtVallecula(const PatientWays& ways)
{
    const std::span<const Vec3> line = ways.overTongue;
    const Length before = kToVallecula * lengthOf(line);
    std::size_t first = 0;
    while (first + 2 < line.size() && lengthOf(line.first(first + 1)) < before)
        ++first;
    return line.subspan(first);
}

/// Whether a point is rather where the tongue is than beside or behind the line: below the line at
/// the teeth, and in front of it at the larynx.
bool isOnTongueSide(std::span<const Vec3> line, const PlaceOnWay& place, const Vec3& p_A)
{
    constexpr double kPiece = 0.1; // of the line
    const Length piece = kPiece * lengthOf(line);
    const Length from = std::min(place.along, lengthOf(line) - piece);
    const Vec3 ahead = pointAlong(line, from + piece) - pointAlong(line, from);
    const Vec3 off = p_A - place.p_A;
    return ahead.cross(Vec3::UnitX()).normalized().dot(off) > std::sqrt(0.5) * off.norm();
}

/// How far within reach of a blade at the vallecula, which it lifts; negative outside.
double atLiftedVallecula(const PatientWays& ways, const Vec3& p_A)
{
    const std::span<const Vec3> line = wayAtVallecula(ways);
    const PlaceOnWay place = nearestOnWay(line, p_A);
    const double reach =
        isOnTongueSide(line, place, p_A) ? ways.size * kMostBladeFromTongueWay.si : 0.0;
    return reach - distanceFrom(line, p_A).si;
}

Length bladePastTeeth(const PatientWays& ways, const Vec3& p_A)
{
    return withinReach(pastIncisors(ways, p_A),
                       std::max(inBody(ways, p_A), atLiftedVallecula(ways, p_A)));
}

Length pastCords(const PatientWays& ways, const Vec3& p_A)
{
    return withinReach(pastCordsPlane(ways, p_A), inWindpipes(ways, p_A));
}

/// Along a line from one way to the other, from its middle.
struct BetweenWays {
    double beyond = 0.0;
    double apart = 0.0;
};

BetweenWays between(const Vec3& p_A_one, const Vec3& p_A_other, const Vec3& p_A)
{
    const Vec3 across = p_A_other - p_A_one;
    const double apart = across.norm();
    if (!(apart > 0.0))
        return {};
    return {(p_A - p_A_one).dot(across) / apart - 0.5 * apart, apart};
}

/// @param p_A the tip as it was measured: one that is held in a way lies in that without evidence
void findOesophagus(AirwayMoment& moment, const PatientWays& ways, const Vec3& p_A)
{
    const Vec3 inTrachea = nearestOnWay(ways.trachea, p_A).p_A;
    const Vec3 behind = nearestOnWay(ways.oesophagus, inTrachea).p_A;
    BetweenWays place = between(inTrachea, behind, p_A);
    // At the larynx a tip may go by at the side.
    const Vec3 fromGlottis = p_A - ways.p_A_glottis();
    if (std::abs(fromGlottis.dot(ways.up_A())) < ways.size * kBesideGlottis.si)
        place.beyond =
            std::max(place.beyond, std::abs(fromGlottis.x()) - ways.size * kBesideGlottis.si);
    moment.towardsOesophagus = metres(place.beyond);
    moment.tracheaToOesophagus = metres(place.apart);
}

/// The end of the trachea as a straight piece: its very last points lead to the ridge.
Vec3 downAtCarina(const PatientWays& ways)
{
    constexpr Length kPiece = millimetres(15.0);
    const Vec3 before = pointAlong(ways.trachea, lengthOf(ways.trachea) - ways.size * kPiece);
    return (ways.p_A_carina() - before).normalized();
}

/// Both bronchi go down from the carina: at the height of the tip, and the way to there in the
/// nearer one.
/// @param p_A the tip as it was measured
void findBronchus(AirwayMoment& moment, const PatientWays& ways, const Vec3& down, double beyond,
                  const Vec3& p_A)
{
    const Vec3 carina = ways.p_A_carina();
    const auto at = [&](const Vec3& end) {
        constexpr double kLeastDescent = 0.2; // of a bronchus' direction
        const Vec3 direction = (end - carina).normalized();
        return Vec3{beyond / std::max(direction.dot(down), kLeastDescent) * direction};
    };
    const Vec3 right = at(ways.p_A_rightEnd);
    const Vec3 left = at(ways.p_A_leftEnd);
    const BetweenWays place = between(carina + right, carina + left, p_A);
    moment.towardsLeft = metres(place.beyond);
    moment.rightToLeft = metres(place.apart);
    moment.aboveCarina = metres(-(place.beyond < 0.0 ? right : left).norm());
}

void findPlace(AirwayMoment& moment, const PatientWays& ways, const Vec3& p_A_measured)
{
    const PlaceOnWay inTrachea = nearestOnWay(ways.trachea, moment.p_A_tip);
    findOesophagus(moment, ways, p_A_measured);
    const Vec3 down = downAtCarina(ways);
    const double beyond = (moment.p_A_tip - ways.p_A_carina()).dot(down);
    if (beyond > 0.0) {
        findBronchus(moment, ways, down, beyond, p_A_measured);
        return;
    }
    const Length trachea = lengthOf(ways.trachea);
    moment.aboveCarina = std::max(trachea - inTrachea.along, metres(-beyond));
    if (pastCordsPlane(ways, moment.p_A_tip) < 0.0) {
        const Length over = lengthOf(ways.overTongue);
        const Length along = std::min(nearestOnWay(ways.overTongue, moment.p_A_tip).along, over);
        moment.aboveCarina = trachea + (over - along);
    }
}

/// A tube that lies beside the patient may be farther away than an entry of a session may say.
void findTip(AirwayMoment& moment, const PatientWays& ways, const Vec3& p_A_measured)
{
    findPlace(moment, ways, p_A_measured);
    moment.aboveCarina =
        std::clamp(moment.aboveCarina, -1.0 * kFarthestFromCarina, kFarthestFromCarina);
}

/// From its place nearest to the incisors, as its marks are read there, to its tip.
Length depthOf(const PatientWays& ways, std::span<const Vec3> p_A_tube)
{
    const Length before = nearestOnWay(p_A_tube, ways.p_A_incisors()).along;
    return std::max(lengthOf(p_A_tube) - before, Length{});
}

void findTube(AirwayMoment& moment, const PatientWays& ways, const TubeCurves& tube)
{
    CARINA_EXPECTS(tube.p_A_shown.size() >= 2);
    moment.p_A_tip = tube.p_A_shown.back();
    const Vec3 measured = tube.p_A_measured.empty() ? moment.p_A_tip : tube.p_A_measured.back();
    moment.pastTeeth = pastTeeth(ways, moment.p_A_tip);
    moment.pastCords = pastCords(ways, moment.p_A_tip);
    moment.measuredPastCords = pastCords(ways, measured);
    moment.besides = metres((measured - moment.p_A_tip).norm());
    moment.isTipKnown = tube.isTipKnown;
    findTip(moment, ways, measured);
    if (moment.pastTeeth > Length{})
        moment.depthAtTeeth = depthOf(ways, tube.p_A_shown);
}

} // namespace

AirwayMoment airwayMoment(SessionTime at, const PatientWays& ways, const TubeCurves& tube,
                          const BladeSeen& blade, bool areCordsShut)
{
    AirwayMoment moment;
    moment.at = at;
    moment.tube = tube.validity;
    if (tube.validity != Validity::Lost)
        findTube(moment, ways, tube);
    moment.areCordsShut = areCordsShut;
    moment.blade = blade.validity;
    if (blade.validity != Validity::Lost) {
        moment.bladePastTeeth = bladePastTeeth(ways, blade.p_A_tip);
        moment.glottis = blade.glottis;
    }
    return moment;
}

} // namespace carina
