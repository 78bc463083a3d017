#include "engine/anatomy/airway/airway_measure.h"

#include "engine/anatomy/airway/airway_path.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

constexpr Length kLeastApart = millimetres(20.0);

/// The point of the piece from a to b that is nearest to p.
Vec3 nearestOn(const Vec3& a, const Vec3& b, const Vec3& p)
{
    const Vec3 along = b - a;
    const double squared = along.squaredNorm();
    return squared > 0.0 ? Vec3{a + std::clamp(along.dot(p - a) / squared, 0.0, 1.0) * along} : a;
}

} // namespace

std::span<const Vec3> pathFromTeeth(const AirwayLandmarks& airway)
{
    CARINA_EXPECTS(!airway.path_A.empty());
    const auto teeth = std::ranges::min_element(airway.path_A, {}, [&](const Vec3& p_A) {
        return (p_A - airway.p_A_incisors).squaredNorm();
    });
    return {teeth, airway.path_A.end()};
}

Length teethToCarina(const AirwayLandmarks& airway) { return lengthOf(pathFromTeeth(airway)); }

AirwayLandmarks bent(AirwayLandmarks airway, const NeckField& neck)
{
    for (Vec3* p_A : {&airway.p_A_incisors, &airway.p_A_glottis, &airway.p_A_carina})
        *p_A = neck.placed(*p_A);
    for (Vec3& p_A : airway.path_A)
        p_A = neck.placed(p_A);
    return airway;
}

std::optional<Length> teethToCarina(const Vec3& p_A_incisors, const Vec3& p_A_glottis,
                                    const Vec3& p_A_carina)
{
    for (const double apart :
         {(p_A_incisors - p_A_glottis).norm(), (p_A_glottis - p_A_carina).norm()})
        if (apart < kLeastApart.si)
            return std::nullopt;
    const std::array down{p_A_glottis, p_A_carina};
    return lengthOf(airwayPath(p_A_incisors, down)) - kPathInFrontOfTeeth;
}

Length distanceFrom(std::span<const Vec3> line, const Vec3& p)
{
    CARINA_EXPECTS(!line.empty());
    double least = (line.front() - p).norm();
    for (std::size_t i = 1; i < line.size(); ++i)
        least = std::min(least, (nearestOn(line[i - 1], line[i], p) - p).norm());
    return metres(least);
}

} // namespace carina
