#pragma once

#include "engine/tracking/pose_sample.h"

#include <optional>

namespace carina
{

/// A Kalman filter for a three-dimensional quantity of nearly constant acceleration (Bar-Shalom et
/// al. 2001, section 6.2.3): per axis the state (x, x', x''), driven by white jerk of spectral
/// density q^2. The axes are alike, so that one covariance serves all three; and x is held by the
/// caller, to whom the filter tells what to add, so that x may be a rotation.
class AccelerationFilter
{
public:
    struct Noise {
        double measurement = 0.0;  ///< standard deviation of x per axis
        double jerk = 0.0;         ///< q, unit of x per s^2.5
        double rate = 0.0;         ///< standard deviation of x' before anything is known
        double acceleration = 0.0; ///< of x''
    };

    explicit AccelerationFilter(const Noise& noise);

    /// Goes on by dt. @returns by how much x has changed.
    Vec3 predict(double dt);
    /// Takes in a measurement. @param innovation measured x less predicted x
    /// @returns what is to be added to x.
    Vec3 correct(const Vec3& innovation);

    [[nodiscard]] const Vec3& rate() const { return m_rate; }
    [[nodiscard]] const Vec3& acceleration() const { return m_acceleration; }

private:
    Noise m_noise;
    Vec3 m_rate = Vec3::Zero();
    Vec3 m_acceleration = Vec3::Zero();
    Mat3 m_covariance;
};

/// The velocity of a tracked object, from every sample its tracker gives: by it a pose is carried
/// on, here to the time of light and at the others' by what the owner sends along.
///
/// Position and rotation are filtered alike; the innovation of the rotation is the rotation vector
/// of q_measured q_predicted^-1, in axes of F.
class MotionFilter
{
public:
    struct Noise {
        AccelerationFilter::Noise rotation; ///< radians
        AccelerationFilter::Noise position; ///< metres
    };
    /// For hands and heads, at 30 to 90 samples a second.
    static Noise handsAndHeads();

    /// A gap longer than this begins anew.
    static constexpr Duration kLongestGap = std::chrono::milliseconds{150};
    /// So many samples in a row are needed before there is a velocity.
    static constexpr int kSamplesNeeded = 3;

    explicit MotionFilter(const Noise& noise = handsAndHeads());

    /// The next sample. A lost one, or one that is not later than the last, is left out.
    void add(const PoseSample& sample);

    /// Adds a sample. @returns it with the motion found at it; a lost one as it came.
    [[nodiscard]] PoseSample moving(PoseSample sample);

    /// At the newest sample; nothing while too few came in a row.
    [[nodiscard]] std::optional<Motion> motion() const;
    /// The filtered pose, carried on at the acceleration found. @pre motion()
    [[nodiscard]] RigidTransform predicted(SessionTime t) const;

private:
    void begin(const PoseSample& sample);

    Noise m_noise;
    AccelerationFilter m_rotationFilter;
    AccelerationFilter m_positionFilter;
    int m_samples = 0; // in a row
    SessionTime m_time{};
    Quat m_q_FO = Quat::Identity();
    Vec3 m_p_FO = Vec3::Zero();
};

} // namespace carina
