#pragma once

#include "apps/lab/intubation/watched_airway.h"
#include "engine/airway/monitor/intubation_monitor.h"
#include "engine/airway/monitor/rest_watch.h"
#include "engine/scoring/course/try_course.h"
#include "engine/session/body/tube_timeline.h"
#include "evaluation/intubation/intubation_motion.h"

#include <optional>
#include <utility>
#include <vector>

namespace carina::lab
{

/// Session time at which an intubation begins: late enough for what is done to a patient before.
inline constexpr SessionTime kTrialStart{std::chrono::seconds{300}};

/// What was concluded from the observed poses of an intubation.
struct WatchedIntubation {
    std::vector<MotionCommand> commands; ///< what people did beside it, by time
    std::vector<NotedStep> noted;        ///< in the order in which it was noted
    IntubationCourse course;             ///< in the end
    TryCourse measured{-Vec3::UnitY()};  ///< with blade and forces; the patient lies on the back
    Duration length{};

    [[nodiscard]] SessionTime end() const { return kTrialStart + length; }
    [[nodiscard]] std::vector<IntubationEvent> byTime() const; ///< what was noted
};

/// The monitor of one intubation, and what of it is measured.
class IntubationWatcher
{
public:
    /// @param connectorAt as of WatchedAirway
    /// @param into its commands are what people do beside it
    /// @pre the subject, what connectorAt reads, and `into` outlive this
    IntubationWatcher(const IntubationSubject& subject, const Blade& blade,
                      ElasticTube::ConnectorAt connectorAt, WatchedIntubation& into)
        : m_watched{into}, m_airway{subject, blade, std::move(connectorAt)}
    {
        m_watched.measured.check(TryCheck::MaskVentilated, true); // by patientOf
    }

    /// Of the poses, as IntubationMonitor.
    void expect(const PlacementError& error) { m_monitor.expect(error); }
    /// The next moment, in ascending time.
    void take(const SeenTools& tools);
    /// After the last one.
    void finish();

private:
    void tellUntil(SessionTime t);
    void note(SessionTime now, const IntubationEvent& event);
    void measure(const SeenTools& tools);

    WatchedIntubation& m_watched;
    WatchedAirway m_airway;
    IntubationMonitor m_monitor;
    RestWatch m_rest;
    std::size_t m_told = 0;
};

/// The step that a command tells; nothing for one that is no step.
[[nodiscard]] std::optional<IntubationStep> toldBy(MotionAct act);

} // namespace carina::lab
