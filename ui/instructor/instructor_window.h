#pragma once

#include "models/airway/airway_event_model.h"
#include "models/airway/head_position_model.h"
#include "models/attention/attention_model.h"
#include "models/console/kept_console.h"
#include "models/intubation/intubation_timeline.h"
#include "models/lesson/lesson_model.h"
#include "models/network/network_model.h"
#include "models/objects/object_action_model.h"
#include "models/patient/session_patient.h"
#include "models/physiology/gas_model.h"
#include "models/respiration/breath_trace.h"
#include "models/respiration/breathing_model.h"
#include "models/respiration/respiration_model.h"
#include "models/scoring/try_watch.h"
#include "models/session/change_history.h"
#include "models/session/conduct_model.h"
#include "models/session/participants_model.h"
#include "models/session/people_model.h"
#include "models/session/session_model.h"
#include "models/session/session_plan.h"
#include "models/station/stations_model.h"
#include "models/vitals/sound_output.h"
#include "models/vitals/vitals_model.h"
#include "ui/lesson/scene_teacher.h"
#include "ui/scene/part_chooser.h"
#include "ui/scene/station_scene.h"
#include "ui/tracker/program_tracker_panel.h"

#include <QMainWindow>

#include <functional>
#include <memory>

namespace Ui
{
class InstructorWindow;
}

namespace carina
{

class PanelDocks;
class ProjectorWindow;
class SessionControl;
class StatusLine;
class UndoButton;

/// What a console shows and works on.
struct ConsoleModels {
    SessionModel& session;
    BreathingModel& breathing;
    RespirationModel& respiration;
    GasModel& gas;
    AirwayEventModel& airway;
    HeadPositionModel& head;
    BreathTrace& trace;
    TryWatch& tries;
    ParticipantsModel& participants;
    ConductModel& conduct;
    PeopleModel& people;
    NetworkModel& network;
    ObjectActionModel& actions;
    StationsModel& stations;
    LessonModel& lesson;
    SessionPatient& patient;
    AttentionModel& attention;
    IntubationTimeline& intubation;
    VitalsModel& vitals;
    const SoundOutput& sound;
};

/// The instructor's console: session control, what needs attention, and a 3-D view of the patient
/// of the station that is shown, which has most of the window; beside it panels with the patient's
/// breathing, disease, gas, drugs and airway, waveforms, the view of the laryngoscope, the
/// last try, shared objects, participants and network, and the tools of the console's own tracker.
class InstructorWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// @pre all outlive the window.
    InstructorWindow(const ConsoleModels& models, KeptConsole& kept, StationView& view,
                     const ProgramTracker& tracker);
    ~InstructorWindow() override;

    /// Draws another patient from now on. @pre both outlive the window, or live until the next
    /// show.
    void show(const PatientModel& patient, StationView& view);
    using QMainWindow::show;

    [[nodiscard]] StationScene& stationScene();
    /// What was read of the glottis last, while the view of the laryngoscope is open.
    [[nodiscard]] std::optional<GlotticView> glottisSeen() const;

    /// Who can come into the session, as the invitation tells it.
    void setReach(SessionReach reach);
    /// Asked before the window is closed; while it says no, the window stays.
    void onClose(std::function<bool()> mayClose) { m_mayClose = std::move(mayClose); }

protected:
    void closeEvent(QCloseEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

Q_SIGNALS:
    /// A person wants to connect a tracker, or another one.
    void trackerWanted();
    /// A person wants to go on without the tracker.
    void trackerUnwanted();

private:
    void fillPanels(const ProgramTracker& tracker);
    void layPanels();
    void offerPanels();
    void offerWindows();
    void layFirst();
    void keepPanels();
    void fillSessionBar();
    void addKeys(const UndoButton& undo);
    void connectParts();
    void listParts();
    void followPicture();
    void addMuteButton();
    void addMenuButton();
    void toggleFullScreen();
    void showProjector(bool shown);
    void showPlaceOf(const Attention& attention);
    void showAgain(StationId station);
    void refreshInvitation();
    void refresh();
    void refreshStatus();
    [[nodiscard]] QString trackedText() const;
    [[nodiscard]] QStringList unusual(const StationMoment& moment) const;

    ChangeHistory m_history;
    std::unique_ptr<Ui::InstructorWindow> m_ui;
    ConsoleModels m_models;
    KeptConsole& m_kept;
    SavedViews m_savedViews;
    std::unique_ptr<PanelDocks> m_docks;
    std::unique_ptr<SessionControl> m_control;
    StatusLine* m_status;
    ProgramTrackerPanel* m_tools = nullptr; ///< of the console's own tracker
    QAction* m_projectorShown = nullptr;
    std::unique_ptr<ProjectorWindow> m_projector;
    SessionPhase m_shownPhase = SessionPhase::Prepared;
    bool m_isLaidOut = false;
    std::function<bool()> m_mayClose;
    std::unique_ptr<SceneTeacher> m_teacher;
    std::unique_ptr<PartChooser> m_chooser;
    StationId m_drawn = kNoStation; ///< the station that the picture is of
    QString m_part;                 ///< that was chosen in the picture
    SessionReach m_reach = SessionReach::ThisComputer;
    JoinCodes m_shownCodes;
    bool m_shownLocked = false;
};

} // namespace carina
