#include "ui/instructor/instructor_window.h"

#include "models/objects/object_words.h"
#include "models/station/people_words.h"
#include "ui/instructor/panel_docks.h"
#include "ui/instructor/projector_window.h"
#include "ui/instructor/reading_order.h"
#include "ui/instructor/session_control.h"
#include "ui/instructor/status_line.h"
#include "ui/instructor/view_controls.h"
#include "ui/lesson/lesson_bar.h"
#include "ui/panels/session/undo_button.h"
#include "ui_instructor_window.h"
#include "widgets/scene/view/scene_view.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QPointer>
#include <QShowEvent>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kRefreshInterval_ms = 250;
constexpr int kRefusalShown_ms = 10000;

} // namespace

InstructorWindow::InstructorWindow(const ConsoleModels& models, KeptConsole& kept,
                                   StationView& view, const ProgramTracker& tracker)
    : m_ui{std::make_unique<Ui::InstructorWindow>()},
      m_models{models},
      m_kept{kept},
      m_savedViews{kept},
      m_status{new StatusLine{this}}
{
    m_ui->setupUi(this);
    m_models.breathing.setHistory(m_history);
    m_models.respiration.setHistory(m_history);
    m_models.gas.setHistory(m_history);
    m_models.airway.setHistory(m_history);
    m_models.head.setHistory(m_history);
    m_models.actions.setHistory(m_history);
    m_models.lesson.setHistory(m_history);
    m_models.conduct.setHistory(m_history);
    m_models.people.setHistory(m_history);
    m_models.attention.setHistory(m_history);
    m_models.stations.setHistory(m_history);
    m_ui->parts->setHistory(m_history);
    m_ui->section->setHistory(m_history);
    m_savedViews.setHistory(m_history);
    m_ui->pane->setModels(m_models.stations, m_models.attention, m_models.intubation);
    m_ui->pane->show(*m_models.patient.patient(), view);
    fillPanels(tracker);
    layPanels();
    m_teacher = std::make_unique<SceneTeacher>(m_models.lesson, m_ui->pane->scene());
    connectParts();
    auto* undo = new UndoButton{m_history};
    addMuteButton();
    m_ui->statusBar->addPermanentWidget(undo);
    m_ui->statusBar->addWidget(m_status, 1);
    fillSessionBar();
    addKeys(*undo);
    const auto tell = [this](const QString& why) {
        m_ui->statusBar->showMessage(why, kRefusalShown_ms);
    };
    connect(m_ui->pane, &PatientPane::refused, m_ui->statusBar, tell);
    connect(&m_history, &ChangeHistory::refused, m_ui->statusBar, tell);
    connect(&m_models.attention, &AttentionModel::showWanted, this, &InstructorWindow::showPlaceOf);
    connect(&m_models.session, &SessionModel::changed, this, &InstructorWindow::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &InstructorWindow::refresh);
    timer->start(kRefreshInterval_ms);
    connect(&m_models.participants, &QAbstractItemModel::dataChanged, this,
            &InstructorWindow::refreshStatus); // one number in both places
    refresh();
}

InstructorWindow::~InstructorWindow() { keepPanels(); }

StationScene& InstructorWindow::stationScene() { return m_ui->pane->stationScene(); }

std::optional<GlotticView> InstructorWindow::glottisSeen() const
{
    return m_ui->laryngoscope->seen();
}

