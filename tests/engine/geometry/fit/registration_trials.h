#pragma once

#include "engine/geometry/rotation.h"
#include "tests/engine/geometry/fit/horn.h"

#include <Eigen/Cholesky>

#include <array>
#include <random>

namespace carina::test
{

/// Places in a man of 1.75 m, metres in A: those by which an intubation is judged.
inline const std::array kTargets{Vec3{0.0, -0.026, 0.124}, Vec3{0.0, 0.0, 0.0},
                                 Vec3{0.0, -0.103, 0.175}, Vec3{0.09, 0.02, -0.17},
                                 Vec3{-0.09, 0.02, -0.17}};
inline constexpr std::array kTargetNames{"glottis", "carina", "incisors", "left lung base",
                                         "right lung base"};

/// Rib cage (four), angles of the jaw (six), tenth ribs (eight).
inline const std::array kEightLandmarks{Vec3{0.0, -0.060, 0.036},    Vec3{0.0, -0.132, -0.132},
                                        Vec3{0.081, -0.123, -0.111}, Vec3{-0.081, -0.123, -0.111},
                                        Vec3{0.052, -0.017, 0.175},  Vec3{-0.052, -0.017, 0.175},
                                        Vec3{0.123, -0.037, -0.270}, Vec3{-0.123, -0.037, -0.270}};

inline std::vector<Vec3> firstLandmarks(int count)
{
    return {kEightLandmarks.begin(), kEightLandmarks.begin() + count};
}

/// Draws errors of given covariances.
class Hand
{
public:
    explicit Hand(unsigned seed) : m_random{seed} {}

    Vec3 unit() { return {m_part(m_random), m_part(m_random), m_part(m_random)}; }
    /// With the lower factor of a covariance.
    Vec3 error(const Mat3& factor) { return factor * unit(); }
    RigidTransform pose()
    {
        const Quat q{m_part(m_random), m_part(m_random), m_part(m_random), m_part(m_random)};
        return {q, unit()};
    }
    std::mt19937_64& random() { return m_random; }

private:
    std::mt19937_64 m_random;
    std::normal_distribution<double> m_part;
};

inline Mat3 factorOf(const Mat3& covariance) { return covariance.llt().matrixL(); }

/// An ellipsoid with these deviations (metres) along axes turned by a rotation vector.
inline Mat3 ellipsoid(const Vec3& deviations, const Vec3& turn)
{
    const Mat3 axes = rotationFromVector(turn).toRotationMatrix();
    return axes * deviations.cwiseProduct(deviations).asDiagonal() * axes.transpose();
}

/// Unlike ellipsoids for the landmarks, deviations of 0.3 to 2.4 mm: worst along a tracker's depth
/// at some, along a rib at others.
inline std::vector<Mat3> unlikeErrors(std::size_t count)
{
    std::vector<Mat3> errors;
    for (std::size_t i = 0; i < count; ++i) {
        const double k = double(i);
        errors.push_back(1e-6
                         * ellipsoid({0.3 + 0.1 * k, 0.8, 2.4 - 0.15 * k},
                                     {0.5 * k, 1.0 - 0.3 * k, 0.2 * k * k}));
    }
    return errors;
}

/// The pose from b to a with the least weighted squares, by another way than the engine's: the
/// rotation is parted into a known one and Cayley's small one, the translation eliminated.
inline RigidTransform weightedFit(const std::vector<Vec3>& p_A, const std::vector<Vec3>& p_B,
                                  const std::vector<Mat3>& weights)
{
    RigidTransform X_AB = hornFit(p_A, p_B);
    for (int step = 0; step < 8; ++step) {
        Mat3 sum = Mat3::Zero();
        Vec3 mean_e = Vec3::Zero();
        Mat3 mean_d = Mat3::Zero();
        std::vector<Mat3> crosses;
        std::vector<Vec3> errors;
        for (std::size_t i = 0; i < p_A.size(); ++i) {
            const Vec3 q = X_AB.rotation() * p_B[i];
            Mat3 d; // of the turned point along the small rotation
            d << 0, q.z(), -q.y(), -q.z(), 0, q.x(), q.y(), -q.x(), 0;
            crosses.push_back(d);
            errors.push_back(p_A[i] - q);
            sum += weights[i];
            mean_e += weights[i] * errors[i];
            mean_d += weights[i] * d;
        }
        const Mat3 share = sum.inverse();
        mean_e = share * mean_e;
        mean_d = share * mean_d;
        Mat3 left = Mat3::Zero();
        Vec3 right = Vec3::Zero();
        for (std::size_t i = 0; i < p_A.size(); ++i) {
            const Mat3 d = crosses[i] - mean_d;
            left += d.transpose() * weights[i] * d;
            right += d.transpose() * weights[i] * (errors[i] - mean_e);
        }
        const Vec3 turn = left.ldlt().solve(right);
        const Quat cayley{1.0, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()};
        const Quat rotation = cayley.normalized() * X_AB.rotation();
        Vec3 shift = Vec3::Zero();
        for (std::size_t i = 0; i < p_A.size(); ++i)
            shift += share * weights[i] * (p_A[i] - rotation * p_B[i]);
        X_AB = {rotation, shift};
    }
    return X_AB;
}

} // namespace carina::test
