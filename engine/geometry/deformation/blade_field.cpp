#include "engine/geometry/deformation/blade_field.h"

#include "engine/core/expects.h"

#include <algorithm>

#include <algorithm>

namespace carina
{

Vec3 middleOfBlade(const BladeForm& form, double share)
{
    return {0.0, formula::bladeFace(form.rise, form.sag, share).value, -form.reach * share};
}

BladeField::BladeField(const BladeForm& form, const RigidTransform& X_AL)
{
    CARINA_EXPECTS(form.reach > 0.0 && form.width > 0.0);
    const Vec3& p_A_heel = X_AL.translation();
    m_frame.across = X_AL.rotation() * Vec3::UnitX();
    m_frame.out = X_AL.rotation() * Vec3::UnitY();
    m_frame.along = X_AL.rotation() * Vec3{0.0, 0.0, -1.0 / form.reach};
    m_frame.acrossFrom = -m_frame.across.dot(p_A_heel);
    m_frame.outFrom = -m_frame.out.dot(p_A_heel) - kBladeHalfThickness;
    m_frame.alongFrom = -m_frame.along.dot(p_A_heel);
    m_frame.rise = form.rise;
    m_frame.sag = form.sag;
    m_frame.halfWidth = 0.5 * form.width;
}

void BladeField::tiltLarynx(const LarynxHinge& hinge, Length tilt)
{
    m_frame.tilt = Vec3::Zero();
    if (!(hinge.height.si > 0.0 && hinge.behind.si > 0.0))
        return;
    m_frame.up = hinge.up_A / hinge.height.si;
    m_frame.upFrom = -m_frame.up.dot(hinge.p_A);
    m_frame.back = -(hinge.forward_A + hinge.slope * hinge.up_A) / hinge.behind.si;
    m_frame.backFrom = -m_frame.back.dot(hinge.p_A);
    const double within = std::min(std::max(0.0, tilt.si), 2.0 * hinge.behind.si); // 0 for NaN
    m_frame.tilt = within * hinge.forward_A;
}

BladeFrame<float> inSingle(const BladeFrame<double>& frame)
{
    BladeFrame<float> single;
    single.across = frame.across.cast<float>();
    single.out = frame.out.cast<float>();
    single.along = frame.along.cast<float>();
    single.acrossFrom = static_cast<float>(frame.acrossFrom);
    single.outFrom = static_cast<float>(frame.outFrom);
    single.alongFrom = static_cast<float>(frame.alongFrom);
    single.rise = static_cast<float>(frame.rise);
    single.sag = static_cast<float>(frame.sag);
    single.halfWidth = static_cast<float>(frame.halfWidth);
    single.tilt = frame.tilt.cast<float>();
    single.up = frame.up.cast<float>();
    single.upFrom = static_cast<float>(frame.upFrom);
    single.back = frame.back.cast<float>();
    single.backFrom = static_cast<float>(frame.backFrom);
    return single;
}

} // namespace carina
