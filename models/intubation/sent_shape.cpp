#include "models/intubation/sent_shape.h"

#include "engine/anatomy/airway/centreline.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kPieces = TubeInLumen::kPieces;
/// Per metre: of ours, of what can be sent (65), so that a form with a kink is sent without it.
constexpr double kMostBent = 60.0;

/// By how much a tube has bent towards -y before the middle of a piece of its line.
double bentAt(std::span<const Vec3> p_E, std::size_t piece)
{
    const Vec3 way = p_E[piece + 1] - p_E[piece];
    return std::atan2(-way.y(), -way.z());
}

} // namespace

/// A chord of an arc has the direction of the arc at its middle.
TubeRest restOf(const TubeShape& shape)
{
    const std::vector<Vec3> p_E = inPieces(shape.p_E_centre, kPieces);
    const double piece = lengthOf(shape.p_E_centre).si / kPieces;
    const double half = 0.5 * kPieces * piece;
    const double first = bentAt(p_E, kPieces / 2 - 1) / (half - 0.5 * piece);
    const double second = (bentAt(p_E, kPieces - 1) - first * half) / (half - 0.5 * piece);
    return {lengthOf(shape.p_E_centre), {first, second}, shape.outerDiameter};
}

TubeRest restOf(const StreamShape& shape)
{
    return {metres(shape.length), shape.atRest, metres(shape.thickness)};
}

StreamShape atRest(const TubeShape& tube)
{
    if (tube.fitsAirway)
        return {};
    const TubeRest rest = restOf(tube);
    return {{}, rest.length.si, rest.outerDiameter.si, rest.bends, {}};
}

std::vector<Vec3> lineAtRest(const StreamShape& shape, const TubeShape& own)
{
    return inPieces(shape.isOfPatientsTube() ? own.p_E_centre : centrelineOfTube(restOf(shape)),
                    kPieces);
}

StreamShape toStream(StreamShape of, const TubeShape& own, std::span<const Vec3> p_E, SessionTime t)
{
    of.time = t;
    of.heldBack = p_E.front().norm();
    const RigidTransform X_EB{Quat::Identity(), p_E.front()};
    const TubeShapeCode code = encoded(p_E, X_EB, lineAtRest(of, own)).code;
    std::ranges::transform(code.perMetre, of.perMetre.begin(), [](double perMetre) {
        return std::clamp(perMetre, -kMostBent, kMostBent);
    });
    return of;
}

std::vector<Vec3> lineOf(const StreamShape& shape, const TubeShape& own)
{
    TubeShapeCode code;
    std::ranges::transform(shape.perMetre, code.perMetre.begin(),
                           [](double perMetre) { return float(perMetre); });
    const std::vector<Vec3> p_E_rest = lineAtRest(shape, own);
    const Vec3 p_E_begin = -shape.heldBack * (p_E_rest[1] - p_E_rest[0]).normalized();
    std::vector<Vec3> line = decoded(code, p_E_rest);
    for (Vec3& p_E : line)
        p_E += p_E_begin;
    return line;
}

std::vector<Vec3> lineOf(const ShapeBetween& shape, const TubeShape& own)
{
    const std::vector<Vec3> from = lineOf(shape.from, own);
    std::vector<Vec3> line = lineOf(shape.to, own);
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] = from[i] + shape.times * (line[i] - from[i]);
    return line;
}

} // namespace carina
