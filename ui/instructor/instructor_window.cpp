#include "ui/instructor/instructor_window.h"

#include "models/errors/error_text.h"
#include "models/objects/object_words.h"
#include "ui/panels/undo_button.h"
#include "ui_instructor_window.h"
#include "widgets/plain_label.h"
#include "widgets/scene/view/scene_view.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QScrollArea>
#include <QShowEvent>
#include <QStyle>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kRefreshInterval_ms = 250;
constexpr int kEndAsked_ms = 4000;
constexpr int kLargeWindow = 1000; ///< pixels high; there is room for waveforms and invitation
constexpr int kLargeWaveforms = 480;
constexpr int kLowParticipants = 200; ///< pixels; of the rest, the picture has most

/// Told by shape besides the word.
QString phaseShape(SessionPhase phase)
{
    switch (phase) {
    case SessionPhase::Prepared:
        return QStringLiteral("○");
    case SessionPhase::Running:
        return QStringLiteral("●");
    case SessionPhase::Paused:
        return QStringLiteral("❙❙");
    case SessionPhase::Ended:
        return QStringLiteral("■");
    }
    return {};
}

/// Makes an action's button as wide as it ever gets, so that nothing beside it moves under the
/// pointer when its words change.
void reserve(const QToolBar& bar, QAction& action, const QString& longest)
{
    const QString now = action.text();
    action.setText(longest);
    QWidget* button = bar.widgetForAction(&action);
    button->ensurePolished();
    button->setMinimumWidth(button->sizeHint().width());
    action.setText(now);
}

/// Lets a panel scroll where the window is too low for all of it.
void makeScrollable(QDockWidget& dock)
{
    QWidget* panel = dock.widget();
    auto* area = new QScrollArea{&dock};
    area->setFocusPolicy(Qt::NoFocus);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setMinimumWidth(panel->minimumSizeHint().width()
                          + area->style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    area->setWidgetResizable(true);
    area->setWidget(panel);
    dock.setWidget(area);
}

} // namespace

InstructorWindow::InstructorWindow(SessionModel& session, BreathingModel& breathing,
                                   RespirationModel& respiration, BreathTrace& trace,
                                   ParticipantsModel& participants, ConductModel& conduct,
                                   PeopleModel& people, NetworkModel& network,
                                   ObjectActionModel& actions, StationsModel& stations,
                                   LessonModel& lesson, SessionPatient& patient, StationView& view)
    : m_ui{std::make_unique<Ui::InstructorWindow>()},
      m_session{session},
      m_participants{participants},
      m_patient{patient},
      m_objects{actions.object()},
      m_phase{new PlainLabel{this}},
      m_status{new PlainLabel{this}}
{
    m_ui->setupUi(this);
    breathing.setHistory(m_history);
    respiration.setHistory(m_history);
    actions.setHistory(m_history);
    lesson.setHistory(m_history);
    m_ui->statusBar->addPermanentWidget(new UndoButton{m_history});
    m_ui->breathing->setModel(breathing);
    m_ui->condition->setModel(respiration);
    m_ui->waveforms->setTrace(trace);
    m_ui->participants->setModel(participants, conduct, stations, people);
    m_ui->pane->setModels(session, respiration, stations, people, lesson);
    m_ui->pane->show(*patient.patient(), view);
    m_ui->network->setModel(network);
    refreshInvitation();
    connect(m_ui->invitation, &InvitationPanel::newCodeWanted, &conduct, &ConductModel::changeCode);
    connect(m_ui->participants, &ParticipantsPanel::banned, m_ui->invitation, [this](Role role) {
        m_ui->invitation->askForNewCode(
            role, tr("Who was removed knows the code, and can join by it under another name."));
    });
    m_ui->actions->setModel(actions);
    m_objects.setGroups(patient.patient()->groups());
    layDocks();
    m_ui->parts->setScene(m_ui->pane->scene());
    m_ui->section->setScene(m_ui->pane->scene());
    m_ui->partsPage->setFocusProxy(m_ui->parts);
    m_teacher = std::make_unique<SceneTeacher>(lesson, m_ui->pane->scene());
    connectParts();
    // What it says never widens the window: what matters stands in front.
    m_status->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_ui->statusBar->addWidget(m_status, 1);
    m_status->setToolTip(
        tr("Oldest sample: time since the oldest pose now drawn was measured (latency)"));
    fillSessionBar();

    connect(&m_session, &SessionModel::changed, this, &InstructorWindow::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &InstructorWindow::refresh);
    timer->start(kRefreshInterval_ms);
    connect(&participants, &QAbstractItemModel::dataChanged, this,
            &InstructorWindow::refreshStatus); // one number in both places
    refresh();
}

