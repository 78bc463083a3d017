#pragma once

#include "engine/sync/wire/event_cpo.h"

#include <cstdint>
#include <vector>

namespace carina
{

/// The actions of the experiment of Hamza-Lup et al. 2004: one object is rotated about, another
/// translated along, a new random axis in each action, for kActionTime at constant speed. It is
/// also the ground truth of the drift measurement, in closed form: the pose at the action's start
/// plus speed times the time since then.
class ActionScript
{
public:
    enum class Axes : std::uint8_t {
        Cartesian, ///< one of +-x, +-y, +-z
        Random,    ///< uniform on the sphere
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

    /// Start of an action in virtual time; 0 for the first.
    [[nodiscard]] static Duration startOf(int action) { return action * kActionTime; }
    [[nodiscard]] int actions() const { return static_cast<int>(m_poses.size()); }

    /// Orientation of the object kTurned in A; constant before the first action. Of q and -q it is
    /// the product of all rotations so far, as a program has it that multiplies them.
    [[nodiscard]] Quat q_AO(Duration t) const;
    /// |w_k - w_(k-1)|, rad/s: the change at the start of action k, unknown to other participants
    /// then.
    [[nodiscard]] double changeOfAngularVelocity(int action) const;
    /// The same for the velocity of kMoved, m/s.
    [[nodiscard]] double changeOfVelocity(int action) const;

    /// The event that the actor sends at the start of an action; -1: the initial state, at rest.
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
