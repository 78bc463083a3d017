#pragma once

#include "engine/core/units.h"
#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/markers/marker_pose.h"
#include "engine/tracking/tracker.h"
#include "engine/tracking/working_volume.h"

#include <deque>
#include <map>
#include <random>
#include <string>

namespace carina
{

/// The true pose X_T<tool> of a tool at a time; nothing while it is hidden. Called on the tracker's
/// thread.
using TrueToolPose = std::function<std::optional<RigidTransform>(ToolRole, SessionTime)>;

/// A scripted occlusion of a tool, from `from` (included) to `until` (excluded), and where `every`
/// is not zero again and again, each so much later than the one before.
struct Occlusion {
    ToolRole tool = ToolRole::Other;
    SessionTime from;
    SessionTime until;
    double share = 1.0; ///< of its markers, the first ones, that are hidden
    Duration every{};
};

/// The probe of a simulated tool: on a ball, so that the tracker sees a good half of its markers
/// from everywhere. That of the head has 20 markers on a ball of 100 mm, the others 12 on one of
/// 45 mm; each role has another arrangement.
[[nodiscard]] Probe simulatedProbe(ToolRole role);

/// Its name of the stylus.
inline constexpr const char* kSimulatedStylus = "stylus";

/// Accuracy and timing of the simulated device.
struct SimulatedTrackerSettings {
    Frequency rate = hertz(60.0); ///< the device with three probes reaches 30 Hz
    /// Of one marker, at each exposure anew. 0.35 mm, which the device states, is its accuracy
    /// anywhere in the volume; at one place it repeats itself better.
    MarkerNoise noise{millimetres(0.1), 3.0};
    Duration latency = std::chrono::milliseconds{14}; ///< from exposure to delivery
    WorkingVolume volume;                             ///< a tool's origin outside it is lost
    std::vector<Occlusion> occlusions;
    double dropouts = 0.0;     ///< share of the exposures that are not delivered
    bool chestMarker = false;  ///< also simulate a marker on the manikin's chest
    bool bodyProbe = false;    ///< also simulate a probe on its torso
    bool handProbe = false;    ///< also simulate a probe on the hand that holds the tube
    bool laryngoscope = false; ///< also simulate a laryngoscope
    std::string laryngoscopeName = "laryngoscope"; ///< which may tell its blade
    std::uint32_t seed = 1;
    std::map<ToolRole, Probe> probes{}; ///< of tools that have another one than simulatedProbe()
};

/// A tracker for a station without hardware. On its own thread it measures the markers of given
/// true poses of head, jaw, tube and stylus, and of chest marker, body and hand probe if there are.
///
/// Of each probe it sees the markers that face it and are not hidden, each with noise, and computes
/// the pose from them as a device does: of a tool that it did not see before, it finds out which
/// marker is which (searchMarkers), and then knows them (markerPose). The fit error is the RMS of
/// what the fit leaves, and the sample tells the markers of the fit. With fewer markers than the
/// probe needs, or its origin outside the volume, the tool is lost; with less than two thirds of
/// those that face the tracker it is partly occluded.
///
/// Every sample has the time of its exposure and is delivered `latency` later, with the motion that
/// its history estimates. A lost sample holds the last pose measured; a tool not seen yet has no
/// samples.
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
    struct Tool {
        ToolRole role = ToolRole::Other;
        Probe probe;
        std::optional<RigidTransform> lastX_TO;
        bool isSeen = false; ///< at the last exposure
        PoseHistory history{PoseHistory::Limits{.estimates = true}};
    };
    struct Measurement {
        Tool* tool = nullptr;
        PoseSample sample;
    };

    [[nodiscard]] SessionTime nextTick() const;
    [[nodiscard]] bool isDropped();
    [[nodiscard]] double hiddenShare(ToolRole role, SessionTime t) const;
    [[nodiscard]] Vec3 noiseAlong(const Vec3& sight_T);
    [[nodiscard]] std::optional<PoseSample> measured(Tool& tool, const RigidTransform& X_TO,
                                                     SessionTime t);
    void expose(Tool& tool, SessionTime t);

    SimulatedTrackerSettings m_settings;
    TrueToolPose m_truth;
    std::mt19937 m_random;
    std::mt19937 m_drops; ///< apart: without dropouts the noise is the same
    std::normal_distribution<double> m_normal;
    std::deque<Tool> m_tracked;         // a deque: their addresses do not change
    std::vector<TrackedTool> m_tools;   // one for each of them
    std::deque<Measurement> m_underway; // ascending in time
    std::optional<SessionTime> m_firstTick;
    std::int64_t m_ticks = 0; // measured since the first
    DeliveryThread m_thread;  // last: ends before what it uses
};

} // namespace carina
