#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// A horizontal section of the pharynx' muscular wall, in reference millimetres (BodyPlan) from
/// between the vocal cords: half its width, its rearmost y, and the y at which it begins in front.
struct PharynxSection {
    double z, halfWidth, back, front;
};

/// Where the wall begins at the cricoid and ends at the base of the skull, reference millimetres.
inline constexpr double kPharynxFoot_mm = -21.0;
inline constexpr double kPharynxVault_mm = 90.0;

/// The section at a height, between those that were measured.
[[nodiscard]] PharynxSection pharynxSectionAt(double z_mm);

/// Where the pharynx of a patient lies: below the vocal cords by the size of the larynx, from there
/// to the level of the incisors by the height between them, above by the size of the face.
class PharynxPlace
{
public:
    explicit PharynxPlace(const BodyPlan& plan);

    /// To reference millimetres, origin between the vocal cords.
    [[nodiscard]] Vec3 inHis(const Vec3& p_A) const;
    [[nodiscard]] Vec3 inAnatomy(const Vec3& p_mm) const;

    /// The smallest of the scales, in metres per reference millimetre.
    [[nodiscard]] double least() const;

private:
    [[nodiscard]] double breadthAt(double z_mm) const;

    Vec3 m_cords;
    double m_larynx, m_face, m_between;
};

} // namespace carina
