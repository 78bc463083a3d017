#pragma once

#include "engine/net/node/session_node.h"
#include "models/tracker/played_motion.h"

#include <atomic>
#include <cstddef>

namespace carina
{

/// A motion in a session. It begins when this program's participant is at work at the station and
/// the session runs, pauses with that, and is held after its end.
class PlayedHands
{
public:
    /// @pre node outlives this.
    PlayedHands(SessionNode& node, PlayedMotion motion);

    /// Where they are at a session time. May be called from any thread.
    [[nodiscard]] HandledTools at(SessionTime t) const;

    /// Begins when it is time, and proposes what was done by controls since the last look. To be
    /// called often, from one thread.
    void look(StationId station);

private:
    static constexpr Duration kNotBegun = Duration::max();

    [[nodiscard]] Duration progressAt(SessionTime t) const;

    SessionNode& m_node;
    PlayedMotion m_motion;
    std::atomic<Duration> m_begun{kNotBegun}; ///< running time of the session
    std::size_t m_done = 0;                   ///< of the controls
};

/// The motion, of which the tip of the stylus goes where its origin went.
/// @param X_SP the tip in the frame S of the stylus' markers
[[nodiscard]] HandMotion heldByTip(HandMotion motion, const RigidTransform& X_SP);

} // namespace carina
