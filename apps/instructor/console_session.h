#pragma once

#include "apps/instructor/intubation_assistant.h"
#include "apps/instructor/session_host.h"
#include "apps/instructor/shown_station.h"
#include "apps/program/journal.h"
#include "apps/program/tracker_change.h"
#include "models/intubation/intubation_watch.h"
#include "models/openigtlink/offer_switch.h"
#include "models/respiration/checkpoint_keeper.h"
#include "models/vitals/sound_output.h"
#include "models/vitals/station_vitals.h"
#include "ui/instructor/instructor_window.h"

#include <functional>

namespace carina
{

/// What a console has of a tracker of its own, whichever session it is in.
struct ConsoleTracker {
    program::TrackerChange change; ///< and the site
    std::optional<TrackerChoice> choice{};
    QString record{}; ///< file that its poses are to be recorded in; empty once that was begun
};

/// One session of the console, from when it is hosted until nobody needs it any more: its models
/// and its window.
class ConsoleSession
{
public:
    /// @param isAskedFor whether the patient is to be laid also where another one lies
    /// @param tracker the one of the session at its end is that of the next one
    /// @pre tracker and parser outlive the session.
    /// @returns the errors of journalFromOptions, readTryOptions, openIgtLinkOption,
    ///          PoseRecording::begin and writing the codes.
    [[nodiscard]] static Result<std::unique_ptr<ConsoleSession>>
    open(HostedSession hosted, const program::ChosenPatient& patient, bool isAskedFor,
         const ConsoleOptions& options, ConsoleTracker& tracker, const QCommandLineParser& parser);
    ~ConsoleSession();

    /// Ends what is recorded, before the session is closed, while a person can look on.
    void finish();

    [[nodiscard]] InstructorWindow& window() { return m_window; }
    [[nodiscard]] SessionNode& node() { return *m_hosted.node; }
    [[nodiscard]] BreathingModel& breathing() { return m_breathing; }
    [[nodiscard]] const QString& file() const { return m_hosted.file; }

    /// Calls back once when the session has ended, for whatever reason; the callback may destroy
    /// the session. One that had ended before it was opened never calls.
    void onEnded(std::function<void()> callback);

    /// Called when a person wants this session closed and the start page in its place.
    void onLeft(std::function<void()> callback) { m_onLeft = std::move(callback); }

private:
    ConsoleSession(HostedSession hosted, const program::ChosenPatient& patient,
                   const QString& folder, ConsoleTracker& tracker);
    void offerTracker();
    void offerStethoscope();
    [[nodiscard]] Result<void> keepCodes(const QString& file);
    void show(const QSize& size);
    [[nodiscard]] Result<void> follow(const QCommandLineParser& parser);
    void setStation(StationId station);
    void comeWithTools();
    void openStations(const std::vector<WantedStation>& wanted);
    [[nodiscard]] bool mayClose();
    [[nodiscard]] bool hasEnded() const;
    void look();

    ConsoleTracker& m_tracker;
    HostedSession m_hosted;
    SharedTools m_tools;
    PoseRecording m_recording;
    SessionModel m_session;
    StationsModel m_stations;
    BreathingModel m_breathing;
    ParticipantsModel m_participants;
    ConductModel m_conduct;
    PeopleModel m_people;
    NetworkModel m_network;
    SharedObjectModel m_object;
    LessonModel m_lesson;
    ObjectActionModel m_actions;
    RespirationModel m_respiration;
    GasModel m_gas;
    AirwayEventModel m_airway;
    HeadPositionModel m_head;
    BreathTrace m_trace;
    TryWatch m_tries;
    AttentionModel m_attention;
    IntubationTimeline m_intubation;
    StationVitals m_vitals;
    SoundOutput m_sound;
    CheckpointKeeper m_checkpoints;
    ShownStation m_shown;
    IntubationWatch m_watch; ///< where who runs this console is at work with its tracker
    OfferSwitch m_offer;
    KeptConsole m_kept;
    InstructorWindow m_window;
    std::unique_ptr<program::Journal> m_journal;
    std::unique_ptr<IntubationAssistant> m_assistant; ///< at one that is played
    std::function<void()> m_onEnded;
    std::function<void()> m_onLeft;
    QTimer m_looking; ///< when an end takes effect, no fact arrives
};

} // namespace carina