void InstructorWindow::fillPanels(const ProgramTracker& tracker)
{
    m_ui->breathing->setModel(m_models.breathing);
    m_ui->condition->setModel(m_models.respiration);
    m_ui->gas->setModel(m_models.gas);
    m_models.airway.setPatient(m_models.patient);
    m_models.head.setPatient(m_models.patient);
    m_ui->airway->setModels(m_models.airway, m_models.head);
    m_ui->airway->showGroup(m_kept.airwayGroup());
    connect(m_ui->airway, &AirwayPanel::groupChosen, this,
            [this](const QByteArray& name) { m_kept.keepAirwayGroup(name); });
    m_ui->waveforms->setTrace(m_models.trace);
    m_ui->laryngoscope->setStation(stationScene());
    m_ui->tries->setModel(m_models.tries);
    m_ui->tries->linkMoments();
    connect(m_ui->tries, &TryPanel::momentAsked, m_ui->pane, &PatientPane::chooseStep);
    m_models.tries.setEffort([scope = QPointer<LaryngoscopePanel>{m_ui->laryngoscope}] {
        return scope ? scope->effort() : std::nullopt;
    });
    m_ui->monitor->setModel(m_models.vitals, m_models.sound);
    m_ui->participants->setModel(m_models.participants, m_models.conduct, m_models.stations,
                                 m_models.people);
    m_ui->participants->setOwnHead([this] { return stationScene().moment().head; });
    m_ui->network->setModel(m_models.network);
    m_ui->actions->setModel(m_models.actions);
    m_models.actions.object().setGroups(m_models.patient.patient()->groups());
    m_drawn = m_models.stations.shown();
    listParts();
    m_ui->partsPage->setFocusProxy(m_ui->parts);
    auto* lesson = new LessonBar;
    lesson->setModel(m_models.lesson);
    m_ui->partsLayout->insertWidget(0, lesson);
    lesson->putBefore(*m_ui->parts);
    m_tools = new ProgramTrackerPanel{tracker};
    m_ui->trackerDock->setWidget(m_tools);
    connect(m_tools, &ProgramTrackerPanel::wanted, this, &InstructorWindow::trackerWanted);
    connect(m_tools, &ProgramTrackerPanel::unwanted, this, &InstructorWindow::trackerUnwanted);
    refreshInvitation();
    connect(m_ui->invitation, &InvitationPanel::newCodeWanted, &m_models.conduct,
            &ConductModel::changeCode);
    connect(m_ui->participants, &ParticipantsPanel::banned, m_ui->invitation, [this](Role role) {
        m_ui->invitation->askForNewCode(
            role, tr("Who was removed knows the code, and can join by it under another name."));
    });
}

void InstructorWindow::show(const PatientModel& patient, StationView& view)
{
    m_ui->pane->show(patient, view);
    if (m_projector)
        m_projector->show(patient, view);
    m_models.actions.object().setGroups(patient.groups());
    followPicture();
}

/// As they were when the station was drawn last.
void InstructorWindow::listParts()
{
    const std::string& patient = stationScene().patient().contentHash();
    m_ui->parts->setScene(m_ui->pane->scene(), m_drawn, patient);
    m_ui->section->setScene(m_ui->pane->scene(), m_drawn, patient);
    m_part = m_ui->parts->chosenName();
}

/// The station that is shown is drawn once its patient is; until then the one before.
void InstructorWindow::followPicture()
{
    const StationId shown = m_models.stations.shown();
    if (liesAt(*m_models.session.node().state(), shown, stationScene().patient())
        && std::exchange(m_drawn, shown) != shown)
        m_teacher->pointAt(std::nullopt); // it was a part of the other one
    m_teacher->setElsewhere(m_drawn != shown);
    listParts();
}

/// A part is chosen in the picture or in the list.
void InstructorWindow::connectParts()
{
    m_chooser = std::make_unique<PartChooser>(m_ui->pane->scene(), *m_ui->parts);
    connect(m_chooser.get(), &PartChooser::chosen, this, [this](const QString& name) {
        m_part = name;
        refreshStatus();
    });
    connect(m_ui->parts, &PartsPanel::chosenInList, this,
            [this](const std::vector<std::uint16_t>& parts) {
                m_teacher->pointAt(parts.size() == 1 ? std::optional{parts.front()} : std::nullopt);
            });
    connect(&m_models.lesson, &LessonModel::changed, this, &InstructorWindow::refreshStatus);
    connect(&m_models.stations, &StationsModel::shownChanged, this,
            &InstructorWindow::followPicture);
}

void InstructorWindow::layPanels()
{
    using Group = PanelDocks::Group;
    m_docks = std::make_unique<PanelDocks>(
        *this,
        QList<Group>{
            Group{m_ui->breathingDock, m_ui->conditionDock, m_ui->gasDock, m_ui->airwayDock,
                  m_ui->actionsDock, m_ui->partsDock, m_ui->trackerDock},
            Group{m_ui->waveformDock, m_ui->laryngoscopeDock, m_ui->monitorDock, m_ui->tryDock},
            Group{m_ui->participantsDock, m_ui->invitationDock, m_ui->networkDock}});
    offerPanels();
    m_docks->offerAll();
    offerWindows();
    m_docks->layStandard(); // beneath each other they would need more height than there is
    connect(m_docks.get(), &PanelDocks::settled, this, &InstructorWindow::keepPanels);
}

