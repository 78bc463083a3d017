#pragma once

#include "engine/core/units.h"
#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/motion_filter.h"
#include "engine/tracking/tracker.h"
#include "engine/tracking/working_volume.h"

#include <deque>
#include <random>

namespace carina
{

/// Where a tool truly is: X_T<tool>; nothing while something hides it. Called on the tracker's
/// thread.
using TrueToolPose = std::function<std::optional<RigidTransform>(ToolRole, SessionTime)>;

/// A tool hidden by script, from `from` on and before `until`.
struct Occlusion {
    ToolRole tool = ToolRole::Other;
    SessionTime from;
    SessionTime until;
};

/// How well the simulated device measures.
struct SimulatedTrackerSettings {
    Frequency rate = hertz(60.0); ///< the device with three probes reaches 30 Hz
    /// Three-dimensional RMS of the position noise, equal everywhere in the volume.
    Length positionNoise = millimetres(0.35);
    /// Standard deviation along the line of sight from the origin of T to the tool, over that
    /// across it in either direction.
    double depthRatio = 3.0;
    Angle rotationNoise = degrees(0.05);              ///< RMS angle, about an axis of any direction
    Duration latency = std::chrono::milliseconds{14}; ///< from exposure to delivery
    WorkingVolume volume;                             ///< a tool's origin outside it is lost
    std::vector<Occlusion> occlusions;
    bool chestMarker = false; ///< there is one on the manikin's chest, too
    bool bodyProbe = false;   ///< and a probe on its torso
    std::uint32_t seed = 1;
};

/// A tracker for a station without hardware: measures given true poses of a head, a jaw, a tube and
/// a stylus, and of a chest and a torso where they have a probe, with noise, occlusion and loss, on
/// a thread of its own.
///
/// Every sample is stamped with the time of its exposure and delivered a latency later, with the
/// velocity that a MotionFilter finds. The fit
/// error is drawn apart from the pose's error, as the two are independent: its RMS is
/// sqrt(1 - 2/N) of the position noise (Fitzpatrick 1998) for tools of N = 4 markers. A lost sample
/// carries the last pose measured; a tool never yet seen has no samples.
class SimulatedTracker : public Tracker
{
public:
    /// @pre the rate is above zero.
    SimulatedTracker(SimulatedTrackerSettings settings, TrueToolPose truth, ReadSessionClock clock);

    [[nodiscard]] Result<void> start() override { return m_thread.start(); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tools; }

    /// What the thread does: exposes at each tick up to `now` and delivers what has travelled for
    /// the latency. Ticks are whole periods from the first call on; when a call comes more than a
    /// second late or early, they begin anew at its time.
    /// @returns the time at which the next thing is due, later than `now`.
    /// @pre the thread does not run.
    SessionTime advance(SessionTime now);

private:
    struct Probe {
        ToolRole role = ToolRole::Other;
        std::optional<RigidTransform> lastX_TO;
        MotionFilter filter;
        PoseHistory history;
    };
    struct Measurement {
        Probe* probe = nullptr;
        PoseSample sample;
    };

    [[nodiscard]] SessionTime nextTick() const;
    [[nodiscard]] bool hidden(ToolRole role, SessionTime t) const;
    [[nodiscard]] Vec3 noiseAlong(const Vec3& sight_T);
    [[nodiscard]] RigidTransform measured(const RigidTransform& X_TO);
    void expose(Probe& probe, SessionTime t);

    SimulatedTrackerSettings m_settings;
    TrueToolPose m_truth;
    std::mt19937 m_random;
    std::normal_distribution<double> m_normal;
    std::deque<Probe> m_probes;         // which stay where they are
    std::vector<TrackedTool> m_tools;   // one for each probe
    std::deque<Measurement> m_underway; // ascending in time
    std::optional<SessionTime> m_firstTick;
    std::int64_t m_ticks = 0; // exposed since the first
    DeliveryThread m_thread;  // last: ends before what it uses
};

} // namespace carina
