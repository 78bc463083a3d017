#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <vector>

namespace carina::program
{

/// A stylus that is held to the chest in place of a stethoscope, at one place after the other. It
/// is parked with its axes parallel to A, and listens with the shaft (-z) straight to the back.
/// From one place to the next it goes in kListenerReach by a minimum-jerk movement, in an arc over
/// the chest. These times and lengths are of ours.
class ListeningRound
{
public:
    /// @param p_A_places of the skin, in their order
    ListeningRound(const Vec3& p_A_parked, std::vector<Vec3> p_A_places);

    /// Goes round once, from this time of a motion on, and back; nowhere that it would not have
    /// left before `until`. @pre from is not before the stylus is back from the former round
    void listen(Duration from, Duration until = Duration::max());

    /// X_AS of the stylus at a time of the motion, with its tip as origin.
    [[nodiscard]] RigidTransform at(Duration t) const;

private:
    struct Stop {
        Duration from{}; ///< when the stylus leaves the stop before
        RigidTransform X_AS;
    };

    std::vector<Vec3> m_p_A_places;
    std::vector<Stop> m_stops; ///< by time; the first is where it is parked
};

inline constexpr Duration kListenerReach = std::chrono::seconds{1};
/// How long it is held to a place: at least one whole breath at 12 a minute.
inline constexpr Duration kAtEachPlace = std::chrono::seconds{8};

} // namespace carina::program