void InstructorWindow::offerPanels()
{
    const auto offer = [this](QDockWidget* dock, const char* name, const QString& text,
                              const QString& key, const QString& toolTip) {
        m_docks->offer(*dock, text, QKeySequence{key}, toolTip)->setObjectName(QLatin1String{name});
    };
    offer(m_ui->breathingDock, "showBreathing", tr("&Breathing"), QStringLiteral("Ctrl+B"),
          tr("Rate, volume and stop of the patient's own breathing, and a bag by hand"));
    offer(m_ui->conditionDock, "showCondition", tr("Lu&ngs"), QStringLiteral("Ctrl+D"),
          tr("Conditions of the lungs, position and ventilator"));
    offer(m_ui->gasDock, "showGas", tr("&Gas and drugs"), QStringLiteral("Ctrl+G"),
          tr("Oxygen, mask, oximeter's probe and cuff, and drugs by weight"));
    offer(m_ui->airwayDock, "showAirway", tr("Airwa&y"), QStringLiteral("Ctrl+Y"),
          tr("What makes the airway difficult, from swelling to a stiff neck, how severe "
             "each is, and how the head lies"));
    offer(m_ui->actionsDock, "showActions", tr("&Move"), QStringLiteral("Ctrl+M"),
          tr("Turn, move or scale the patient, or organs lifted out of it, and see who has them"));
    offer(m_ui->partsDock, "showParts", tr("Par&ts"), QStringLiteral("Ctrl+T"),
          tr("Show, hide, highlight or name parts of the patient, and cut it open"));
    offer(m_ui->trackerDock, "showTracker", tr("Trac&ker"), QStringLiteral("Ctrl+R"),
          tr("Tools of the instructor's own tracker as it sees them, and to connect one"));
    offer(m_ui->waveformDock, "showWaveforms", tr("Wa&veforms"), QStringLiteral("Ctrl+W"),
          tr("Flow, airway pressure and volume"));
    offer(
        m_ui->laryngoscopeDock, "showLaryngoscope", tr("&Laryngoscope"), QStringLiteral("Ctrl+L"),
        tr("What the camera of the laryngoscope shows, with grade and percentage of the glottis"));
    offer(m_ui->tryDock, "showTry", tr("Tri&es"), QStringLiteral("Ctrl+J"),
          tr("How the last try at intubating went, points, and what to do next"));
    offer(m_ui->monitorDock, "showMonitor", tr("Bedside m&onitor"), QStringLiteral("Ctrl+H"),
          tr("Heart, oxygen, CO2 and blood pressure of the patient, alarms, and the volume of "
             "their sounds"));
    offer(m_ui->participantsDock, "showParticipants", tr("&People"), QStringLiteral("Ctrl+U"),
          tr("Who takes part, and what is decided about them"));
    offer(m_ui->invitationDock, "showInvitation", tr("&Invite"), QStringLiteral("Ctrl+I"),
          tr("Codes for joining, and their links as a QR code"));
    offer(m_ui->networkDock, "showNetwork", tr("Net&work"), QStringLiteral("Ctrl+N"),
          tr("Latency, jitter, loss and drift for each participant"));
}

/// What concerns windows.
void InstructorWindow::offerWindows()
{
    QMenu& menu = m_docks->menu();
    menu.addSeparator();
    QAction* full = menu.addAction(tr("&Full screen"), this, &InstructorWindow::toggleFullScreen);
    full->setObjectName(QStringLiteral("fullScreen"));
    full->setShortcut(QKeySequence{Qt::Key_F11});
    full->setCheckable(true);
    connect(&menu, &QMenu::aboutToShow, full, [this, full] { full->setChecked(isFullScreen()); });
    m_projectorShown = menu.addAction(tr("Second window for a p&rojector"));
    m_projectorShown->setObjectName(QStringLiteral("projectorShown"));
    m_projectorShown->setToolTip(
        tr("The same picture without panels, on another screen where there is one"));
    m_projectorShown->setShortcut(QKeySequence{QStringLiteral("Ctrl+F11")});
    m_projectorShown->setCheckable(true);
    connect(m_projectorShown, &QAction::toggled, this, &InstructorWindow::showProjector);
    addActions({full, m_projectorShown});
}

void InstructorWindow::toggleFullScreen() { setWindowState(windowState() ^ Qt::WindowFullScreen); }

void InstructorWindow::showProjector(bool shown)
{
    if (!shown)
        return m_projector.reset();
    m_projector = std::make_unique<ProjectorWindow>(stationScene(), stationScene().patient(),
                                                    m_ui->pane->view(), *this);
    connect(
        m_projector.get(), &ProjectorWindow::closed, m_projectorShown,
        [this] { m_projectorShown->setChecked(false); }, Qt::QueuedConnection);
    m_projector->show();
}

void InstructorWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    if (!event->spontaneous() && !m_isLaidOut)
        QTimer::singleShot(0, this, &InstructorWindow::layFirst); // it has its height only then
}

void InstructorWindow::layFirst()
{
    if (!isVisible() || std::exchange(m_isLaidOut, true) || m_docks->restore(m_kept.panels()))
        return;
    m_docks->layStandard();
    m_ui->invitationDock->raise(); // nobody else is here yet
}

/// What stands in windows of its own goes with the console.
void InstructorWindow::hideEvent(QHideEvent* event)
{
    QMainWindow::hideEvent(event);
    if (event->spontaneous())
        return;
    keepPanels();
    m_isLaidOut = false;
    m_projectorShown->setChecked(false);
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        if (dock->isFloating())
            dock->hide();
}

/// Once they were laid, and while those are shown that float. Not only at the end: a console may be
/// killed.
void InstructorWindow::keepPanels()
{
    if (m_isLaidOut)
        m_kept.keepPanels(m_docks->state());
}

bool InstructorWindow::focusNextPrevChild(bool next) { return focusNextAsRead(*this, next); }

void InstructorWindow::closeEvent(QCloseEvent* event)
{
    if (m_mayClose && !m_mayClose())
        return event->ignore();
    QMainWindow::closeEvent(event);
}

void InstructorWindow::fillSessionBar()
{
    m_control = std::make_unique<SessionControl>(
        *m_ui->sessionBar, m_models.session,
        SessionControl::Actions{*m_ui->start, *m_ui->pause, *m_ui->end});
    m_ui->sessionBar->addSeparator();
    auto* views = new ViewControls{stationScene(), m_savedViews, m_models.people};
    connect(views, &ViewControls::changed, this, &InstructorWindow::refreshStatus);
    m_ui->sessionBar->addWidget(views);
    addMenuButton();
}

/// All that the window has, also for panels that float.
void InstructorWindow::addKeys(const UndoButton& undo)
{
    m_docks->addKeys(actions());
    m_docks->addKeys({m_ui->start, m_ui->pause, m_ui->end, &undo.undoAction()});
}

/// In reach whichever panel is in front.
void InstructorWindow::addMuteButton()
{
    QAction* mute = m_ui->monitor->muteAction();
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("muteOfConsole"));
    button->setDefaultAction(mute);
    button->setAccessibleName(mute->text());
    button->setFocusPolicy(Qt::StrongFocus);
    m_ui->statusBar->addPermanentWidget(button);
    m_docks->menu().addSeparator();
    m_docks->menu().addAction(mute);
    addAction(mute);
}

void InstructorWindow::addMenuButton()
{
    auto* space = new QWidget;
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_ui->sessionBar->addWidget(space);
    auto* panels = new QToolButton;
    panels->setObjectName(QStringLiteral("panels"));
    panels->setText(tr("&Panels"));
    panels->setToolTip(tr("Bring a panel, lay all as at first, full screen, second window"));
    panels->setFocusPolicy(Qt::TabFocus);
    panels->setPopupMode(QToolButton::InstantPopup);
    panels->setMenu(&m_docks->menu());
    m_ui->sessionBar->addWidget(panels);
}

void InstructorWindow::showPlaceOf(const Attention& attention)
{
    if (attention.station != kNoStation
        && (attention.concern == Concern::Developing
            || attention.concern == Concern::BreathingStops)) {
        m_models.stations.show(attention.station);
        PanelDocks::bring(attention.concern == Concern::Developing ? *m_ui->conditionDock
                                                                   : *m_ui->breathingDock);
        return;
    }
    if (attention.concern == Concern::TubePlace) {
        m_models.stations.show(attention.station);
        PanelDocks::bring(*m_ui->gasDock);
        return m_ui->gas->goToTube();
    }
    if (attention.concern == Concern::BrokenOff)
        return showAgain(attention.station);
    if (attention.concern == Concern::Tracker) {
        // Not from within the press of a button: a dialog opens.
        QMetaObject::invokeMethod(this, &InstructorWindow::trackerWanted, Qt::QueuedConnection);
        return;
    }
    if (attention.concern == Concern::Unseen
        && attention.participant == m_models.session.node().self())
        return PanelDocks::bring(*m_ui->trackerDock);
    if (attention.concern == Concern::Clock) {
        PanelDocks::bring(*m_ui->networkDock);
        m_ui->network->choose(attention.participant);
        return;
    }
    PanelDocks::bring(*m_ui->participantsDock);
    m_ui->participants->choose(attention.participant);
}

