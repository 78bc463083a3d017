#pragma once

#include "engine/anatomy/patient/body_plan.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// The frame in which shapes of the larynx are written: origin midway between the vocal cords, +x
/// to the patient's left, +y to the back and +z up along the trachea's axis, in millimetres of a
/// grown man. `unit` is what one of these measures in this patient, metres. Below the cords z is
/// stretched so that the trachea begins at kTracheaTop_mm.
class LarynxFrame
{
public:
    explicit LarynxFrame(const PatientDimensions& dimensions);

    [[nodiscard]] double unit() const { return m_unit; }
    [[nodiscard]] Vec3 local(const Vec3& p_A) const
    {
        const Vec3 p = m_X_WA * p_A - m_p_W;
        return {p.x() / m_unit, p.y() / m_unit, p.z() / (p.z() < 0.0 ? m_below : m_unit)};
    }
    [[nodiscard]] Vec3 inAnatomy(const Vec3& p_mm) const
    {
        const double z = p_mm.z() * (p_mm.z() < 0.0 ? m_below : m_unit);
        return m_X_AW * (m_p_W + Vec3{m_unit * p_mm.x(), m_unit * p_mm.y(), z});
    }

    /// A box of this frame, in A.
    [[nodiscard]] Box inAnatomy(const Box& box_mm) const;
    /// A shape of this frame within a box, in A.
    [[nodiscard]] ImplicitShape inAnatomy(const Box& box_mm, Implicit local) const;

private:
    RigidTransform m_X_AW;
    RigidTransform m_X_WA;
    Vec3 m_p_W;     ///< between the cords
    double m_below; ///< metres in one millimetre of z below the cords
    double m_unit;
};

/// How far below the cords the trachea begins, in this frame.
inline constexpr double kTracheaTop_mm = -26.0;

} // namespace carina
