#include "widgets/scene/view/orbit_camera.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{

namespace
{

constexpr double kMargin = 1.05;       ///< of the fitting distance
constexpr double kTurnPerHeight = 3.0; ///< radians per picture height dragged
constexpr double kSteepest = 1.55;     ///< radians; short of the pole, where yaw loses its meaning
constexpr double kTraineePitch = 0.9;  ///< radians, from above the head towards the chest
constexpr double kNearest = 0.02;      ///< metres from the target
constexpr double kFarthest = 20.0;     ///< metres
constexpr double kVerticalSine =
    1e-6; ///< of the angle to the vertical, below which yaw shows in up

double yawOf(ViewPreset preset)
{
    switch (preset) {
    case ViewPreset::Front:
        return 0.0;
    case ViewPreset::Left:
        return std::numbers::pi / 2.0;
    case ViewPreset::Right:
        return -std::numbers::pi / 2.0;
    case ViewPreset::Back:
    case ViewPreset::Trainee:
        return std::numbers::pi;
    }
    return 0.0;
}

/// From the patient to the eye.
Vec3 directionOf(ViewPreset preset)
{
    const double yaw = yawOf(preset);
    return {std::sin(yaw), -std::cos(yaw), 0.0};
}

/// What is up while the patient lies.
Vec3 upOf(Lie lie)
{
    switch (lie) {
    case Lie::OnBack:
        return -Vec3::UnitY();
    case Lie::OnFront:
        return Vec3::UnitY();
    case Lie::OnRightSide:
        return Vec3::UnitX();
    case Lie::OnLeftSide:
        return -Vec3::UnitX();
    case Lie::Upright:
        break;
    }
    return Vec3::UnitZ();
}

Mat3 roomOf(Lie lie)
{
    if (lie == Lie::Upright)
        return Mat3::Identity();
    const Vec3 up = upOf(lie);
    Mat3 R_AW;
    R_AW << Vec3::UnitZ().cross(up), Vec3::UnitZ(), up;
    return R_AW;
}

constexpr double kReach = 2.0;        ///< metres about the bounds within which tools are seen
constexpr double kDepthRange = 500.0; ///< far plane over near plane

} // namespace

void OrbitCamera::setAspect(double widthOverHeight)
{
    CARINA_EXPECTS(widthOverHeight > 0.0);
    m_aspect = widthOverHeight;
    if (m_fitted)
        showFrom(m_preset);
}

void OrbitCamera::showFrom(ViewPreset preset)
{
    m_preset = preset;
    lookFrom(preset);
    m_target_A = m_bounds_A.empty() ? Vec3::Zero() : m_bounds_A.centre();
    m_distance = fittingDistance();
    m_fitted = true;
}

void OrbitCamera::setLie(Lie lie)
{
    if (lie == m_lie)
        return;
    m_lie = lie;
    m_R_AW = roomOf(lie);
    showFrom(m_preset);
}

void OrbitCamera::lookFrom(ViewPreset preset)
{
    const bool isTrainee = preset == ViewPreset::Trainee;
    m_level = isTrainee && m_lie == Lie::Upright ? std::numbers::pi : 0.0;
    if (m_lie == Lie::Upright) {
        m_yaw = yawOf(preset);
        m_pitch = isTrainee ? m_level - kTraineePitch : 0.0;
        return;
    }
    if (isTrainee) {
        m_yaw = std::numbers::pi;
        m_pitch = std::numbers::pi / 2.0 - kTraineePitch;
        return;
    }
    const Vec3 eye = m_R_AW.transpose() * directionOf(preset);
    const bool isVertical = std::abs(eye.z()) > 0.5;
    m_pitch = isVertical ? std::copysign(std::numbers::pi / 2.0, eye.z()) : 0.0;
    if (isVertical)
        m_yaw = eye.z() > 0.0 ? 0.0 : std::numbers::pi;
    else
        m_yaw = std::atan2(eye.x(), -eye.y());
}

