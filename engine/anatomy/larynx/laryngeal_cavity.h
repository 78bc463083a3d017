#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// The air within the larynx, from the first ring of the trachea through the cricoid, the glottis
/// and between the vestibular folds to the entrance: below zero in the air. Frame of LarynxFrame,
/// millimetres; near its wall about the distance to it.
///
/// The glottis is open as in a quiet breath: a V that is round in front, at the anterior
/// commissure, and 23 mm long in a man (Miller, 6th edition), of which the 60 % in front of the
/// vocal processes are membranous (Friedrich 1993: 37 % cartilaginous in men); 9 mm wide (6 to 9,
/// up to 12).
class LaryngealCavity
{
public:
    /// @param trachea_mm half the width and depth of the trachea's lumen, in the frame's
    /// millimetres
    explicit LaryngealCavity(const Vec2& trachea_mm) : m_trachea(trachea_mm) {}

    [[nodiscard]] double distance(const Vec3& p) const;

private:
    Vec2 m_trachea;
};

/// The anterior commissure, the vocal processes and the back of the glottis: y in LarynxFrame.
inline constexpr double kCommissure_mm = -13.1;
inline constexpr double kVocalProcess_mm = 0.3;
inline constexpr double kBackOfGlottis_mm = 9.5;

} // namespace carina
