#include "ui/trainee/trainee_window.h"

#include "models/lesson/lesson_words.h"
#include "models/station/own_station.h"
#include "models/station/people_words.h"
#include "models/station/station_notice.h"
#include "ui/panels/airway/laryngoscope_panel.h"
#include "ui/panels/airway/try_panel.h"
#include "ui/panels/breathing/hands_panel.h"
#include "ui/panels/patient/actions_panel.h"
#include "ui/panels/patient/parts_panel.h"
#include "ui/panels/patient/section_panel.h"
#include "ui/panels/people/people_menus.h"
#include "ui/vitals/bedside_monitor_panel.h"
#include "widgets/plain_label.h"
#include "widgets/scene/view/scene_view.h"

#include <QActionGroup>
#include <QApplication>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>
#include <QWindow>

namespace carina
{
namespace
{

constexpr int kNoticeInterval_ms = 200;
constexpr int kNoticeMargin = 4;      // pixels
constexpr int kAnotherGap = 12;       // pixels beneath the button for another session
constexpr int kMostPassed = 16;       // stops of Tab outside of the window
constexpr int kDebriefingWidth = 320; // pixels, in which its sentences can be read

} // namespace

TraineeWindow::TraineeWindow(const SessionNode& node, SessionPatient& patient,
                             const StationView& view, const HeadsetView& headset, ViewOutput output,
                             ChinProbeModel chinProbe, ObjectActionModel& actions,
                             PeopleModel& people, TryWatch& tries, Standing standing,
                             const ProgramTracker& tracker)
    : m_node{node},
      m_patient{patient},
      m_scene{new SceneView{this}},
      m_actions{new QDockWidget{tr("Actions"), this}},
      m_parts{new QDockWidget{tr("Parts"), this}},
      m_tracker{new QDockWidget{tr("Tracker"), this}},
      m_laryngoscope{new QDockWidget{tr("Laryngoscope"), this}},
      m_debriefing{new QDockWidget{tr("Debriefing"), this}},
      m_monitor{new QDockWidget{tr("Bedside monitor"), this}},
      m_monitorPanel{new BedsideMonitorPanel},
      m_hands{new QDockWidget{tr("Hands"), this}},
      m_handsPanel{new HandsPanel},
      m_partsPanel{new PartsPanel},
      m_section{new SectionPanel},
      m_notices{new PlainLabel{this}, new PlainLabel{this}},
      m_another{new QPushButton{tr("&Join another session"), this}},
      m_headset{headset},
      m_people{people},
      m_objects{actions.object()},
      m_chinProbe{chinProbe},
      m_standing{std::move(standing)},
      m_stationScene{*m_scene, *patient.patient(), view},
      m_lesson{m_stationScene, node},
      m_chooser{*m_scene, *m_partsPanel}
{
    setWindowTitle(tr("Carina trainee"));
    setPalette(QPalette{Qt::white, Qt::black});
    setAutoFillBackground(true);
    setCentralWidget(m_scene);
    makeActions(actions);
    makeParts();
    makeTracker(tracker);
    makeLaryngoscope(tries);
    makeDebriefing(tries);
    makeMonitor();
    makeHands();
    for (QLabel* notice : m_notices) {
        notice->setAttribute(Qt::WA_NativeWindow); // else the scene's own window would cover it
        notice->setAlignment(Qt::AlignCenter);
        notice->setAutoFillBackground(true);
        notice->setMargin(kNoticeMargin);
        notice->setWordWrap(true);
    }

    m_another->setObjectName(QStringLiteral("another"));
    m_another->setAttribute(Qt::WA_NativeWindow);
    m_another->setPalette(QApplication::palette());
    m_another->setDefault(true);
    m_another->hide();
    connect(m_another, &QPushButton::clicked, this, &TraineeWindow::anotherWanted);

    m_scene->setAccessibleName(tr("Patient, three-dimensional view"));
    m_scene->setBackground(Qt::black);
    showTo(output);
    makeMenu();
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &TraineeWindow::refreshNotice);
    timer->start(kNoticeInterval_ms);
}

void TraineeWindow::show(const PatientModel& patient, const StationView& view,
                         ChinProbeModel chinProbe)
{
    chinProbe.setMovesManikin(m_chinProbe.movesManikin());
    m_chinProbe = chinProbe;
    m_stationScene.show(patient, view);
    m_objects.setGroups(patient.groups());
    m_partsPanel->setScene(*m_scene);
    m_section->setScene(*m_scene);
}

