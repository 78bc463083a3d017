#include "engine/anatomy/shapes/line_bend.h"

#include <algorithm>
#include <limits>

namespace carina
{

LineBend::LineBend(std::span<const Vec3> p_F_rest, std::span<const Vec3> p_F_bent)
    : m_rest{sweptLine(p_F_rest)}, m_bent{sweptLine(p_F_bent)}
{
    const Quat turn = Quat::FromTwoVectors(m_rest.tangents.front(), m_bent.tangents.front());
    carrySide(m_bent, turn * m_rest.sides.front());
}

LineBend::Place LineBend::placeOn(const SweptLine& line, double along)
{
    const LinePlace place = placeAt(line, along);
    Mat3 axes;
    axes << place.tangent, place.side, place.tangent.cross(place.side);
    return {place.point, axes};
}

double LineBend::alongTo(const Vec3& p_F) const
{
    double best = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < m_rest.points.size(); ++i) {
        const Vec3 step = m_rest.points[i + 1] - m_rest.points[i];
        const Vec3 from = p_F - m_rest.points[i];
        const double share = std::clamp(from.dot(step) / step.squaredNorm(), 0.0, 1.0);
        const double squared = (from - share * step).squaredNorm();
        if (squared < least) {
            least = squared;
            best = m_rest.along[i] + share * step.norm();
        }
    }
    return best;
}

Vec3 LineBend::taken(const Vec3& p_F) const
{
    const double along = alongTo(p_F);
    const Place before = atRest(along);
    const Place after = whereBent(along);
    return after.point + after.axes * (before.axes.transpose() * (p_F - before.point));
}

} // namespace carina
