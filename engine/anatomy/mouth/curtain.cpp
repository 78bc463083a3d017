#include "engine/anatomy/mouth/curtain.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr double kSag = 0.014;        ///< per millimetre: how it sinks to both sides
constexpr double kThickensOver = 8.0; ///< from the free edge on
constexpr double kWidestSag = 25.0;   ///< x up to which the slope of that counts

} // namespace

Curtain::Curtain(std::vector<Vec2> profile_mm, std::vector<Vec2> opening_mm, double edge_mm,
                 double root_mm)
    : m_profile(std::move(profile_mm)),
      m_opening(std::move(opening_mm)),
      m_edge(edge_mm),
      m_root(root_mm)
{
    CARINA_EXPECTS(m_profile.size() >= 2 && m_opening.size() >= 3);
}

double Curtain::levelHeight(const Vec3& p_mm) { return p_mm.z() + kSag * p_mm.x() * p_mm.x(); }

double Curtain::distance(const Vec3& p_mm) const
{
    const double x = std::abs(p_mm.x());
    const double off = alongLine({p_mm.y(), levelHeight(p_mm)}, m_profile).off;
    const double fromEdge = polygonDistance({x, p_mm.z()}, m_opening);
    const double half = m_edge + (m_root - m_edge) * easedStep(0.0, kThickensOver, fromEdge);
    const double slope = std::hypot(1.0, 2.0 * kSag * std::min(x, kWidestSag));
    return roundedMax((off - half) / slope, -fromEdge, 2.0 * m_edge);
}

} // namespace carina
