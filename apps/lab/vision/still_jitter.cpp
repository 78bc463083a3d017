#include "apps/lab/vision/still_jitter.h"

#include "engine/geometry/rotation.h"

#include <cmath>
#include <span>

namespace carina::lab
{
namespace
{

constexpr std::size_t kStretch = 10;
constexpr double kStillPosition = 0.5e-3; ///< metres
constexpr Angle kStillRotation = degrees(0.5);

/// The mean pose of some that differ little.
RigidTransform meanPose(std::span<const RigidTransform> poses)
{
    Vec3 position = Vec3::Zero();
    Vec3 turn = Vec3::Zero(); // from the first
    const Quat first = poses.front().rotation();
    for (const RigidTransform& pose : poses) {
        position += pose.translation() / double(poses.size());
        turn += rotationVector(pose.rotation() * first.conjugate()) / double(poses.size());
    }
    return {rotationFromVector(turn) * first, position};
}

} // namespace

void StillJitter::add(const std::optional<RigidTransform>& X_TO)
{
    if (!X_TO) {
        m_stretch.clear();
        return;
    }
    m_stretch.push_back(*X_TO);
    if (m_stretch.size() == kStretch) {
        judge();
        m_stretch.clear();
    }
}

void StillJitter::judge()
{
    const std::span<const RigidTransform> all{m_stretch};
    const RigidTransform before = meanPose(all.first(kStretch / 2));
    const RigidTransform after = meanPose(all.last(kStretch / 2));
    if ((before.translation() - after.translation()).norm() > kStillPosition
        || angleBetween(before.rotation(), after.rotation()) > kStillRotation)
        return;
    const RigidTransform mean = meanPose(all);
    for (const RigidTransform& pose : all) {
        const double turn = angleBetween(pose.rotation(), mean.rotation()).si;
        m_positionSquares += (pose.translation() - mean.translation()).squaredNorm();
        m_rotationSquares += turn * turn;
    }
    m_samples += int(kStretch);
}

// The mean takes the share of one pose of each stretch.
std::optional<double> StillJitter::position_mm() const
{
    const double freedom = m_samples * (1.0 - 1.0 / double(kStretch));
    return m_samples > 0 ? std::optional{1e3 * std::sqrt(m_positionSquares / freedom)}
                         : std::nullopt;
}

std::optional<double> StillJitter::rotation_deg() const
{
    const double freedom = m_samples * (1.0 - 1.0 / double(kStretch));
    return m_samples > 0 ? std::optional{inDegrees(radians(std::sqrt(m_rotationSquares / freedom)))}
                         : std::nullopt;
}

} // namespace carina::lab
