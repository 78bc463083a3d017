#pragma once

#include "engine/anatomy/laryngoscopy/blade_levering.h"
#include "engine/scoring/course/try_course.h"
#include "engine/session/respiration/respiration_follower.h"
#include "models/scoring/try_report.h"
#include "models/session/session_model.h"
#include "models/station/people_poses.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace carina
{

/// Watches the tries at intubating the patient of one station, and reports the last one.
///
/// What a monitor notes are facts, from which a program that comes later finds the try under way,
/// and the last one that ended. What else is measured it has only of tries that began since: the
/// oxygen, the forces, and the ways of hand and head. The poses of the
/// laryngoscope and the head of who is at work are sampled every kPoseEvery of session time,
/// kPoseDelay late, so that they are measured ones and not predicted. Mask ventilation counts where
/// a bag or ventilator blew through a mask within kMaskBefore before the try; whether the manikin
/// was ventilated, nobody measures. While an instructor says where the tube in the mouth is, that
/// counts and not what is noted. Forces are the estimates of whoever draws the blade in the
/// patient, while somebody does. Up is to the front of the patient, who lies supine.
class TryWatch : public QObject
{
    Q_OBJECT

public:
    static constexpr Duration kPoseEvery = std::chrono::milliseconds{16};
    static constexpr Duration kPoseDelay = std::chrono::milliseconds{250};
    static constexpr Duration kMaskBefore = std::chrono::minutes{3}; ///< of ours
    static constexpr Duration kVitalsEvery = std::chrono::milliseconds{200};
    /// After a longer gap the missing poses are skipped.
    static constexpr Duration kLongestGap = std::chrono::seconds{2};

    /// @param own poses of this program's objects
    /// @pre session outlives this.
    TryWatch(SessionModel& session, StationId station, ObjectPoses own = {},
             QObject* parent = nullptr);

    /// Watches another station from now on, and the report of its last try.
    void setStation(StationId station);
    /// Where the effort of a blade in the patient's mouth is estimated; nothing while none is.
    using EffortSource = std::function<std::optional<BladeEffort>()>;
    void setEffort(EffortSource effort) { m_effort = std::move(effort); }
    /// The rule for the depth; nothing: the usual one for the patient.
    void setRule(std::optional<DepthRule> rule) { m_rule = rule; }
    void setRubric(Rubric rubric) { m_rubric = std::move(rubric); }

    [[nodiscard]] bool isUnderWay() const { return m_course.hasBegun(); }
    /// Of the try under way; 0 without one.
    [[nodiscard]] Duration time() const;
    /// Of the last try that ended; nothing before it, and while another one is under way.
    [[nodiscard]] const std::optional<TryReport>& report() const { return m_report; }
    /// Whether a person here may end the try under way: an instructor, or who is at work. Not where
    /// somebody has just done so.
    [[nodiscard]] bool mayFinish() const;
    /// Ends the try under way at every program.
    void finish();

    /// Takes what happened; a timer calls it.
    void watch();

Q_SIGNALS:
    /// A try began, or its report is there or gone.
    void changed();
    /// A try ended while this program watched, and its report is there.
    void ended();

private:
    void takeFacts(const SessionState& state, const Station& station);
    void tell(std::optional<TubeSeat> seat, SessionTime since);
    [[nodiscard]] bool takeLate(const IntubationEvent& event);
    void take(const SessionState& state, const IntubationEvent& event);
    void takeVitals(const Station& station, SessionTime until);
    void takeCuff(const SessionState& state, SessionTime now);
    void takeForces(SessionTime now);
    void lookAtMask(const Station& station, SessionTime now);
    void takePoses(const SessionState& state, SessionTime now);
    [[nodiscard]] std::optional<SessionTime> endedByPerson(const SessionState& state) const;
    void endBy(const SessionState& state, SessionTime t);
    void begin(const Station& station, SessionTime now);
    void end(const Station& station, SessionTime at);
    void judge();
    [[nodiscard]] const Station* stationIn(const SessionState& state) const;

    SessionModel& m_session;
    StationId m_station;
    ObjectPoses m_own;
    EffortSource m_effort = [] { return std::nullopt; };
    std::optional<DepthRule> m_rule;
    Rubric m_rubric = publishedRubric();
    std::optional<TryReport> m_report;

    /// The try that ended last, while its tube lies where it ended: an instructor may say where
    /// that is.
    struct Judged {
        TryCourse course;
        SessionTime ended;
        TubedPatient patient;
    };
    std::optional<Judged> m_judged;
    TryCourse m_course;
    std::optional<TubeSeat> m_told;               ///< where the tube is by the console, last,
    SessionTime m_toldUntil = SessionTime::min(); ///< and when that took effect
    RespirationFollower m_patient;
    std::uint64_t m_lastNote = 0; ///< number of the last one that was taken
    /// Of a try that began before, only what facts tell is told.
    std::optional<SessionTime> m_watchedSince;
    IntubationEvent m_latest; ///< where the tube lies, as sure as that is
    bool m_isTubeOut = false; ///< of the mouth again
    bool m_isCuffInflated = false;
    std::optional<SessionTime> m_maskVentilated; ///< seen last
    SessionTime m_begun{};
    SessionTime m_vitalsAt{}; ///< next
    std::optional<SessionTime> m_posesAt;
};

} // namespace carina
