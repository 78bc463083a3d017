#pragma once

#include "models/objects/object_action_model.h"
#include "models/patient/session_patient.h"
#include "models/scoring/try_watch.h"
#include "models/session/people_model.h"
#include "models/station/chin_probe_model.h"
#include "ui/lesson/lesson_follower.h"
#include "ui/scene/part_chooser.h"
#include "ui/scene/station_scene.h"
#include "ui/tracker/program_tracker_panel.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>

#include <array>
#include <vector>

class QPushButton;

namespace carina
{

class BedsideMonitorPanel;
class HandsModel;
class HandsPanel;
class LaryngoscopePanel;
class PartsPanel;
class SectionPanel;
class SoundOutput;
class VitalsModel;

/// The trainee's window: only the anatomy on black, on a screen or in a headset. Notices appear
/// over the lower edge, once per eye if each has its own picture, and disappear automatically; the
/// picture does not move. Esc opens a menu, from which panels for the actions on shared objects,
/// the parts of the patient, the tools of the tracker, the view of the laryngoscope, the bedside
/// monitor, what hands do with cuff, stylet and bag, and the debriefing of the last try open:
/// beside the picture on a screen, in a separate window with a headset. The debriefing opens by
/// itself when a try has ended, and leaves the keyboard where it is. While no headset is tracked,
/// mouse and keys turn the head that its picture is seen from.
class TraineeWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// How far the registration of this program's manikin can be relied on; std::nullopt for a
    /// program without a tracker.
    using Standing = std::function<std::optional<RegistrationStanding>()>;

    /// @pre all outlive the window.
    TraineeWindow(const SessionNode& node, SessionPatient& patient, const StationView& view,
                  const HeadsetView& headset, ViewOutput output, ChinProbeModel chinProbe,
                  ObjectActionModel& actions, PeopleModel& people, TryWatch& tries,
                  Standing standing, const ProgramTracker& tracker);

    /// Draws another patient from now on.
    /// @param chinProbe of the patient's tracking
    /// @pre all outlive the window, or live until the next show().
    void show(const PatientModel& patient, const StationView& view, ChinProbeModel chinProbe);
    using QMainWindow::show;

    /// The patient's bedside monitor, in a panel of its own. @pre both outlive the window
    void setMonitor(VitalsModel& vitals, const SoundOutput& sound);
    /// Cuff, stylet and bag, in a panel, in the menu and by key. @pre it outlives the window
    void setHands(HandsModel& hands);

    [[nodiscard]] StationScene& stationScene() { return m_stationScene; }
    /// What was read of the glottis last, while the view of the laryngoscope is open.
    [[nodiscard]] std::optional<GlotticView> glottisSeen() const;
    /// What is written over the lower edge; empty where nothing is.
    [[nodiscard]] QString notice() const;

protected:
    void resizeEvent(QResizeEvent* event) override;
    /// Passes by what lies outside of the window, as the tabs of panels that are shut do.
    bool focusNextPrevChild(bool next) override;

Q_SIGNALS:
    /// A person wants to connect a tracker, or another one.
    void trackerWanted();
    /// A person wants to go on without the tracker.
    void trackerUnwanted();
    /// A person wants to leave this session, which is over or whose host is silent, for another.
    void anotherWanted();

private:
    void makeActions(ObjectActionModel& actions);
    void makeParts();
    void makeTracker(const ProgramTracker& tracker);
    void makeLaryngoscope(TryWatch& tries);
    void makeDebriefing(TryWatch& tries);
    void makeMonitor();
    void makeHands();
    void addPanel(QDockWidget* dock, QWidget* panel, const char* name, const QString& menuText);
    void makeMenu();
    /// Says at which station this is, where there are several.
    void addStation();
    void addOutputs();
    void addPresets();
    void addPeople();
    void addHands();
    void addMotion();
    /// The choices of what the chin probe moves; shown while there is a choice.
    [[nodiscard]] std::vector<QAction*> addChinProbe();
    void addFetching();
    void addAnother();
    void placeAnother();
    [[nodiscard]] QPoint menuPlace() const;
    void showTo(ViewOutput output);
    void refreshNotice();
    /// Once the host removed this program, takes away what would have no effect.
    void withdrawOffers();
    /// While an instructor shows something, takes away what would not be seen.
    void refreshLesson();
    void placeNotice(std::size_t place, const QString& notice, const QRect& within);

    const SessionNode& m_node;
    SessionPatient& m_patient;
    SceneView* m_scene;
    QDockWidget* m_actions;
    QDockWidget* m_parts;
    QDockWidget* m_tracker;
    QDockWidget* m_laryngoscope;
    LaryngoscopePanel* m_scope = nullptr;
    QDockWidget* m_debriefing;
    QDockWidget* m_monitor;
    BedsideMonitorPanel* m_monitorPanel;
    QDockWidget* m_hands;
    HandsPanel* m_handsPanel;
    PartsPanel* m_partsPanel;
    SectionPanel* m_section;
    std::array<QLabel*, 2> m_notices; ///< for the whole window or its left half; for its right half
    QPushButton* m_another;           ///< above the notice, while another is offered
    HeadsetView m_headset;
    PeopleModel& m_people;
    SharedObjectModel& m_objects;
    ChinProbeModel m_chinProbe;
    Standing m_standing;
    StationScene m_stationScene;
    LessonFollower m_lesson;
    PartChooser m_chooser;
    QMenu m_menu;
    std::vector<QAction*> m_presets; ///< of the screen's camera, and through the eyes of others
};

} // namespace carina
