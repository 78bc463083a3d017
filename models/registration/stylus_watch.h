#pragma once

#include "engine/registration/calibration/pivot_collector.h"
#include "engine/registration/calibration/spin_calibration.h"
#include "engine/registration/landmarks/dwell_detector.h"
#include "engine/tracking/simulated/simulated_tracker.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// What the poses of the stylus are used for.
enum class StylusUse : std::uint8_t {
    Nothing,
    Pivot, ///< tip calibration: pivoted with the tip in a divot
    Spin,  ///< axis calibration: spun about the shaft
    Touch, ///< points at which the tip is held still
    Swab,  ///< points while the tip slides over a surface
};

/// A touched point, and the orientation of the stylus.
struct StylusTouch {
    DwellPoint point; ///< in T, or in the frame of the touched tool
    Quat q_TS = Quat::Identity();
    /// With which the tracker saw the tip meanwhile (RMS, of one pose); where that is known, and
    /// not where the touched tool is seen, too.
    std::optional<Length> seenError{};
};

/// The results from the samples since the last look().
struct StylusNews {
    std::optional<PivotCalibration> tip{};
    std::optional<Result<SpinCalibration>> axis{};
    std::optional<StylusTouch> touch{};
};

/// Evaluates the poses of a tracker's stylus during registration, and returns those of the probes
/// on chin and body.
class StylusWatch
{
public:
    /// @pre tracker outlives this.
    StylusWatch(const Tracker& tracker, ReadSessionClock clock);

    /// The tracker's name for the stylus; empty if it has none.
    [[nodiscard]] std::string tool() const;
    /// The stylus as the tracker knows it; std::nullopt if it has none.
    [[nodiscard]] std::optional<TrackedTool> stylusTool() const;
    /// The error with which the tracker sees the tip now (RMS), predicted from the markers of the
    /// stylus; std::nullopt where predictedError has none, and without a tip.
    [[nodiscard]] std::optional<Length> expectedTipError() const;
    /// The tracker's name for a tool with this role; empty if it has none.
    [[nodiscard]] std::string nameOf(ToolRole role) const;
    /// Whether the tracker has such a tool, seen or not.
    [[nodiscard]] bool has(ToolRole role) const;

    /// Changes the use from now on, and discards what was collected.
    void watchFor(StylusUse use);
    /// Starts the present use again.
    void restart() { watchFor(m_use); }
    [[nodiscard]] StylusUse use() const { return m_use; }

    /// Sets the tip in the stylus frame S, metres; without it Spin, Touch and Swab give no result.
    void setTip(const std::optional<Vec3>& p_SQ) { m_p_SQ = p_SQ; }

    /// What the tip touches moves with this tool: touches are given in the frame of its markers;
    /// while it is not seen there are none. std::nullopt: touches are given in T.
    void touchOn(const std::optional<ToolRole>& tool) { m_touched = tool; }

    [[nodiscard]] StylusNews look();

    [[nodiscard]] const PivotProgress& pivot() const { return m_pivot.progress(); }
    /// Progress of the present use, 0 to 1; always 0 for a swab (points taken while the tip slides
    /// over a surface), which has no fixed end.
    [[nodiscard]] double progress() const;
    /// The points p_TQ of the swab so far, each at least kSwabStep from the one before.
    [[nodiscard]] const std::vector<Vec3>& swab() const { return m_swab; }

    /// Takes the point at the tip now: the mean over the last 250 ms. Resting there afterwards does
    /// not take it again. std::nullopt if the stylus is not seen or its tip is unknown.
    std::optional<StylusTouch> takePoint();
    /// Whether the tip is still where the last point was taken.
    [[nodiscard]] bool restsWhereTaken() const;

    /// X_TS now; std::nullopt while the stylus is not seen.
    [[nodiscard]] std::optional<RigidTransform> stylus() const;

    /// X_T<probe>, the mean over the last second; std::nullopt while the probe is not seen.
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
    [[nodiscard]] std::optional<Length> tipErrorDuring(const DwellPoint& point) const;
    /// A sample of the stylus as seen from the touched tool.
    [[nodiscard]] PoseSample onTouched(const PoseSample& X_TS) const;
    /// The samples of a tool; empty if it has delivered none lately.
    [[nodiscard]] std::vector<PoseSample> seen(ToolRole role) const;
    /// The samples of the last `time` that are not lost.
    [[nodiscard]] std::vector<PoseSample> latest(ToolRole role, Duration time) const;

    std::vector<TrackedTool> m_tools;
    ReadSessionClock m_clock;
    std::optional<SessionTime> m_looked; ///< samples up to this time were processed
    StylusUse m_use = StylusUse::Nothing;
    std::optional<Vec3> m_p_SQ;
    std::optional<ToolRole> m_touched;
    PivotCollector m_pivot;
    std::vector<RigidTransform> m_spun; ///< X_TS
    DwellDetector m_dwell;
    bool m_leavesFirst = true;        ///< the tip was not seen yet since watchFor()
    std::optional<Vec3> m_p_TQ_taken; ///< the last point since watchFor()
    std::vector<Vec3> m_swab;
};

} // namespace carina
