#pragma once

#include "engine/tracking/pose_sample.h"

#include <optional>

namespace carina
{

/// A Kalman filter for a three-dimensional quantity of nearly constant acceleration (Bar-Shalom et
/// al. 2001, section 6.2.3): per axis the state (x, x', x''), driven by white jerk of spectral
/// density q^2. All axes have the same noise and share one covariance. The caller stores x and adds
/// the increments that the filter returns, so that x may be a rotation.
class AccelerationFilter
{
public:
    struct Noise {
        double measurement = 0.0;  ///< standard deviation of x per axis
        double jerk = 0.0;         ///< q, unit of x per s^2.5
        double rate = 0.0;         ///< initial standard deviation of x'
        double acceleration = 0.0; ///< initial standard deviation of x''
    };

    explicit AccelerationFilter(const Noise& noise);

    /// Predicts the state dt seconds later. @returns the increment of x.
    Vec3 predict(double dt);
    /// Corrects the state by a measurement.
    /// @param innovation measured x minus predicted x
    /// @returns the increment of x.
    Vec3 correct(const Vec3& innovation);

    [[nodiscard]] const Vec3& rate() const { return m_rate; }
    [[nodiscard]] const Vec3& acceleration() const { return m_acceleration; }
    /// The variance of x per axis when it is predicted without further measurements.
    [[nodiscard]] ErrorGrowth::Polynomial growth() const;

private:
    Noise m_noise;
    Vec3 m_rate = Vec3::Zero();
    Vec3 m_acceleration = Vec3::Zero();
    Mat3 m_covariance;
};

/// Estimates velocity and acceleration of a tracked object O in F from its tracker's samples, for a
/// noise that is known: the estimated uncertainty is right where that is. A MotionPredictor has
/// several of them.
///
/// Position and rotation have one AccelerationFilter each; the innovation of the rotation is the
/// rotation vector of q_measured q_predicted^-1, in axes of F.
class MotionFilter
{
public:
    struct Noise {
        AccelerationFilter::Noise rotation; ///< radians
        AccelerationFilter::Noise position; ///< metres
    };
    /// Noise for hands and heads, at 30 to 90 samples per second.
    static Noise handsAndHeads();

    /// After a gap longer than this the filter restarts.
    static constexpr Duration kLongestGap = std::chrono::milliseconds{150};
    /// Number of samples since the (re)start from which on there is a velocity.
    static constexpr int kSamplesNeeded = 3;

    explicit MotionFilter(const Noise& noise = handsAndHeads());

    /// Adds the next sample. One that is lost, or not later than the last, is ignored.
    void add(const PoseSample& sample);

    /// The motion at the newest sample, and how uncertain a pose becomes that is predicted with it;
    /// nothing before kSamplesNeeded samples.
    [[nodiscard]] std::optional<Motion> motion() const;
    /// The filtered pose X_FO at the newest sample, from which motion() goes on (movedOn).
    [[nodiscard]] RigidTransform pose() const { return {m_q_FO, m_p_FO}; }

private:
    void begin(const PoseSample& sample);

    Noise m_noise;
    AccelerationFilter m_rotationFilter;
    AccelerationFilter m_positionFilter;
    int m_samples = 0; // since the (re)start, at most kSamplesNeeded
    SessionTime m_time{};
    Quat m_q_FO = Quat::Identity();
    Vec3 m_p_FO = Vec3::Zero();
};

} // namespace carina
