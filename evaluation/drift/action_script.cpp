#include "evaluation/drift/action_script.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace carina
{
namespace
{

// Written out, for the distributions of the standard library differ from one to the next.
double unitOf(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

Vec3 drawnAxis(ActionScript::Axes axes, std::mt19937& random)
{
    if (axes == ActionScript::Axes::Cartesian) {
        const auto which = static_cast<int>(6.0 * unitOf(random));
        return (which % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(which / 2);
    }
    // Archimedes: the height on a sphere is even.
    const double z = 2.0 * unitOf(random) - 1.0;
    const double longitude = 2.0 * std::numbers::pi * unitOf(random);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(longitude), r * std::sin(longitude), z};
}

} // namespace

ActionScript::ActionScript(const Settings& settings, std::uint32_t seed) : m_settings{settings}
{
    CARINA_EXPECTS(settings.actions >= 1);
    std::mt19937 random{seed};
    Pose pose{Vec3::Zero(), Quat::Identity(), Vec3::Zero()};
    const double seconds = toSeconds(kActionTime);
    for (int action = 0; action < settings.actions; ++action) {
        pose.axis_A = drawnAxis(settings.axes, random);
        m_poses.push_back(pose);
        pose.q_AO = (rotationFromVector(settings.angularSpeed * seconds * pose.axis_A) * pose.q_AO)
                        .normalized();
        pose.p_AO += settings.speed * seconds * pose.axis_A;
    }
}

int ActionScript::actionAt(Duration t) const
{
    return std::clamp(static_cast<int>(t / kActionTime), 0, actions() - 1);
}

Quat ActionScript::q_AO(Duration t) const
{
    const int action = actionAt(t);
    const Pose& pose = m_poses[static_cast<std::size_t>(action)];
    const double seconds = std::max(0.0, toSeconds(t - startOf(action)));
    return rotationFromVector(m_settings.angularSpeed * seconds * pose.axis_A) * pose.q_AO;
}

double ActionScript::changeOfAxis(int action) const
{
    const auto index = static_cast<std::size_t>(action);
    const Vec3 before = action == 0 ? Vec3::Zero() : m_poses[index - 1].axis_A;
    return (m_poses[index].axis_A - before).norm();
}

double ActionScript::changeOfAngularVelocity(int action) const
{
    return m_settings.angularSpeed * changeOfAxis(action);
}

double ActionScript::changeOfVelocity(int action) const
{
    return m_settings.speed * changeOfAxis(action);
}

EventCpo ActionScript::rotation(int action) const
{
    EventCpo event;
    event.object = kTurned;
    event.action = static_cast<std::uint32_t>(action + 1);
    if (action < 0)
        return event;
    const Pose& pose = m_poses[static_cast<std::size_t>(action)];
    event.q_AO = pose.q_AO;
    event.axis_A = pose.axis_A.cast<float>();
    event.rate = static_cast<float>(m_settings.angularSpeed);
    return event;
}

EventCpo ActionScript::translation(int action) const
{
    EventCpo event;
    event.object = kMoved;
    event.action = static_cast<std::uint32_t>(action + 1);
    event.kind = ActionKind::Translation;
    if (action < 0)
        return event;
    const Pose& pose = m_poses[static_cast<std::size_t>(action)];
    event.p_AO = pose.p_AO;
    event.axis_A = pose.axis_A.cast<float>();
    event.rate = static_cast<float>(m_settings.speed);
    return event;
}

} // namespace carina
