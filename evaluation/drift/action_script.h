#pragma once

#include "engine/sync/wire/event_cpo.h"

#include <cstdint>
#include <vector>

namespace carina
{

/// The experiment of the 2004 paper: one object turned and another moved by successive actions,
/// each of kActionTime at a constant rate about (and along) a new random axis. The truth of the
/// drift measurement, in closed form: the pose at any time is the pose at the action's start and
/// the rate times the time since then.
class ActionScript
{
public:
    enum class Axes : std::uint8_t {
        Cartesian, ///< one of +-x, +-y, +-z
        Random,    ///< evenly on the sphere
    };
    struct Settings {
        int actions = 50;
        double angularSpeed = 0.0; ///< rad/s
        double speed = 0.0;        ///< m/s
        Axes axes = Axes::Cartesian;
    };

    static constexpr Duration kActionTime = std::chrono::milliseconds{1200};
    static constexpr ObjectId kTurned{1};
    static constexpr ObjectId kMoved{2};

    /// @pre at least one action
    ActionScript(const Settings& settings, std::uint32_t seed);

    /// Virtual time 0 for the first.
    [[nodiscard]] static Duration startOf(int action) { return action * kActionTime; }
    [[nodiscard]] int actions() const { return static_cast<int>(m_poses.size()); }

    /// Of the object kTurned; at rest before the first action.
    [[nodiscard]] Quat q_AO(Duration t) const;
    /// Of the object kMoved.
    [[nodiscard]] Vec3 p_AO(Duration t) const;
    /// |w_k - w_(k-1)|, rad/s: what nobody elsewhere can know when action k starts.
    [[nodiscard]] double changeOfAngularVelocity(int action) const;
    /// The same of the object that is moved, m/s.
    [[nodiscard]] double changeOfVelocity(int action) const;

    /// What the actor does at the start of an action, -1 for both objects at rest before the first.
    [[nodiscard]] EventCpo rotation(int action) const;
    [[nodiscard]] EventCpo translation(int action) const;

private:
    struct Pose {
        Vec3 axis_A;
        Quat q_AO; ///< at the action's start
        Vec3 p_AO;
    };

    [[nodiscard]] int actionAt(Duration t) const;
    [[nodiscard]] double changeOfAxis(int action) const;

    Settings m_settings;
    std::vector<Pose> m_poses; // one for each action
};

} // namespace carina