void InstructorWindow::showAgain(StationId station)
{
    m_models.stations.show(station);
    if (m_models.lesson.canShowAgain()
        && liesAt(*m_models.session.node().state(), station, stationScene().patient()))
        return m_teacher->showAgain(*m_ui->parts, *m_ui->section);
    m_ui->statusBar->showMessage(
        tr("Not shown yet: press Show again once the station's patient is drawn"),
        kRefusalShown_ms);
}

void InstructorWindow::refresh()
{
    const SessionPhase phase = m_models.session.phase();
    if (std::exchange(m_shownPhase, phase) != phase && phase == SessionPhase::Running
        && !m_ui->waveformDock->isHidden())
        m_ui->waveformDock->raise(); // the patient begins to breathe
    m_ui->breathing->setEnabled(phase != SessionPhase::Ended);
    m_control->refresh();
    refreshInvitation();
    refreshStatus();
}

void InstructorWindow::setReach(SessionReach reach)
{
    m_reach = reach;
    m_ui->invitation->show(m_models.session.node(), m_reach);
}

void InstructorWindow::refreshInvitation()
{
    const SessionNode& node = m_models.session.node();
    const JoinCodes codes = node.joinCodes();
    const bool isLocked = node.state()->isLocked();
    if (codes == m_shownCodes && isLocked == m_shownLocked)
        return;
    m_shownCodes = codes;
    m_shownLocked = isLocked;
    m_ui->invitation->show(node, m_reach);
}

/// What the picture shows that is not the patient as usual.
QStringList InstructorWindow::unusual(const StationMoment& moment) const
{
    QStringList told;
    if (m_models.stations.isForAll())
        told += tr("▲ Changes of breathing, condition and airway are for all %1 stations")
                    .arg(m_models.stations.open().size());
    if (isAway(moment))
        told += tr("▲ patient not in its original place");
    if (const QString lifted = liftedText(moment.lifted); !lifted.isEmpty())
        told += lifted;
    if (const QString drawn = drawingText(moment.tubeDrawing); !drawn.isEmpty())
        told += tr("▲ %1", "how the tube is drawn").arg(drawn);
    if (moment.exaggeration != 1.0)
        told += tr("▲ breathing shown %1 times as large as it is").arg(moment.exaggeration);
    if (inMillilitres(moment.notDrawn) >= 1.0)
        told +=
            tr("▲ lungs drawn %1\u00a0ml too small").arg(qRound(inMillilitres(moment.notDrawn)));
    if (const QString patient = m_models.patient.notice();
        !patient.isEmpty() && !m_models.patient.canFetchAgain())
        told += patient.simplified();
    return told;
}

/// Of what participants share; else of the console's own tools.
QString InstructorWindow::trackedText() const
{
    if (const auto oldest = m_models.participants.oldestSample_ms())
        return tr("Oldest sample %1\u00a0ms").arg(qRound(*oldest));
    const int own = m_tools->seen();
    return own > 0 ? tr("Own tools tracked: %1").arg(own) : tr("Nothing is tracked");
}

void InstructorWindow::refreshStatus()
{
    const SessionNode& node = m_models.session.node();
    StationScene& scene = stationScene();
    const StationMoment& moment = scene.moment();
    QStringList told = unusual(moment);
    for (const QString& shown : {m_models.lesson.text(), m_models.lesson.elsewhereText()})
        if (!shown.isEmpty())
            told.prepend(shown);
    if (!m_part.isEmpty())
        told += tr("Part: %1").arg(m_part);
    if (const auto& eyes = scene.throughEyesOf())
        told += throughEyesText(*node.state(), moment, *eyes);
    told += tr("● Condition: %1").arg(m_models.respiration.inForceText());
    if (m_models.airway.isSeen())
        told += tr("● Airway: %1").arg(m_models.airway.inForceText());
    if (!m_models.head.isNeutral())
        told += tr("● Head position: %1").arg(m_models.head.inForceText());
    told += m_models.people.workText();
    told += tr("Patient: %1").arg(QString::fromStdString(scene.patient().name()));
    told += trackedText();
    told += m_shownLocked ? tr("Locked: nobody new comes in")
                          : tr("Trainees join at port %1").arg(node.port());
    told += tr("%1 frames per second").arg(qRound(scene.scene().statistics().framesPerSecond));
    m_status->say(told);
}

} // namespace carina
