#include "engine/anatomy/larynx/laryngeal_cavity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

double mix(double a, double b, double share) { return a + share * (b - a); }

/// A level section of the cavity: where it begins in front and ends behind, and half its width in
/// front, at the vocal processes and at the back.
struct Level {
    double z, front, back;
    double inFront, atProcess, behind;
    double pocket = 0.0; ///< depth of the ventricle beside it
};

/// From below: the cone under the cords, the cords, the ventricle, the vestibular folds, the
/// vestibule up to the entrance.
constexpr std::array kLevels{Level{-8.0, -11.0, 6.4, 4.0, 7.2, 5.4},
                             Level{-4.5, -12.4, 7.0, 2.2, 6.0, 4.6},
                             Level{-1.8, -12.9, 9.0, 0.97, 4.9, 3.9},
                             Level{-0.8, kCommissure_mm, kBackOfGlottis_mm, 0.77, 4.5, 3.6},
                             Level{0.8, kCommissure_mm, kBackOfGlottis_mm, 0.77, 4.5, 3.6},
                             Level{2.0, -12.9, 9.6, 2.6, 6.2, 4.2, 3.0},
                             Level{3.0, -12.7, 9.7, 3.0, 7.0, 4.6, 2.8},
                             Level{4.4, -12.7, 9.8, 2.6, 7.5, 4.8},
                             Level{6.0, -12.7, 9.9, 2.7, 7.6, 5.0},
                             Level{9.0, -12.9, 10.1, 3.0, 9.3, 5.4},
                             Level{18.0, -13.5, 11.0, 3.2, 9.4, 6.5},
                             Level{45.0, -16.0, 12.0, 9.5, 9.8, 8.0}};

Level levelAt(double z)
{
    const auto above = std::ranges::upper_bound(kLevels, z, {}, &Level::z);
    if (above == kLevels.begin())
        return kLevels.front();
    if (above == kLevels.end())
        return kLevels.back();
    const Level& b = *above;
    const Level& a = *(above - 1);
    const double t = (z - a.z) / (b.z - a.z);
    return {z,
            mix(a.front, b.front, t),
            mix(a.back, b.back, t),
            mix(a.inFront, b.inFront, t),
            mix(a.atProcess, b.atProcess, t),
            mix(a.behind, b.behind, t),
            mix(a.pocket, b.pocket, t)};
}

double halfWidth(const Level& level, double y)
{
    if (y > kVocalProcess_mm)
        return mix(level.atProcess, level.behind,
                   (y - kVocalProcess_mm) / (level.back - kVocalProcess_mm));
    const double t = (y - level.front) / (kVocalProcess_mm - level.front);
    const double beside = easedStep(-12.0, -8.0, y) * (1.0 - easedStep(-4.0, 0.5, y));
    return mix(level.inFront, level.atProcess, t) + level.pocket * beside;
}

/// In front a level section is round, by a circle of this radius or, where it is narrower, of half
/// its width: cords, which stand out of it, meet in an arc of 0.6 mm.
constexpr double kRoundInFront = 1.1;

/// How far a place is beside the cavity, in the level section at its height.
double besideSection(const Vec3& p)
{
    const Level level = levelAt(p.z());
    const double round = std::min(kRoundInFront, halfWidth(level, level.front + kRoundInFront));
    const double centre = level.front + round;
    const double half = halfWidth(level, std::clamp(p.y(), centre, 14.0));
    const double aside = std::abs(p.x()) - (half - round);
    const double before = centre - p.y();
    const double corner = std::hypot(std::max(aside, 0.0), std::max(before, 0.0));
    return corner + std::min(std::max(aside, before), 0.0) - round;
}

/// Above the cricoid. Where the wall slopes, as on the floor of the ventricle, it is nearer than in
/// the level section.
double slit(const Vec3& p)
{
    constexpr double kStep = 0.5;
    const double rise =
        (besideSection(p + kStep * Vec3::UnitZ()) - besideSection(p - kStep * Vec3::UnitZ()))
        / (2.0 * kStep);
    const double sides = besideSection(p) / std::max(std::hypot(1.0, rise), 4.0 / 3.0);
    return roundedMax(sides, p.y() - levelAt(p.z()).back, 1.6);
}

} // namespace

double LaryngealCavity::distance(const Vec3& p) const
{
    const double round = easedStep(-5.0, -16.0, p.z());
    const double tube = ellipseDistance({p.x(), p.y() + 0.4}, m_trachea);
    if (round >= 1.0)
        return tube;
    return mix(slit(p), tube, round);
}

} // namespace carina
