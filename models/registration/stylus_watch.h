#pragma once

#include "engine/registration/calibration/pivot_collector.h"
#include "engine/registration/calibration/spin_calibration.h"
#include "engine/registration/landmarks/dwell_detector.h"
#include "engine/tracking/simulated_tracker.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// What the stylus is watched for.
enum class StylusUse : std::uint8_t {
    Nothing,
    Pivot, ///< its tip: swung with the tip in a divot
    Spin,  ///< its axis: spun about the shaft
    Touch, ///< points that it is held at
    Swab,  ///< a surface that it slides over
};

/// A point that was touched, and how the stylus was held.
struct StylusTouch {
    DwellPoint point; ///< in T
    Quat q_TS = Quat::Identity();
};

/// What came of the samples since the last look.
struct StylusNews {
    std::optional<PivotCalibration> tip{};
    std::optional<Result<SpinCalibration>> axis{};
    std::optional<StylusTouch> touch{};
};

/// A tracker's stylus, and the probes on chin and body beside it, as a technician works with them.
class StylusWatch
{
public:
    /// @pre tracker outlives this.
    StylusWatch(const Tracker& tracker, ReadSessionClock clock);

    /// The tracker's name of the stylus; empty for a tracker without one.
    [[nodiscard]] std::string tool() const;
    /// Whether the tracker has such a tool, seen or not.
    [[nodiscard]] bool has(ToolRole role) const;

    /// Watches for something else from now on.
    void watchFor(StylusUse use);
    /// Watches for the same anew.
    void restart() { watchFor(m_use); }
    [[nodiscard]] StylusUse use() const { return m_use; }

    /// Where its tip is, metres; nothing is spun, touched or swabbed while that is not known.
    void setTip(const std::optional<Vec3>& p_SQ) { m_p_SQ = p_SQ; }

    [[nodiscard]] StylusNews look();

    [[nodiscard]] const PivotProgress& pivot() const { return m_pivot.progress(); }
    /// How much of what is watched for is done, 0 to 1; always 0 for a swab, which has no end.
    [[nodiscard]] double progress() const;
    /// p_TQ on the surface so far, at least kSwabStep apart.
    [[nodiscard]] const std::vector<Vec3>& swab() const { return m_swab; }

    /// Takes the point that the tip is at, so that it is not taken again by resting there: the
    /// mean of its latest quarter of a second; nothing while the stylus is not seen or its tip not
    /// known.
    std::optional<StylusTouch> takePoint();
    /// Whether the tip is still where the last point was taken.
    [[nodiscard]] bool restsWhereTaken() const;

    /// X_TS now; nothing while the stylus is not seen.
    [[nodiscard]] std::optional<RigidTransform> stylus() const;

    /// X_T<probe>, the mean of its latest second; nothing while it is not seen.
    [[nodiscard]] std::optional<RigidTransform> probe(ToolRole role) const;

    static constexpr Length kSwabStep = millimetres(1.5);
    static constexpr std::size_t kMostSwabPoints = 400;

private:
    void take(const PoseSample& sample, StylusNews& news);
    void takeHeld(const PoseSample& sample, const Vec3& p_TQ, StylusNews& news);
    void leave(const Vec3& p_TQ);
    void takeSpun(const RigidTransform& X_TS, StylusNews& news);
    void takeSwabbed(const Vec3& p_TQ);
    [[nodiscard]] std::optional<StylusTouch> pointNow() const;
    /// The samples of a tool, if it is seen now.
    [[nodiscard]] std::vector<PoseSample> seen(ToolRole role) const;
    /// Those of its latest time that were not lost.
    [[nodiscard]] std::vector<PoseSample> latest(ToolRole role, Duration time) const;

    std::vector<TrackedTool> m_tools;
    ReadSessionClock m_clock;
    std::optional<SessionTime> m_looked; ///< what was seen until then does not count any more
    StylusUse m_use = StylusUse::Nothing;
    std::optional<Vec3> m_p_SQ;
    PivotCollector m_pivot;
    std::vector<RigidTransform> m_spun; ///< X_TS
    DwellDetector m_dwell;
    bool m_leavesFirst = true;        ///< the tip was not seen yet since it is watched for this
    std::optional<Vec3> m_p_TQ_taken; ///< the last point, since it is watched for this
    std::vector<Vec3> m_swab;
};

} // namespace carina
