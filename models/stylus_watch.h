#pragma once

#include "engine/registration/dwell_detector.h"
#include "engine/tracking/simulated_tracker.h"

#include <optional>
#include <vector>

namespace carina
{

/// A tracker's stylus, and the chin probe beside it, as a technician works with them: collects the
/// poses of a swing and finds the points that the tip was held at.
class StylusWatch
{
public:
    /// What came since the last look.
    struct News {
        std::vector<RigidTransform> swing; ///< X_TS of a whole swing; empty until there is one
        std::optional<DwellPoint> touch;   ///< the latest, in T
    };

    /// @pre tracker outlives this.
    StylusWatch(const Tracker& tracker, ReadSessionClock clock);

    /// Looks at the samples that came in. @param p_SQ the tip, once it is known
    [[nodiscard]] News look(const std::optional<Vec3>& p_SQ);

    void startSwing();
    void cancelSwing() { m_swinging = false; }
    [[nodiscard]] bool isSwinging() const { return m_swinging; }
    /// Shares of the swing and of the hold that are done, 0 to 1.
    [[nodiscard]] double swingProgress() const;
    [[nodiscard]] double holdProgress() const { return m_dwell.progress(); }
    /// Begins any hold anew.
    void forgetHold() { m_dwell = {}; }

    /// X_TS now; nothing while the stylus is not seen.
    [[nodiscard]] std::optional<RigidTransform> stylus() const;

    /// X_TJ of the chin probe, the mean of its latest second; nothing while it is not seen.
    [[nodiscard]] std::optional<RigidTransform> chin() const;

private:
    /// The samples of a tool, if it is seen now.
    [[nodiscard]] std::vector<PoseSample> seen(ToolRole role) const;

    std::vector<TrackedTool> m_tools;
    ReadSessionClock m_clock;
    std::optional<SessionTime> m_looked; ///< newest sample that was looked at
    bool m_swinging = false;
    std::vector<RigidTransform> m_swing; ///< X_TS
    DwellDetector m_dwell;
};

} // namespace carina