InstructorWindow::~InstructorWindow() = default;

StationScene& InstructorWindow::stationScene() { return m_ui->pane->stationScene(); }

void InstructorWindow::show(const PatientModel& patient, StationView& view)
{
    m_ui->pane->show(patient, view);
    m_objects.setGroups(patient.groups());
    m_ui->parts->setScene(m_ui->pane->scene());
    m_ui->section->setScene(m_ui->pane->scene());
}

/// A part is chosen in the picture or in the list.
void InstructorWindow::connectParts()
{
    m_chooser = std::make_unique<PartChooser>(m_ui->pane->scene(), *m_ui->parts);
    connect(m_chooser.get(), &PartChooser::chosen, m_ui->pane, &PatientPane::tellPart);
    connect(m_ui->parts, &PartsPanel::chosenInList, this,
            [this](const std::vector<std::uint16_t>& parts) {
                m_teacher->pointAt(parts.size() == 1 ? std::optional{parts.front()} : std::nullopt);
            });
}

void InstructorWindow::layDocks()
{
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea); // the table needs all the width
    makeScrollable(*m_ui->breathingDock);
    makeScrollable(*m_ui->conditionDock);
    tabifyDockWidget(m_ui->breathingDock, m_ui->conditionDock);
    tabifyDockWidget(m_ui->conditionDock, m_ui->actionsDock);
    tabifyDockWidget(m_ui->actionsDock, m_ui->partsDock);
    m_ui->breathingDock->raise();
    tabifyDockWidget(m_ui->waveformDock, m_ui->invitationDock);
    tabifyDockWidget(m_ui->invitationDock, m_ui->networkDock);
    m_ui->invitationDock->raise(); // nobody else is here yet
    // A panel behind another is out of sight and yet visible to Qt: nobody shall tab into it.
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        connect(dock, &QDockWidget::visibilityChanged, dock, &QWidget::setEnabled);
    resizeDocks({m_ui->participantsDock}, {kLowParticipants}, Qt::Vertical);
}

void InstructorWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    if (!event->spontaneous() && !std::exchange(m_isLaidOut, true))
        QTimer::singleShot(0, this, &InstructorWindow::useHeight); // which it has only then
}

void InstructorWindow::useHeight()
{
    if (height() < kLargeWindow)
        return;
    // Beneath the waveforms, not behind them: one that is in front of another cannot be split off.
    for (QDockWidget* dock : {m_ui->invitationDock, m_ui->networkDock}) {
        removeDockWidget(dock);
        addDockWidget(Qt::RightDockWidgetArea, dock, Qt::Vertical);
        dock->show();
    }
    tabifyDockWidget(m_ui->invitationDock, m_ui->networkDock);
    m_ui->invitationDock->raise();
    resizeDocks({m_ui->waveformDock}, {kLargeWaveforms}, Qt::Horizontal);
}

void InstructorWindow::closeEvent(QCloseEvent* event)
{
    if (m_mayClose && !m_mayClose())
        return event->ignore();
    QMainWindow::closeEvent(event);
}

void InstructorWindow::fillSessionBar()
{
    m_phase->setMargin(8);
    m_ui->sessionBar->addWidget(m_phase);
    QFont bold = m_phase->font(); // that of the bar
    bold.setBold(true);
    m_phase->setFont(bold);
    const QList<QAction*> actions{m_ui->start,          m_ui->pause,       m_ui->end,
                                  m_ui->showCondition,  m_ui->showActions, m_ui->showParts,
                                  m_ui->showInvitation, m_ui->showNetwork};
    m_ui->sessionBar->addActions(actions);
    for (QAction* action : actions)
        m_ui->sessionBar->widgetForAction(action)->setFocusPolicy(Qt::TabFocus);
    reserve(*m_ui->sessionBar, *m_ui->start, tr("&Go on"));
    reserve(*m_ui->sessionBar, *m_ui->end, tr("Really &end?"));
    connect(m_ui->start, &QAction::triggered, &m_session, &SessionModel::start);
    connect(m_ui->pause, &QAction::triggered, &m_session, &SessionModel::pause);
    connect(m_ui->end, &QAction::triggered, this, &InstructorWindow::endOnSecondPress);
    const auto raises = [this](QAction* action, QDockWidget* dock) {
        connect(action, &QAction::triggered, this, [dock] {
            dock->raise();
            dock->widget()->setFocus();
        });
    };
    raises(m_ui->showCondition, m_ui->conditionDock);
    raises(m_ui->showActions, m_ui->actionsDock);
    raises(m_ui->showParts, m_ui->partsDock);
    raises(m_ui->showInvitation, m_ui->invitationDock);
    raises(m_ui->showNetwork, m_ui->networkDock);
    addAction(m_ui->showWaveforms); // by its key, as the bar is full
    raises(m_ui->showWaveforms, m_ui->waveformDock);
}