void OrbitCamera::look(const CameraPose& pose)
{
    const Vec3 back_A = pose.p_A_eye - pose.p_A_target;
    CARINA_EXPECTS(back_A.norm() > 0.0);
    const Vec3 back = m_R_AW.transpose() * back_A.normalized();
    const Vec3 up = m_R_AW.transpose() * pose.up_A;
    const bool isVertical = std::hypot(back.x(), back.y()) < kVerticalSine;
    const bool isUpsideDown = !isVertical && up.z() < 0.0;
    m_pitch = std::asin(std::clamp(back.z(), -1.0, 1.0));
    m_yaw = std::atan2(back.x(), -back.y());
    if (isVertical)
        m_yaw = back.z() > 0.0 ? std::atan2(-up.x(), up.y()) : std::atan2(up.x(), -up.y());
    m_level = 0.0;
    if (isUpsideDown) {
        m_yaw += std::numbers::pi;
        m_pitch = std::numbers::pi - m_pitch;
        m_level = std::numbers::pi;
    }
    m_target_A = pose.p_A_target;
    m_distance = std::clamp(back_A.norm(), kNearest, kFarthest);
    m_fitted = false;
}

void OrbitCamera::orbit(double right, double down)
{
    m_yaw -= (m_level == 0.0 ? right : -right) * kTurnPerHeight;
    m_pitch = std::clamp(m_pitch + down * kTurnPerHeight, m_level - kSteepest, m_level + kSteepest);
    m_fitted = false;
}

void OrbitCamera::pan(double right, double down)
{
    const double height = 2.0 * m_distance * std::tan(kVerticalFieldOfView / 2.0);
    const Vec3 rightward = up().cross(backward());
    m_target_A += height * (down * up() - right * rightward);
    m_fitted = false;
}

void OrbitCamera::zoom(double factor)
{
    CARINA_EXPECTS(factor > 0.0);
    m_distance = std::clamp(m_distance / factor, kNearest, kFarthest);
    m_fitted = false;
}

CameraPose OrbitCamera::pose() const
{
    CameraPose pose;
    pose.p_A_eye = m_target_A + m_distance * backward();
    pose.p_A_target = m_target_A;
    pose.up_A = up();
    return withPlanes(pose);
}

Frustum OrbitCamera::frustum() const
{
    const double up = std::tan(0.5 * kVerticalFieldOfView);
    const double right = m_aspect * up;
    return {.left = -right, .right = right, .bottom = -up, .top = up};
}

CameraPose OrbitCamera::poseOf(const RigidTransform& X_AD) const
{
    CameraPose pose;
    pose.p_A_eye = X_AD.translation();
    pose.p_A_target = X_AD * Vec3(0.0, 0.0, -1.0);
    pose.up_A = X_AD.rotation() * Vec3::UnitY();
    return withPlanes(pose);
}

CameraPose OrbitCamera::withPlanes(CameraPose pose) const
{
    const bool empty = m_bounds_A.empty();
    const Vec3 p_A_centre = empty ? Vec3(Vec3::Zero()) : m_bounds_A.centre();
    const double radius = empty ? 0.0 : 0.5 * m_bounds_A.size().norm();
    pose.farPlane = (pose.p_A_eye - p_A_centre).norm() + radius + kReach;
    pose.nearPlane = pose.farPlane / kDepthRange;
    return pose;
}

Vec3 OrbitCamera::backward() const
{
    return m_R_AW
           * Vec3{std::sin(m_yaw) * std::cos(m_pitch), -std::cos(m_yaw) * std::cos(m_pitch),
                  std::sin(m_pitch)};
}

Vec3 OrbitCamera::up() const
{
    return m_R_AW
           * Vec3{-std::sin(m_yaw) * std::sin(m_pitch), std::cos(m_yaw) * std::sin(m_pitch),
                  std::cos(m_pitch)};
}

/// A corner at (r, u, b) to the right of, above and behind the target is in the picture when the
/// distance is at least b + |u| / tan(fov / 2) and b + |r| / (aspect tan(fov / 2)).
double OrbitCamera::fittingDistance() const
{
    if (m_bounds_A.empty())
        return 1.0;
    const Vec3 rightward = up().cross(backward());
    const double tangent = std::tan(kVerticalFieldOfView / 2.0);
    double distance = kNearest;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 side{(corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                        (corner & 4) != 0 ? 0.5 : -0.5};
        const Vec3 offset = side.cwiseProduct(m_bounds_A.size());
        const double behind = offset.dot(backward());
        distance = std::max({distance, behind + std::abs(offset.dot(up())) / tangent,
                             behind + std::abs(offset.dot(rightward)) / (m_aspect * tangent)});
    }
    return kMargin * distance;
}

} // namespace carina
