#pragma once

#include "engine/anatomy/patient/body_plan.h"

namespace carina
{

/// The epiglottis, a leaf with a free upper edge and its tubercle at the back above the glottis.
/// Frame of LarynxFrame, millimetres; signed distances.
///
/// 29 mm high, 22 mm wide and 2.8 mm thick in a man (29.1 +- 0.5, 22.2 +- 0.6 and 2.6 +- 0.3 mm in
/// grown people, Vadgaonkar 2024), thinner upwards and towards its round rim.
class Epiglottis
{
public:
    /// Its leaf is bent across: little in grown people, so far in newborn children that its edges
    /// meet behind (`omega` 0 to 1).
    Epiglottis(Posture posture, double omega) : m_posture(posture), m_omega(omega) {}

    /// That of a patient.
    explicit Epiglottis(const BodyPlan& plan) : Epiglottis(plan.posture, plan.infancy) {}

    [[nodiscard]] double distance(const Vec3& p) const;
    /// y of the middle of the leaf in the midline at a height.
    [[nodiscard]] double middleAt(double z) const;
    [[nodiscard]] Box bounds() const { return {Vec3{-15, -24, 0}, Vec3{15, 16, 40}}; }

private:
    Posture m_posture;
    double m_omega;
};

} // namespace carina
