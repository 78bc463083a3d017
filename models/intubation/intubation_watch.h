#pragma once

#include "engine/airway/monitor/rest_watch.h"
#include "engine/anatomy/laryngoscopy/glottic_view.h"
#include "engine/geometry/deformation/airway_field.h"
#include "engine/session/respiration/respiration_follower.h"
#include "engine/session/respiration/tube_breath_watch.h"
#include "models/intubation/tube_in_airway.h"
#include "models/intubation/ways_in_patient.h"
#include "models/patient/patient_lumen.h"
#include "models/station/laryngoscope_sight.h"
#include "models/station/station_view.h"

#include <QObject>
#include <QTimer>

#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace carina
{

/// Follows the intubation at a station from the poses of tube and laryngoscope, while this
/// program's participant is at work there and the session runs, and notes its steps in the session
/// (fact::IntubationNoted), with the inner diameter of the tube: that of the site where it is
/// calibrated, else the patient's usual one (PatientModel::tube).
///
/// It takes up what the session has noted of the tube and the blade that are there: who works after
/// somebody else has tools of their own, and those of the other are noted to be out once the own
/// ones are seen outside.
///
/// Time does not run for it while the session is paused, and what happens meanwhile is not seen. It
/// expects poses to be as far off as the registration's standing says, but no less than usual. It
/// does not know where the tip is of a tube that bends nobody knows how, whose curve at rest was
/// not touched or that is in no measured lumen, nor where the registration is missing, stale or
/// not good; of a simulated manikin all of that is known.
///
/// Moments are kEach apart, at whole multiples of it in session time, and kReadBehind in the past.
/// Patient, neck, jaw and tissue are as they are drawn then.
///
/// The tube is followed, also while the session does not run, as an elastic rod in the patient's
/// lumen (ElasticTube), from when that was measured: from the first moment at which somebody is at
/// work. Before it, it is as its pose has it. How it bends is sent with its poses
/// (SessionNode::publishShape).
///
/// What no sensor feels follows from what people set, cuff and stylet, and from the mechanics: the
/// first breath that bag or ventilator deliver with the tip past the cords, in the trachea or the
/// oesophagus (TubeBreathWatch).
///
/// Steps are proposed one after another, the next once the session has answered: one that it does
/// not take because it came too late, as after a host was away, is proposed again, and so are those
/// behind it, dated as far back as the session lets them be, and less far each time, for a slow
/// path. One that came too late kMostProposals times is lost, and one that is not taken for another
/// reason, as of who is muted. Of more than kMostQueued that wait, the oldest are lost: where the
/// tube is now matters more than how it came there, and their times are lost by then in any case.
class IntubationWatch : public QObject
{
    Q_OBJECT

public:
    static constexpr Duration kEach = std::chrono::milliseconds{20};
    /// From one form of the tube that is sent to the next, at least: of ours.
    static constexpr Duration kShapeEach = std::chrono::milliseconds{40};
    static constexpr int kMostProposals = 3;       ///< of one step; of ours
    static constexpr std::size_t kMostQueued = 64; ///< of ours

    /// What was read of the glottis in the laryngoscope's picture last; nothing where none was.
    using ReadView = std::function<std::optional<GlotticView>()>;

    /// @param own poses of this program's objects
    /// @pre node and what `own` reads outlive this.
    IntubationWatch(SessionNode& node, StationId station, ObjectPoses own,
                    QObject* parent = nullptr);

    /// Follows another station, or the same with another patient, from now on, as who takes up the
    /// work there.
    void setStation(StationId station);
    /// @pre it outlives this, or lives until the next one lies there.
    void lieIn(const PatientModel& patient);
    /// The blade of this program's laryngoscope, as it was touched; std::nullopt: as its name says.
    /// @pre a patient lies there
    void takeOwnBlade(const std::optional<Blade>& blade) { m_laryngoscope->takeOwnBlade(blade); }
    void readView(ReadView view) { m_view = std::move(view); }
    /// Of the registration; nothing: all is simulated.
    using ReadStanding = std::function<std::optional<RegistrationStanding>()>;
    void readStanding(ReadStanding standing) { m_standing = std::move(standing); }

    /// Takes the moments that are due; a timer calls it every kEach.
    void look();

    /// Its times are those for which the session has run (SessionState::runningTime).
    [[nodiscard]] const IntubationCourse& course() const { return m_monitor.course(); }

    /// How the tube of this program's participant is drawn in the airway at a moment; AsMeasured
    /// where it is not theirs, or is not seen.
    /// @param tissue as it is drawn then
    [[nodiscard]] TubeInAirway tubeAt(const StationMoment& moment,
                                      const TissueAround& tissue) const;

Q_SIGNALS:
    /// The lumen for the tube that lies there was measured, or cannot be.
    void lumenMeasured();

private:
    /// As people have set them.
    struct Controls {
        bool isCuffInflated = false;
        bool isStyletIn = true;
    };
    /// A step as it was proposed.
    struct Sent {
        IntubationEvent event;
        std::optional<SessionTime> answered{}; ///< when its answer was found
    };

    static constexpr Duration kUsualWay = std::chrono::seconds{1}; ///< of ours

    /// What lies around a tube at a moment.
    struct Surroundings {
        StationMoment moment;
        FollowingThroat throat;
        AirwayField changes;
        LaryngoscopeSight sight;

        /// @pre this outlives it
        [[nodiscard]] TissueAround tissue() const
        {
            return tissueAround(changes, throat, sight.tissue);
        }
    };
    /// What the node's thread reads the shape from.
    using ShapeBoard = std::atomic<std::shared_ptr<const StreamShape>>;

    void forget();
    void takeUp(SessionTime now);
    void expectPoses();
    [[nodiscard]] IntubationEvent onClock(IntubationEvent event) const;
    [[nodiscard]] bool knowsTip() const;
    [[nodiscard]] bool isAtWork() const;
    void findLumen();
    void takeMoments(SessionTime now, bool isRunning);
    [[nodiscard]] StationMoment momentAt(SessionTime t);
    [[nodiscard]] Surroundings surroundingsAt(SessionTime t);
    [[nodiscard]] AirwayMoment airwayAt(SessionTime t);
    [[nodiscard]] bool tellsWhereItLies() const;
    [[nodiscard]] bool isShut(const StationMoment& moment) const;
    void followTube(const StationMoment& moment, const TissueAround& tissue);
    /// Of the own tube, where it is seen.
    [[nodiscard]] ElasticTube::ConnectorAt connectorAt() const;
    void shareShape();
    [[nodiscard]] std::shared_ptr<const StreamShape> shapeAt(SessionTime t);
    [[nodiscard]] BladeSeen bladeIn(const StationMoment& moment, const LaryngoscopeSight& sight);
    [[nodiscard]] Controls controlsAt(SessionTime t) const;
    void takeControls(SessionTime now);
    [[nodiscard]] bool isTakenBack(IntubationStep step);
    void takeBreath(SessionTime t);
    void queue(const IntubationEvent& event);
    [[nodiscard]] bool isTaken(const IntubationEvent& event) const;
    void takeAnswer(SessionTime now);
    void settle(const Sent& sent, bool wasTaken);
    void propose(SessionTime now);

    SessionNode& m_node;
    StationId m_station;
    ObjectPoses m_own;
    ReadView m_view = [] { return std::nullopt; };
    ReadStanding m_standing = [] { return std::nullopt; };
    std::optional<PatientWays> m_ways; ///< of the patient, once they are needed
    const PatientModel* m_patient = nullptr;
    PatientLumen m_lumen;
    std::optional<ElasticTube> m_tube; ///< once its lumen is there
    /// Shared with the source that the node has, which may outlive this.
    std::shared_ptr<ShapeBoard> m_shape = std::make_shared<ShapeBoard>();
    std::optional<StationLaryngoscope> m_laryngoscope;
    IntubationMonitor m_monitor;
    bool m_isTakenUp = false; ///< the work, and in the monitor what was noted before
    RestWatch m_rest;
    std::optional<SessionTime> m_taken; ///< the latest moment
    std::optional<Controls> m_controls; ///< at the latest look
    RespirationFollower m_breathing;
    TubeBreathWatch m_breaths;
    std::deque<IntubationEvent> m_queued;          ///< in the order in which they were concluded
    std::optional<Sent> m_sent;                    ///< the first of them
    int m_late = 0;                                ///< how often the first of them came too late
    Duration m_way = kUsualWay;                    ///< how long a proposal may be on its way
    std::map<IntubationStep, SessionTime> m_noted; ///< when each step was noted last
    QTimer m_timer;
};

} // namespace carina
