#pragma once

#include "models/lesson/lesson_model.h"
#include "models/network/network_model.h"
#include "models/objects/object_action_model.h"
#include "models/patient/session_patient.h"
#include "models/respiration/breath_trace.h"
#include "models/respiration/breathing_model.h"
#include "models/respiration/respiration_model.h"
#include "models/session/change_history.h"
#include "models/session/conduct_model.h"
#include "models/session/participants_model.h"
#include "models/session/people_model.h"
#include "models/session/session_model.h"
#include "models/station/stations_model.h"
#include "ui/lesson/scene_teacher.h"
#include "ui/scene/part_chooser.h"
#include "ui/scene/station_scene.h"

#include <QLabel>
#include <QMainWindow>

#include <functional>
#include <memory>

namespace Ui
{
class InstructorWindow;
}

namespace carina
{

/// The instructor's console: session control, and for the station that is shown breathing and
/// disease of the patient, respiratory waveforms, actions on shared objects, and a 3-D view of the
/// patient; besides, stations, participants and network.
class InstructorWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// @pre all outlive the window.
    InstructorWindow(SessionModel& session, BreathingModel& breathing,
                     RespirationModel& respiration, BreathTrace& trace,
                     ParticipantsModel& participants, ConductModel& conduct, PeopleModel& people,
                     NetworkModel& network, ObjectActionModel& actions, StationsModel& stations,
                     LessonModel& lesson, SessionPatient& patient, StationView& view);
    ~InstructorWindow() override;

    /// Draws another patient from now on. @pre both outlive the window, or live until the next
    /// show.
    void show(const PatientModel& patient, StationView& view);
    using QMainWindow::show;

    [[nodiscard]] StationScene& stationScene();

    /// Asked before the window is closed; while it says no, the window stays.
    void onClose(std::function<bool()> mayClose) { m_mayClose = std::move(mayClose); }

protected:
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fillSessionBar();
    void layDocks();
    void connectParts();
    /// Shows the invitation beneath the waveforms where there is room.
    void useHeight();
    void refreshInvitation();
    void endOnSecondPress();
    void refresh();
    void refreshStatus();

    ChangeHistory m_history;
    std::unique_ptr<Ui::InstructorWindow> m_ui;
    SessionModel& m_session;
    ParticipantsModel& m_participants;
    const SessionPatient& m_patient;
    SharedObjectModel& m_objects;
    QLabel* m_phase;
    QLabel* m_status;
    SessionPhase m_shownPhase = SessionPhase::Prepared;
    bool m_isLaidOut = false;
    bool m_endAsked = false;
    std::function<bool()> m_mayClose;
    std::unique_ptr<SceneTeacher> m_teacher;
    std::unique_ptr<PartChooser> m_chooser;
    JoinCodes m_shownCodes;
    bool m_shownLocked = false;
};

} // namespace carina
