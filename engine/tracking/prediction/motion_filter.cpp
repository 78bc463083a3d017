#include "engine/tracking/prediction/motion_filter.h"

#include "engine/core/units.h"
#include "engine/geometry/rotation.h"

namespace carina
{

AccelerationFilter::AccelerationFilter(const Noise& noise) : m_noise{noise}
{
    m_covariance = Vec3{noise.measurement * noise.measurement, noise.rate * noise.rate,
                        noise.acceleration * noise.acceleration}
                       .asDiagonal();
}

Vec3 AccelerationFilter::predict(double dt)
{
    const double dt2 = dt * dt;
    const double dt3 = dt2 * dt;
    Mat3 transition;
    transition << 1.0, dt, dt2 / 2.0, 0.0, 1.0, dt, 0.0, 0.0, 1.0;
    Mat3 driven;
    driven << dt3 * dt2 / 20.0, dt2 * dt2 / 8.0, dt3 / 6.0, //
        dt2 * dt2 / 8.0, dt3 / 3.0, dt2 / 2.0,              //
        dt3 / 6.0, dt2 / 2.0, dt;
    m_covariance =
        transition * m_covariance * transition.transpose() + m_noise.jerk * m_noise.jerk * driven;
    const Vec3 change = dt * m_rate + dt2 / 2.0 * m_acceleration;
    m_rate += dt * m_acceleration;
    return change;
}

Vec3 AccelerationFilter::correct(const Vec3& innovation)
{
    const double variance = m_covariance(0, 0) + m_noise.measurement * m_noise.measurement;
    const Vec3 gain = m_covariance.col(0) / variance;
    m_covariance -= (gain * m_covariance.row(0)).eval();
    m_rate += gain[1] * innovation;
    m_acceleration += gain[2] * innovation;
    return gain[0] * innovation;
}

ErrorGrowth::Polynomial AccelerationFilter::growth() const
{
    const Mat3& p = m_covariance;
    return {p(0, 0), 2.0 * p(0, 1), p(1, 1) + p(0, 2),
            p(1, 2), p(2, 2) / 4.0, m_noise.jerk * m_noise.jerk / 20.0};
}

MotionFilter::Noise MotionFilter::handsAndHeads()
{
    return {.rotation = {.measurement = degrees(0.1).si,
                         .jerk = degrees(1000.0).si,
                         .rate = degrees(200.0).si,
                         .acceleration = degrees(1000.0).si},
            .position = {.measurement = 0.2e-3, .jerk = 1.0, .rate = 0.5, .acceleration = 5.0}};
}

MotionFilter::MotionFilter(const Noise& noise)
    : m_noise{noise}, m_rotationFilter{noise.rotation}, m_positionFilter{noise.position}
{
}

void MotionFilter::add(const PoseSample& sample)
{
    if (sample.validity == Validity::Lost || (m_samples > 0 && sample.time <= m_time))
        return;
    if (m_samples == 0 || sample.time - m_time > kLongestGap) {
        begin(sample);
        return;
    }
    const double dt = toSeconds(sample.time - m_time);
    m_time = sample.time;
    m_samples = std::min(m_samples + 1, kSamplesNeeded);

    m_q_FO = rotationFromVector(m_rotationFilter.predict(dt)) * m_q_FO;
    const Vec3 turn = rotationVector(sample.X_FO.rotation() * m_q_FO.conjugate());
    m_q_FO = canonical(rotationFromVector(m_rotationFilter.correct(turn)) * m_q_FO);

    m_p_FO += m_positionFilter.predict(dt);
    m_p_FO += m_positionFilter.correct(sample.X_FO.translation() - m_p_FO);
}

void MotionFilter::begin(const PoseSample& sample)
{
    m_rotationFilter = AccelerationFilter{m_noise.rotation};
    m_positionFilter = AccelerationFilter{m_noise.position};
    m_samples = 1;
    m_time = sample.time;
    m_q_FO = sample.X_FO.rotation();
    m_p_FO = sample.X_FO.translation();
}

std::optional<Motion> MotionFilter::motion() const
{
    if (m_samples < kSamplesNeeded)
        return std::nullopt;
    return Motion{.v_FO = m_positionFilter.rate(),
                  .w_FO = m_rotationFilter.rate(),
                  .a_FO = m_positionFilter.acceleration(),
                  .alpha_FO = m_rotationFilter.acceleration(),
                  .growth = ErrorGrowth{.position = m_positionFilter.growth(),
                                        .rotation = m_rotationFilter.growth()}};
}

} // namespace carina
