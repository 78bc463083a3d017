#include "engine/anatomy/airway/pharynx_place.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

constexpr double kIncisors = 48.6; ///< the upper incisors' edge above the cords

constexpr std::array kWall{PharynxSection{-21, 11, 20, 9},  PharynxSection{-10, 15, 19.2, 8},
                           PharynxSection{0, 17, 18.5, 8},  PharynxSection{10, 17.5, 18, 8},
                           PharynxSection{20, 17.5, 17, 2}, PharynxSection{30, 18, 16, -10},
                           PharynxSection{40, 18, 15, -4},  PharynxSection{47, 20, 13, -4},
                           PharynxSection{54, 28, 12, -14}, PharynxSection{65, 29, 11.5, -14},
                           PharynxSection{78, 26, 11, -8},  PharynxSection{90, 14, 10, 5}};

} // namespace

PharynxSection pharynxSectionAt(double z)
{
    const auto above = std::ranges::upper_bound(kWall, z, {}, &PharynxSection::z);
    if (above == kWall.begin())
        return kWall.front();
    if (above == kWall.end())
        return kWall.back();
    const PharynxSection& b = *above;
    const PharynxSection& a = *(above - 1);
    const double t = (z - a.z) / (b.z - a.z);
    const auto mix = [t](double from, double to) { return from + t * (to - from); };
    return {z, mix(a.halfWidth, b.halfWidth), mix(a.back, b.back), mix(a.front, b.front)};
}

PharynxPlace::PharynxPlace(const BodyPlan& plan)
    : m_cords(plan.landmarks.p_A_glottis),
      m_larynx(plan.airway),
      m_face(plan.face),
      m_between((plan.landmarks.p_A_incisors.z() - m_cords.z()) / kIncisors)
{
}

Vec3 PharynxPlace::inHis(const Vec3& p_A) const
{
    const Vec3 p = p_A - m_cords;
    const double over = p.z() - m_between * kIncisors;
    const double z = p.z() < 0.0  ? p.z() / m_larynx
                     : over < 0.0 ? p.z() / m_between
                                  : kIncisors + over / m_face;
    return {p.x() / breadthAt(z), p.y() / breadthAt(z), z};
}

Vec3 PharynxPlace::inAnatomy(const Vec3& p_mm) const
{
    const double z = p_mm.z();
    const double height = z < 0.0         ? z * m_larynx
                          : z < kIncisors ? z * m_between
                                          : kIncisors * m_between + (z - kIncisors) * m_face;
    return m_cords + Vec3{breadthAt(z) * p_mm.x(), breadthAt(z) * p_mm.y(), height};
}

double PharynxPlace::least() const { return std::min({m_larynx, m_face, m_between}); }

double PharynxPlace::breadthAt(double z) const
{
    return m_larynx + (m_face - m_larynx) * std::clamp(z / kIncisors, 0.0, 1.0);
}

} // namespace carina
