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

/// The true pose X_T<tool> of a tool at a time; nothing while it is hidden. Called on the tracker's
/// thread.
using TrueToolPose = std::function<std::optional<RigidTransform>(ToolRole, SessionTime)>;

/// A scripted occlusion of a tool, from `from` (included) to `until` (excluded).
struct Occlusion {
    ToolRole tool = ToolRole::Other;
    SessionTime from;
    SessionTime until;
};

/// Accuracy and timing of the simulated device.
struct SimulatedTrackerSettings {
    Frequency rate = hertz(60.0); ///< the device with three probes reaches 30 Hz
    /// Three-dimensional RMS of the position noise, equal everywhere in the volume.
    Length positionNoise = millimetres(0.35);
    /// Standard deviation along the line of sight from the origin of T to the tool, divided by that
    /// in each direction across it.
    double depthRatio = 3.0;
    Angle rotationNoise = degrees(0.05);              ///< RMS angle, isotropic axis
    Duration latency = std::chrono::milliseconds{14}; ///< from exposure to delivery
    WorkingVolume volume;                             ///< a tool's origin outside it is lost
    std::vector<Occlusion> occlusions;
    bool chestMarker = false; ///< also simulate a marker on the manikin's chest
    bool bodyProbe = false;   ///< also simulate a probe on its torso
    bool handProbe = false;   ///< also simulate a probe on the hand that holds the tube
    std::uint32_t seed = 1;
};

/// A tracker for a station without hardware. On its own thread it measures given true poses of
/// head, jaw, tube and stylus, and of chest marker, body and hand probe if there are, with noise,
/// occlusion and loss.
///
/// Every sample has the time of its exposure and is delivered `latency` later, with the velocity
/// that a MotionFilter estimates. The fit error is drawn independently of the error of the pose, as
/// the two are independent. For tools of N = 4 markers the noise of one marker is sqrt(N) times
/// that of their mean, the position noise, and a fit leaves sqrt(1 - 2/N) of it (Fitzpatrick, West,
/// Maurer 1998): the RMS of the fit error is sqrt(N - 2) times the position noise. A lost sample
/// holds the last pose measured; a tool not seen yet has no samples.
class SimulatedTracker : public Tracker
{
public:
    /// @pre the rate is above zero.
    SimulatedTracker(SimulatedTrackerSettings settings, TrueToolPose truth, ReadSessionClock clock);

    [[nodiscard]] Result<void> start() override { return m_thread.start(); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tools; }

    /// One step of the thread: measures at each tick up to `now` and delivers the samples whose
    /// latency has passed. Ticks are whole periods after the first call; after a call more than one
    /// second too late or too early they restart at the time of that call.
    /// @returns the time of the next tick or delivery, later than `now`.
    /// @pre the thread is not running.
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
    std::deque<Probe> m_probes;         // a deque: their addresses do not change
    std::vector<TrackedTool> m_tools;   // one for each probe
    std::deque<Measurement> m_underway; // ascending in time
    std::optional<SessionTime> m_firstTick;
    std::int64_t m_ticks = 0; // measured since the first
    DeliveryThread m_thread;  // last: ends before what it uses
};

} // namespace carina