void InstructorWindow::endOnSecondPress()
{
    if (std::exchange(m_endAsked, false)) {
        m_session.end();
        return refresh();
    }
    m_endAsked = true;
    refresh();
    QTimer::singleShot(kEndAsked_ms, this, [this] {
        m_endAsked = false;
        refresh();
    });
}

void InstructorWindow::refresh()
{
    const SessionPhase phase = m_session.phase();
    if (std::exchange(m_shownPhase, phase) != phase && phase == SessionPhase::Running)
        m_ui->waveformDock->raise(); // the patient begins to breathe
    m_phase->setText(tr("%1   %2 %3 %4")
                         .arg(m_session.name(), phaseShape(phase), m_session.phaseText(),
                              m_session.runningTimeText()));
    m_phase->setMinimumWidth(std::max(m_phase->minimumWidth(), m_phase->sizeHint().width()));
    m_ui->start->setText(phase == SessionPhase::Paused ? tr("&Go on") : tr("&Start"));
    m_ui->breathing->setEnabled(phase != SessionPhase::Ended);
    m_ui->start->setEnabled(m_session.canStart());
    m_ui->pause->setEnabled(m_session.canPause());
    m_ui->end->setEnabled(m_session.canEnd());
    m_ui->end->setText(m_endAsked ? tr("Really &end?") : tr("&End"));
    refreshInvitation();
    m_ui->pane->refresh();
    refreshStatus();
}

void InstructorWindow::refreshInvitation()
{
    const JoinCodes codes = m_session.node().joinCodes();
    const bool isLocked = m_session.node().state()->isLocked();
    if (codes == m_shownCodes && isLocked == m_shownLocked)
        return;
    m_shownCodes = codes;
    m_shownLocked = isLocked;
    m_ui->invitation->show(m_session.node());
}

void InstructorWindow::refreshStatus()
{
    if (const auto refusal = m_session.node().refusal()) {
        m_status->setText(errorText(*refusal));
        return;
    }
    // What is out of the ordinary stands in front.
    StationScene& scene = stationScene();
    const StationMoment& moment = scene.moment();
    QStringList told = m_participants.replacedTokens(moment.time);
    if (const auto doubtful = m_participants.doubtfulRegistrations(); !doubtful.isEmpty())
        told += tr("▲ %n registration(s) not to be relied on", nullptr, int(doubtful.size()));
    if (const QString patient = m_patient.notice(); !patient.isEmpty())
        told += patient;
    if (isAway(moment))
        told += tr("▲ patient not in its original place");
    if (const QString lifted = liftedText(moment.lifted); !lifted.isEmpty())
        told += lifted;
    if (moment.exaggeration != 1.0)
        told += tr("▲ motion enlarged");
    if (inMillilitres(moment.notDrawn) >= 1.0)
        told +=
            tr("▲ lungs drawn %1\u00a0ml too small").arg(qRound(inMillilitres(moment.notDrawn)));
    told += tr("Patient: %1").arg(QString::fromStdString(scene.patient().name()));
    const auto oldest = m_participants.oldestSample_ms();
    told += oldest ? tr("Oldest sample %1\u00a0ms").arg(qRound(*oldest)) : tr("Nothing is tracked");
    told +=
        tr("%1 frames per second").arg(qRound(m_ui->pane->scene().statistics().framesPerSecond));
    told += m_shownLocked ? tr("Locked: nobody new comes in")
                          : tr("Trainees join at port %1").arg(m_session.node().port());
    m_status->setText(told.join(QStringLiteral("      ")));
}

} // namespace carina
