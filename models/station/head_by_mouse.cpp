#include "models/station/head_by_mouse.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

/// Of a unit vector along a chosen side: less of it than this is level where the side is above or
/// below.
constexpr double kLeastLevel = 0.5;

Vec3 upBeside(BodyPosition position)
{
    switch (position) {
    case BodyPosition::Supine:
        return -Vec3::UnitY();
    case BodyPosition::Sitting:
        return Vec3::UnitZ();
    case BodyPosition::Prone:
        return Vec3::UnitY();
    case BodyPosition::RightLateral:
        return Vec3::UnitX();
    case BodyPosition::LeftLateral:
        return -Vec3::UnitX();
    }
    return -Vec3::UnitY();
}

/// From the mouth to the side where the person stands: a level unit vector in A.
Vec3 sideBeside(const PlaceBeside& place, const Vec3& up_A)
{
    const Vec3 chosen_A = placedBy(place.turn) * Vec3::UnitZ();
    const Vec3 level_A = chosen_A - chosen_A.dot(up_A) * up_A;
    if (level_A.norm() > kLeastLevel)
        return level_A.normalized();
    return place.position == BodyPosition::Sitting ? Vec3{-Vec3::UnitY()} : Vec3::UnitZ();
}

} // namespace

bool looksByMouse(const StationMoment& moment, ViewOutput output)
{
    const bool isClockSet = moment.time != SessionTime{};
    return output != ViewOutput::Screen && isClockSet && !moment.head && !moment.headIsAwaited;
}

void HeadByMouse::turn(double right, double down)
{
    constexpr double kCircle = 2.0 * std::numbers::pi;
    m_yaw = std::remainder(m_yaw + right * kTurnPerHeight.si, kCircle);
    m_pitch = std::clamp(m_pitch + down * kTurnPerHeight.si, -kSteepest.si, kSteepest.si);
}

void HeadByMouse::comeNearer(double factor)
{
    CARINA_EXPECTS(factor > 0.0);
    m_distance = std::clamp(m_distance / factor, kNearest, kFarthest);
}

RigidTransform HeadByMouse::poseAt(const PlaceBeside& place) const
{
    const Vec3 up_A = upBeside(place.position);
    const Vec3 side_A = sideBeside(place, up_A);
    const Vec3 toHead_A = std::cos(kElevation.si) * side_A + std::sin(kElevation.si) * up_A;
    const Vec3 level_A = rotationFromVector(m_yaw * up_A) * Vec3{-side_A};
    const Vec3 back_A = -(std::cos(m_pitch) * level_A + std::sin(m_pitch) * up_A);
    const Vec3 right_A = level_A.cross(up_A);
    Mat3 R_AH;
    R_AH << right_A, back_A.cross(right_A), back_A;
    return {Quat{R_AH}, place.p_A_mouth + m_distance * toHead_A};
}

} // namespace carina
