#pragma once

#include "evaluation/network/virtual_star.h"

namespace carina
{

/// What the viewers of a session in virtual time have before their eyes: the newest frame of each,
/// drawn as of the time at which it began, or without frames (ViewFrames) what is true for them at
/// that very time.
class DrawnViews
{
public:
    /// The displays start at the session's present; their phases and rates are drawn by the seed.
    DrawnViews(VirtualStar& star, const ViewFrames& frames, std::uint32_t seed);

    /// Runs the session to t, in which the frames until then are drawn. @pre t is not before that
    /// of the last call
    void runTo(Duration t);

    /// The pose X_AO of the object ActionScript::kTurned that a viewer sees: the identity while
    /// nothing is known of it. @pre viewer is 2 to the number of participants
    [[nodiscard]] const RigidTransform& turned(std::uint16_t viewer) const
    {
        return m_views[viewer - 2U].turned;
    }
    /// That of ActionScript::kMoved.
    [[nodiscard]] const RigidTransform& moved(std::uint16_t viewer) const
    {
        return m_views[viewer - 2U].moved;
    }

private:
    struct View {
        Duration frame{}; ///< how long one lasts; 0 without frames
        Duration next{};  ///< when the next begins
        RigidTransform turned{};
        RigidTransform moved{};
    };

    void draw(std::size_t view, Duration t);

    VirtualStar& m_star;
    std::vector<View> m_views; // of participant 2 and on
};

} // namespace carina