void TraineeWindow::makeActions(ObjectActionModel& actions)
{
    auto* panel = new ActionsPanel;
    m_objects.setGroups(m_stationScene.patient().groups());
    panel->setModel(actions);
    addPanel(m_actions, panel, "showActions", tr("&Actions on patient and organs"));
}

void TraineeWindow::makeParts()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout{page};
    column->addWidget(m_partsPanel, 1);
    column->addWidget(m_section);
    page->setFocusProxy(m_partsPanel);
    m_partsPanel->setScene(*m_scene);
    m_section->setScene(*m_scene);
    addPanel(m_parts, page, "showParts", tr("Parts and se&ctions of the patient"));
    tabifyDockWidget(m_actions, m_parts); // one above the other they are higher than a screen
}

void TraineeWindow::makeTracker(const ProgramTracker& tracker)
{
    auto* panel = new ProgramTrackerPanel{tracker};
    connect(panel, &ProgramTrackerPanel::wanted, this, &TraineeWindow::trackerWanted);
    connect(panel, &ProgramTrackerPanel::unwanted, this, &TraineeWindow::trackerUnwanted);
    addPanel(m_tracker, panel, "showTracker", tr("Trac&ker and its tools"));
    tabifyDockWidget(m_parts, m_tracker);
}

void TraineeWindow::makeLaryngoscope(TryWatch& tries)
{
    m_scope = new LaryngoscopePanel;
    m_scope->setStation(m_stationScene);
    tries.setEffort([shown = QPointer<LaryngoscopePanel>{m_scope}] {
        return shown ? shown->effort() : std::nullopt;
    });
    addPanel(m_laryngoscope, m_scope, "showLaryngoscope", tr("&View of the laryngoscope"));
    tabifyDockWidget(m_tracker, m_laryngoscope);
}

std::optional<GlotticView> TraineeWindow::glottisSeen() const { return m_scope->seen(); }

void TraineeWindow::makeDebriefing(TryWatch& tries)
{
    auto* panel = new TryPanel;
    panel->setModel(tries);
    auto* area = new QScrollArea;
    area->setFocusPolicy(Qt::NoFocus);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidgetResizable(true);
    area->setWidget(panel);
    area->setMinimumWidth(kDebriefingWidth);
    area->setFocusProxy(panel);
    addPanel(m_debriefing, area, "showTry", tr("&Debriefing of the last try"));
    tabifyDockWidget(m_laryngoscope, m_debriefing);
    connect(&tries, &TryWatch::ended, m_debriefing, [this] {
        m_debriefing->show();
        m_debriefing->raise();
    });
}

void TraineeWindow::makeMonitor()
{
    addPanel(m_monitor, m_monitorPanel, "showMonitor", tr("&Bedside monitor, with its sounds"));
    addDockWidget(Qt::LeftDockWidgetArea, m_monitor); // it is looked at beside each of the others
    m_monitor->hide();
    addAction(m_monitorPanel->muteAction()); // its key acts while the keyboard is elsewhere
}

void TraineeWindow::setMonitor(VitalsModel& vitals, const SoundOutput& sound)
{
    m_monitorPanel->setModel(vitals, sound);
}

void TraineeWindow::makeHands()
{
    addPanel(m_hands, m_handsPanel, "showHands", tr("Cuff, stylet and bag in a panel"));
    addDockWidget(Qt::LeftDockWidgetArea, m_hands); // beneath the monitor, which shows what follows
    m_hands->hide();
    for (QAction* action : m_handsPanel->handActions())
        addAction(action); // so that its key acts while the panel is shut
}

void TraineeWindow::setHands(HandsModel& hands) { m_handsPanel->setModel(hands); }

void TraineeWindow::addPanel(QDockWidget* dock, QWidget* panel, const char* name,
                             const QString& menuText)
{
    dock->setWidget(panel);
    dock->setPalette(QApplication::palette());
    dock->setAutoFillBackground(true);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    dock->hide();
    QAction* toggle = dock->toggleViewAction();
    toggle->setText(menuText);
    toggle->setObjectName(QLatin1String{name}); // as in the console
    connect(toggle, &QAction::triggered, dock, [dock](bool isShown) {
        if (isShown) // and the menu, which gives the keyboard back, is gone
            QTimer::singleShot(0, dock, [dock] {
                dock->raise();
                dock->widget()->setFocus();
            });
    });
    // Behind the other it is out of sight and yet visible to Qt: nobody shall tab into it.
    connect(dock, &QDockWidget::visibilityChanged, dock, &QWidget::setEnabled);
}

