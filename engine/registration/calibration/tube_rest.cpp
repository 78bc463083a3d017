#include "engine/registration/calibration/tube_rest.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr double kCentreStep = 0.004; ///< metres
constexpr Length kAShortWay = millimetres(0.01);
constexpr double kStraight = 1e-9; ///< a turn, in radians, below which an arc is a line

/// An arc in the plane of y and z.
struct TubeArc {
    Vec3 p_E_start = Vec3::Zero();
    double angle = 0.0; ///< of its direction at the start, from -z towards -y
    double bend = 0.0;
    double length = 0.0;
};

Vec3 directionAt(double angle) { return {0.0, -std::sin(angle), -std::cos(angle)}; }

/// The chord of an arc of that length has the direction of its middle.
Vec3 pointOn(const TubeArc& arc, double along)
{
    const double half = 0.5 * arc.bend * along;
    const double share = std::abs(half) < kStraight ? 1.0 : std::sin(half) / half;
    return arc.p_E_start + along * share * directionAt(arc.angle + half);
}

std::array<TubeArc, 2> arcsOf(const TubeRest& tube)
{
    const double half = 0.5 * tube.length.si;
    const TubeArc first{.bend = tube.bends[0], .length = half};
    return {first, TubeArc{.p_E_start = pointOn(first, half),
                           .angle = tube.bends[0] * half,
                           .bend = tube.bends[1],
                           .length = half}};
}

double distanceFromArc(const TubeArc& arc, const Vec3& p_EQ)
{
    double along = (p_EQ - arc.p_E_start).dot(directionAt(arc.angle));
    if (std::abs(arc.bend) * arc.length > kStraight) {
        const Vec3 inward{0.0, -std::cos(arc.angle), std::sin(arc.angle)};
        const Vec3 to = inward + arc.bend * (arc.p_E_start - p_EQ); // as `inward` at that point
        const double middle = arc.angle + 0.5 * arc.bend * arc.length;
        const double off =
            std::remainder(std::atan2(to.z(), -to.y()) - middle, 2.0 * std::numbers::pi);
        along = 0.5 * arc.length + off / arc.bend;
    }
    return (pointOn(arc, std::clamp(along, 0.0, arc.length)) - p_EQ).norm();
}

} // namespace

Vec3 centreOfTube(const TubeRest& tube, Length along)
{
    const auto arcs = arcsOf(tube);
    return along.si <= arcs[0].length ? pointOn(arcs[0], along.si)
                                      : pointOn(arcs[1], along.si - arcs[0].length);
}

std::vector<Vec3> centrelineOfTube(const TubeRest& tube)
{
    const auto steps = std::max(2, int(std::ceil(tube.length.si / kCentreStep)));
    std::vector<Vec3> centre;
    for (int i = 0; i <= steps; ++i)
        centre.push_back(centreOfTube(tube, (double(i) / steps) * tube.length));
    return centre;
}

double distanceFromTube(const TubeRest& tube, const Vec3& p_EQ)
{
    const auto arcs = arcsOf(tube);
    return std::min(distanceFromArc(arcs[0], p_EQ), distanceFromArc(arcs[1], p_EQ));
}

Length sagittaOfTube(const TubeRest& tube)
{
    const Vec3 along = tipOfTube(tube).normalized();
    double sagitta = 0.0;
    for (const Vec3& p_E : centrelineOfTube(tube))
        sagitta = std::max(sagitta, (p_E - p_E.dot(along) * along).norm());
    return metres(sagitta);
}

Vec3 placeOnTube(const TubeRest& tube, const TubeTouchPlace& place)
{
    const double turn = 2.0 * std::numbers::pi * place.share;
    switch (place.part) {
    case TubePart::Rim:
        return {kConnectorRadius.si * std::cos(turn), kConnectorRadius.si * std::sin(turn),
                kConnectorRim.si};
    case TubePart::Wall: {
        const Length along = place.share * tube.length;
        const Vec3 ahead = centreOfTube(tube, along + kAShortWay) - centreOfTube(tube, along);
        const Vec3 outside = Vec3::UnitX().cross(ahead).normalized();
        return centreOfTube(tube, along)
               + 0.5 * tube.outerDiameter.si * (place.isBeside ? Vec3{Vec3::UnitX()} : outside);
    }
    case TubePart::Tip:
        break;
    }
    return tipOfTube(tube);
}

} // namespace carina
