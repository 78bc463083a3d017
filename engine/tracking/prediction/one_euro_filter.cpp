#include "engine/tracking/prediction/one_euro_filter.h"

#include "engine/geometry/rotation.h"

#include <numbers>

namespace carina
{
namespace
{

/// The share of the new value in a low pass of first order.
double shareOfNew(Frequency limit, double dt)
{
    const double turns = 2.0 * std::numbers::pi * limit.si * dt;
    return turns / (1.0 + turns);
}

double shareAt(const OneEuroFilter::Limits& limits, double speed, double dt)
{
    return shareOfNew(limits.still + hertz(limits.slope * speed), dt);
}

} // namespace

PoseSample OneEuroFilter::smoothed(PoseSample sample)
{
    if (sample.validity == Validity::Lost || (m_raw && sample.time <= m_raw->time))
        return sample;
    if (!m_raw || sample.time - m_raw->time > kLongestGap) {
        m_raw = sample;
        m_X_FO = sample.X_FO;
        m_v_FO = m_w_FO = Vec3::Zero();
        return sample;
    }
    const double dt = toSeconds(sample.time - m_raw->time);
    const double ofSpeed = shareOfNew(kSpeedLimit, dt);
    const RigidTransform& before = m_raw->X_FO;
    m_v_FO += ofSpeed * ((sample.X_FO.translation() - before.translation()) / dt - m_v_FO);
    m_w_FO +=
        ofSpeed
        * (rotationVector(sample.X_FO.rotation() * before.rotation().conjugate()) / dt - m_w_FO);
    const Vec3 turn = rotationVector(sample.X_FO.rotation() * m_X_FO.rotation().conjugate());
    const double moved = shareAt(m_settings.position, m_v_FO.norm(), dt);
    const double turned = shareAt(m_settings.rotation, m_w_FO.norm(), dt);
    m_X_FO = {canonical(rotationFromVector(turned * turn) * m_X_FO.rotation()),
              m_X_FO.translation() + moved * (sample.X_FO.translation() - m_X_FO.translation())};
    m_raw = sample;
    sample.X_FO = m_X_FO;
    return sample;
}

} // namespace carina