void TraineeWindow::makeMenu()
{
    addStation();
    addOutputs();
    m_menu.addSeparator();
    addPresets();
    m_menu.addSeparator();
    addPeople();
    m_menu.addSeparator();
    m_menu.addAction(m_actions->toggleViewAction());
    m_menu.addAction(m_parts->toggleViewAction());
    m_menu.addAction(m_tracker->toggleViewAction());
    m_menu.addAction(m_laryngoscope->toggleViewAction());
    m_menu.addAction(m_debriefing->toggleViewAction());
    m_menu.addAction(m_monitor->toggleViewAction());
    m_menu.addAction(m_monitorPanel->muteAction());
    m_menu.addSeparator();
    addHands();
    m_menu.addSeparator();
    addFetching();
    addMotion();
    addAnother();
    m_menu.addAction(tr("F&ull screen on or off"), this,
                     [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    m_menu.addAction(tr("&Leave"), this, &QWidget::close);

    auto* open = new QAction{tr("Menu"), this};
    open->setShortcut(Qt::Key_Escape);
    open->setShortcutContext(Qt::ApplicationShortcut); // also while the scene has the keyboard
    connect(open, &QAction::triggered, this, [this] { m_menu.popup(mapToGlobal(menuPlace())); });
    addAction(open);
}

void TraineeWindow::addStation()
{
    QAction* station = m_menu.addAction(QString{});
    station->setEnabled(false);
    QAction* end = m_menu.addSeparator();
    const auto say = [=, this] {
        station->setText(stationText(m_node));
        station->setVisible(!station->text().isEmpty());
        end->setVisible(station->isVisible());
    };
    connect(&m_menu, &QMenu::aboutToShow, this, say);
    say();
}

void TraineeWindow::addOutputs()
{
    auto* outputs = new QActionGroup{this};
    const auto add = [this, outputs](ViewOutput output, const QString& text) {
        QAction* action = m_menu.addAction(text, this, [this, output] { showTo(output); });
        action->setCheckable(true);
        action->setChecked(output == m_stationScene.output());
        outputs->addAction(action);
    };
    add(ViewOutput::Screen, tr("On a &screen"));
    add(ViewOutput::Mono, tr("In a headset, &one picture"));
    add(ViewOutput::SideBySide, tr("In a headset, &two pictures side by side"));
}

void TraineeWindow::addPresets()
{
    auto* eyes = new EyesMenu{m_people, tr("Through the &eyes of"), this};
    connect(eyes, &EyesMenu::chosen, this, [this](std::optional<ParticipantId> participant) {
        m_stationScene.seeThrough(participant);
        refreshNotice();
    });
    const auto add = [this, eyes](ViewPreset preset, const QString& text) {
        m_presets.push_back(m_menu.addAction(text, this, [this, eyes, preset] {
            eyes->setChosen(std::nullopt);
            m_stationScene.seeThrough(std::nullopt);
            m_scene->showFrom(preset);
        }));
    };
    add(ViewPreset::Front, tr("From the &front"));
    add(ViewPreset::Right, tr("From the &right side"));
    add(ViewPreset::Trainee, tr("From the &head end"));
    m_presets.push_back(m_menu.addMenu(eyes));
    refreshLesson();
}

void TraineeWindow::addPeople()
{
    const auto self = [this]() -> std::optional<ParticipantId> { return m_node.self(); };
    const auto head = [this] { return m_stationScene.moment().head; };
    QAction* work = m_menu.addMenu(new WorkMenu{m_people, tr("&Work at the patient"), this});
    QAction* place =
        m_menu.addMenu(new PlaceMenu{m_people, self, head, tr("Where others see &you"), this});
    const auto offer = [=, this] {
        const auto own = m_people.person(m_node.self());
        work->setVisible(!isRemoved(m_node));
        place->setVisible(!isRemoved(m_node) && own && own->canBePlaced);
    };
    connect(&m_menu, &QMenu::aboutToShow, this, offer);
    offer();
}

/// What is not for this person is said beneath.
void TraineeWindow::addHands()
{
    for (QAction* action : m_handsPanel->handActions())
        m_menu.addAction(action);
    QAction* obstacle = m_menu.addAction(QString{});
    obstacle->setEnabled(false);
    m_menu.addAction(m_hands->toggleViewAction());
    const auto say = [=, this] {
        QString text = m_handsPanel->obstacle();
        obstacle->setText(text.replace(QLatin1Char{'&'}, QStringLiteral("&&"))); // of a name
        obstacle->setVisible(!obstacle->text().isEmpty());
    };
    connect(&m_menu, &QMenu::aboutToShow, this, say);
    say();
}

void TraineeWindow::addMotion()
{
    const std::vector<QAction*> choices = addChinProbe();
    QAction* assumed = m_menu.addAction(QString{});
    assumed->setEnabled(false);
    QAction* end = m_menu.addSeparator();
    const auto say = [=, this] {
        assumed->setText(m_chinProbe.assumption());
        assumed->setVisible(!assumed->text().isEmpty());
        for (QAction* choice : choices)
            choice->setVisible(m_chinProbe.isThere());
        end->setVisible(assumed->isVisible());
    };
    connect(&m_menu, &QMenu::aboutToShow, this, say);
    say();
}

std::vector<QAction*> TraineeWindow::addChinProbe()
{
    auto* choices = new QActionGroup{this};
    const auto add = [this, choices](bool movesManikin, const QString& text) {
        QAction* action = m_menu.addAction(
            text, this, [this, movesManikin] { m_chinProbe.setMovesManikin(movesManikin); });
        action->setCheckable(true);
        action->setChecked(movesManikin == m_chinProbe.movesManikin());
        choices->addAction(action);
        return action;
    };
    return {add(false, tr("Manikin lies still, chi&n probe moves the jaw")),
            add(true, tr("&Manikin is moved with its mouth closed"))};
}

void TraineeWindow::addFetching()
{
    QAction* stop = m_menu.addAction(tr("Stop the transfer of the session's &patient"), this,
                                     [this] { m_patient.stop(); });
    QAction* again = m_menu.addAction(tr("&Get the session's patient"), this,
                                      [this] { m_patient.fetchAgain(); });
    QAction* end = m_menu.addSeparator();
    const auto offer = [=, this] {
        const bool isIn = !isRemoved(m_node);
        stop->setVisible(isIn && m_patient.canStop());
        again->setVisible(isIn && m_patient.canFetchAgain());
        end->setVisible(stop->isVisible() || again->isVisible());
    };
    connect(&m_menu, &QMenu::aboutToShow, this, offer);
    offer();
}

void TraineeWindow::addAnother()
{
    QAction* another =
        m_menu.addAction(tr("&Join another session"), this, [this] { Q_EMIT anotherWanted(); });
    const auto offer = [this, another] { another->setVisible(offersAnother(m_node)); };
    connect(&m_menu, &QMenu::aboutToShow, this, offer);
    offer();
}

/// Over the lower edge, above the notice: what is worked on is in the middle. In a headset the menu
/// offers it, where one eye sees it whole.
void TraineeWindow::placeAnother()
{
    const bool isOffered = offersAnother(m_node) && m_stationScene.output() == ViewOutput::Screen;
    const bool isNew = isOffered && m_another->isHidden();
    m_another->setVisible(isOffered);
    if (!isOffered)
        return;
    const QRect around = m_scene->geometry();
    const QLabel& notice = *m_notices.front();
    QRect place{QPoint{}, m_another->sizeHint()};
    place.moveCenter(around.center());
    place.moveBottom((notice.isHidden() ? around.bottom() : notice.y()) - kAnotherGap);
    m_another->setGeometry(place);
    if (QWindow* window = m_another->windowHandle())
        window->raise();
    if (isNew && isOver(m_node)) // else who works on keeps the keyboard
        m_another->setFocus();
}

void TraineeWindow::showTo(ViewOutput output)
{
    m_stationScene.showTo(m_headset, output);
    // A headset's picture keeps all of the window.
    for (QDockWidget* dock :
         {m_actions, m_parts, m_tracker, m_laryngoscope, m_debriefing, m_monitor, m_hands}) {
        dock->setFloating(output != ViewOutput::Screen);
        dock->setAllowedAreas(output == ViewOutput::Screen ? Qt::AllDockWidgetAreas
                                                           : Qt::NoDockWidgetArea);
    }
    refreshNotice();
}

void TraineeWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    refreshNotice();
}

bool TraineeWindow::focusNextPrevChild(bool next)
{
    for (int passed = 0; passed < kMostPassed; ++passed) {
        if (!QMainWindow::focusNextPrevChild(next))
            return false;
        const QWidget* at = focusWidget();
        if (!at || rect().intersects(QRect{at->mapTo(this, QPoint{}), at->size()}))
            break;
    }
    return true;
}

/// Where one eye sees it whole.
QPoint TraineeWindow::menuPlace() const
{
    const bool twice = m_stationScene.output() == ViewOutput::SideBySide;
    const QSize size = m_menu.sizeHint();
    QRect eye = m_scene->geometry();
    eye.setWidth(twice ? eye.width() / 2 : eye.width());
    return eye.center() - QPoint{size.width() / 2, size.height() / 2};
}

QString TraineeWindow::notice() const
{
    QString notice = stationNotice(m_node, m_stationScene.moment(), m_stationScene.output(),
                                   m_standing ? m_standing() : std::nullopt);
    if (const QString trouble = m_chinProbe.trackerTrouble(); !trouble.isEmpty())
        notice.prepend(notice.isEmpty() ? trouble : trouble + QLatin1Char('\n'));
    if (notice.isEmpty())
        notice = m_chinProbe.notice();
    if (const auto& eyes = m_stationScene.throughEyesOf();
        eyes && m_stationScene.output() == ViewOutput::Screen && !m_stationScene.isViewFollowed()) {
        const QString told = throughEyesText(*m_node.state(), m_stationScene.moment(), *eyes);
        notice = notice.isEmpty() ? told : told + QLatin1Char('\n') + notice;
    }
    const QString lesson = lessonNotice(m_stationScene.moment(), m_stationScene.isViewFollowed());
    if (!lesson.isEmpty())
        notice = notice.isEmpty() ? lesson : lesson + QLatin1Char('\n') + notice;
    const QString patient = m_patient.notice();
    return notice.isEmpty() || patient.isEmpty() ? notice + patient
                                                 : notice + QLatin1Char('\n') + patient;
}

void TraineeWindow::withdrawOffers()
{
    if (!isRemoved(m_node))
        return;
    for (QDockWidget* dock : {m_actions, m_hands}) {
        dock->hide();
        dock->toggleViewAction()->setVisible(false);
    }
    for (QAction* action : m_handsPanel->handActions())
        action->setVisible(false);
}

void TraineeWindow::refreshLesson()
{
    m_partsPanel->setEnabled(!m_lesson.isFollowing());
    m_section->setEnabled(!m_lesson.isFollowing());
    const bool isOwnView =
        m_stationScene.output() == ViewOutput::Screen && !m_stationScene.isViewFollowed();
    for (QAction* preset : m_presets)
        preset->setEnabled(isOwnView);
}

void TraineeWindow::refreshNotice()
{
    withdrawOffers();
    refreshLesson();
    const ViewOutput output = m_stationScene.output();
    const QString notice = this->notice();
    const bool twice = output == ViewOutput::SideBySide;
    QRect eye = m_scene->geometry();
    eye.setWidth(twice ? eye.width() / 2 : eye.width());
    placeNotice(0, notice, eye);
    placeNotice(1, twice ? notice : QString{}, eye.translated(eye.width(), 0));
    placeAnother();
}

void TraineeWindow::placeNotice(std::size_t place, const QString& notice, const QRect& within)
{
    QLabel& label = *m_notices[place];
    label.setVisible(!notice.isEmpty());
    if (notice.isEmpty())
        return;
    const QMargins margins{kNoticeMargin, kNoticeMargin, kNoticeMargin, kNoticeMargin};
    QRect needed = label.fontMetrics().boundingRect(within - margins,
                                                    Qt::AlignCenter | Qt::TextWordWrap, notice)
                   + margins;
    needed.moveBottom(within.bottom());
    label.setText(notice);
    label.setGeometry(needed);
    // raise() leaves a native window where it is if the widget is the topmost already.
    if (QWindow* window = label.windowHandle())
        window->raise();
}

} // namespace carina
