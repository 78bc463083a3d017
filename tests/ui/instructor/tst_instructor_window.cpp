#include "models/airway/airway_groups.h"
#include "models/airway/airway_presets.h"
#include "models/network/network_figures_model.h"
#include "tests/models/lacking_patient.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "tests/ui/instructor/console_desk.h"
#include "ui/instructor/panel_docks.h"
#include "ui/instructor/projector_window.h"
#include "ui/lesson/lesson_scene.h"
#include "ui/panels/airway/try_panel.h"
#include "ui/panels/patient/parts_panel.h"
#include "widgets/checked_spin_box.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_view.h"
#include "widgets/second_press.h"
#include "widgets/theme/dark_theme.h"
#include "widgets/vitals/bedside_monitor.h"
#include "widgets/waveform_plot.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>
#include <QToolBar>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace carina::instructor_window_test
{
namespace
{

using test::ConsoleDesk;
using test::FakeSessionNode;
using test::soon;

constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
constexpr ParticipantId kOlga = FakeSessionNode::kObserver;
constexpr StationId kRoom{1};
constexpr ObjectId kPatient = FakeSessionNode::kPatient;
constexpr ObjectId kLungs{3};
constexpr std::size_t kPanels = 14;
constexpr std::chrono::seconds kDrawn{30}; ///< a frame, by a loaded software renderer

/// One with the same surfaces as the console's.
SharedPatientModel anotherPatient()
{
    static const SharedPatientModel made = [] {
        Anatomy anatomy = builtinPatient(BuiltinPatient::TwelveYears).value();
        anatomy.contentHash = "another";
        return patientOf(std::move(anatomy)).value();
    }();
    return made;
}

/// A console as it is once it was shown and laid out.
struct Shown : ConsoleDesk {
    explicit Shown(const test::ScratchFolder& kept, const QSize& size = {1280, 800},
                   const SharedPatientModel& lying = child())
        : ConsoleDesk{kept, lying}
    {
        window.resize(size);
        window.show();
        window.resize(size); // as the program does
        settle();
    }
    static void settle(std::chrono::milliseconds time = std::chrono::milliseconds{50})
    {
        bool isDue = false;
        QTimer::singleShot(time, qApp, [&isDue] { isDue = true; });
        QVERIFY(soon([&isDue] { return isDue; }));
    }
    /// The picture's share of the window.
    [[nodiscard]] double share()
    {
        const QSize picture = find<SceneView>("scene").size();
        return double(picture.width()) * picture.height()
               / (double(window.width()) * window.height());
    }
    [[nodiscard]] QRect pictureAt()
    {
        const auto& scene = find<SceneView>("scene");
        return {scene.mapTo(&window, QPoint{}), scene.size()};
    }
    /// What lies over the picture's edge and says what needs attention.
    [[nodiscard]] QRect attentionAt()
    {
        const auto& bar = find<QWidget>("attentionBar");
        return bar.isVisible() ? QRect{bar.mapTo(&window, QPoint{}), bar.size()} : QRect{};
    }
    /// Something long to say: much was shown until this console stopped.
    void breakOffALesson()
    {
        node.linkReports = {{kTom, LinkState::Connected, {}, {}, {}},
                            {kOlga, LinkState::Connected, {}, {}, {}}};
        Lesson lesson{{true, LessonCut::All, {0.0, 1.0, 0.0}, 0.1}, true, {}};
        lesson.looks = {{.first = 1, .last = 1, .isHighlighted = true, .isNamed = true},
                        {.first = 2, .last = 2, .style = LessonStyle::Hidden},
                        {.first = 3, .last = 3, .style = LessonStyle::Ghost}};
        node.decide(fact::LessonShown{kNobody, lesson}, FakeSessionNode::kInstructor);
        node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ina"});
        attention.look();
        settle();
    }
    [[nodiscard]] QAction& action(const char* name) { return find<QAction>(name); }
    [[nodiscard]] QDockWidget& dock(const char* name) { return find<QDockWidget>(name); }
    /// Where each button of the bar stands.
    [[nodiscard]] QList<QRect> buttons()
    {
        QList<QRect> places;
        for (const QToolButton* button : find<QToolBar>("sessionBar").findChildren<QToolButton*>())
            if (button->isVisible())
                places += QRect{button->mapTo(&window, QPoint{}), button->size()};
        return places;
    }
    void decide(SessionPhase phase)
    {
        node.decide(fact::PhaseChanged{phase});
        QCoreApplication::sendPostedEvents();
    }
    /// What was done takes effect.
    void takeEffect()
    {
        node.advance(std::chrono::milliseconds{100});
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    /// A second station, with the same patient or another one.
    void addRoom(const SharedPatientModel& patient)
    {
        node.decide(fact::AnatomyChosen{child()->contentHash(), "Child"});
        node.addStation("Room 5");
        node.decideAt(kRoom, fact::AnatomyChosen{patient->contentHash(), "Patient"});
        takeEffect();
    }
    /// And draws its patient, as the program does once that is made.
    void look(StationId station, const SharedPatientModel& patient)
    {
        stations.show(station);
        if (patient.get() != &window.stationScene().patient())
            window.show(*patient, view);
    }
    [[nodiscard]] const SceneSettings& settings() { return find<SceneView>("scene").settings(); }
    void pressUndo()
    {
        QApplication::setActiveWindow(&window); // the display has no window manager
        QTest::keySequence(&window, QKeySequence{QKeySequence::Undo});
        takeEffect();
    }
    /// A panel that floats, in its frame, and has the keyboard.
    [[nodiscard]] QDockWidget& floating(const char* name)
    {
        QDockWidget& panel = dock(name);
        panel.setFloating(true);
        if (!soon([&] { return !panel.windowFlags().testFlag(Qt::FramelessWindowHint); }))
            qFatal("a panel got no frame");
        QApplication::setActiveWindow(&panel); // the display has no window manager
        return panel;
    }
    /// All actions of the console with a key of the window.
    [[nodiscard]] QList<QAction*> withKeys() const
    {
        QList<QAction*> found;
        for (QAction* action : window.findChildren<QAction*>())
            if (!action->shortcut().isEmpty())
                found += action;
        return found;
    }
};

/// Something that a person changes in the console, and how it is.
struct Deed {
    const char* name;
    void (*make)(Shown&);
    QString (*state)(Shown&);
};

QByteArray headingOf(const AirwayGroup& group)
{
    return "airwayGroup_" + QByteArray{group.name.data(), qsizetype(group.name.size())};
}

QString numbered(int value) { return QString::number(value); }

/// One for each place that has changes, and more where it has several kinds.
constexpr std::array kDeeds{
    Deed{"breathing", [](Shown& shown) { shown.breathing.set(BreathingParameter::Rate, 30.0); },
         [](Shown& shown) {
             return numbered(qRound(shown.breathing.value(BreathingParameter::Rate)));
         }},
    Deed{"condition", [](Shown& shown) { shown.respiration.setPosition(BodyPosition::Prone); },
         [](Shown& shown) { return numbered(int(shown.respiration.position())); }},
    Deed{"oxygen",
         [](Shown& shown) {
             shown.gas.setGas({1.0, true, true});
         },
         [](Shown& shown) { return numbered(qRound(100.0 * shown.gas.gas().inspiredOxygen)); }},
    Deed{"a cuff", [](Shown& shown) { shown.gas.setCuff(true); },
         [](Shown& shown) { return numbered(shown.gas.isCuffInflated()); }},
    Deed{"an airway event",
         [](Shown& shown) { shown.airway.setSeverity(AirwayEventKind::Laryngospasm, 0.5); },
         [](Shown& shown) {
             return numbered(qRound(100.0 * shown.airway.severity(AirwayEventKind::Laryngospasm)));
         }},
    Deed{"the head is laid", [](Shown& shown) { shown.head.setPosition(kSniffing); },
         [](Shown& shown) { return numbered(qRound(inDegrees(shown.head.position().flexion))); }},
    Deed{"the patient is turned",
         [](Shown& shown) {
             shown.object.choose(kPatient);
             shown.actions.start();
             shown.node.advance(std::chrono::seconds{1});
             shown.actions.stop();
         },
         [](Shown& shown) {
             shown.object.choose(kPatient);
             return shown.actions.placeText();
         }},
    Deed{"the lungs are lifted out",
         [](Shown& shown) {
             shown.object.choose(kLungs);
             shown.object.lift();
         },
         [](Shown& shown) {
             const auto state = shown.node.state();
             return numbered(state->objects().at(kLungs).owner.value);
         }},
    Deed{"they are given to who asks",
         [](Shown& shown) {
             shown.node.decide(fact::ObjectWanted{kLungs, true}, kTom);
             shown.attention.look();
             const std::vector<Attention> all = shown.attention.all();
             const auto asked = std::ranges::find(all, Concern::Asked, &Attention::concern);
             QVERIFY(asked != all.end());
             shown.attention.act(*asked);
         },
         [](Shown& shown) {
             const auto state = shown.node.state();
             return numbered(state->objects().at(kLungs).owner == kTom);
         }},
    Deed{"a part is highlighted",
         [](Shown& shown) {
             PartLooks looks;
             looks[shown.find<SceneView>("scene").parts().front().id].highlighted = true;
             shown.find<PartsPanel>("parts").put(looks);
         },
         [](Shown& shown) { return numbered(int(shown.find<SceneView>("scene").looks().size())); }},
    Deed{"a cut", [](Shown& shown) { shown.find<QComboBox>("what").setCurrentIndex(2); },
         [](Shown& shown) { return numbered(shown.find<QComboBox>("what").currentIndex()); }},
    Deed{"mute", [](Shown& shown) { shown.conduct.setMuted(kOlga, true); },
         [](Shown& shown) { return numbered(shown.conduct.standingOf(kOlga).isMuted); }},
    Deed{"lock", [](Shown& shown) { shown.conduct.setLocked(true); },
         [](Shown& shown) { return numbered(shown.conduct.isLocked()); }},
    Deed{"a name", [](Shown& shown) { shown.stations.rename(kRoom, QStringLiteral("Hall")); },
         [](Shown& shown) { return shown.stations.nameOf(kRoom); }},
    Deed{"a move", [](Shown& shown) { shown.stations.move(kOlga, kRoom); },
         [](Shown& shown) { return numbered(shown.stations.stationOf(kOlga).value); }},
    Deed{"work is given", [](Shown& shown) { shown.people.giveWork(FakeSessionNode::kInstructor); },
         [](Shown& shown) {
             return numbered(shown.node.state()->atWork(FakeSessionNode::kStation).value);
         }},
    Deed{"a head is placed", [](Shown& shown) { shown.people.place(kTom, PatientSide::Left); },
         [](Shown& shown) {
             const auto state = shown.node.state();
             return numbered(qRound(inDegrees(state->participants().at(kTom).turn)));
         }},
    Deed{"a view is deleted",
         [](Shown& shown) {
             QMenu& menu = *shown.find<QToolButton>("savedViews").menu();
             Q_EMIT menu.aboutToShow();
             menu.actions().last()->menu()->actions().front()->trigger();
         },
         [](Shown& shown) { return numbered(int(shown.keeper.views().size())); }},
    Deed{"a lesson", [](Shown& shown) { shown.lesson.setOn(true); },
         [](Shown& shown) { return numbered(shown.lesson.isOn()); }}};

QStringList statesOf(Shown& shown)
{
    QStringList all;
    for (const Deed& deed : kDeeds)
        all += QString::fromUtf8(deed.name) + QStringLiteral(": ") + deed.state(shown);
    return all;
}

/// The one of a panel's controls by Tab that stands highest.
const QWidget* firstIn(const QScrollArea& area)
{
    const QWidget* first = nullptr;
    const auto topOf = [&area](const QWidget& control) {
        return control.mapTo(area.widget(), QPoint{}).y();
    };
    for (const QWidget* control : area.widget()->findChildren<QWidget*>())
        if ((control->focusPolicy() & Qt::TabFocus) != 0 && control->isVisible()
            && control->isEnabled() && (!first || topOf(*control) < topOf(*first)))
            first = control;
    return first;
}

/// With its first line at least.
bool beginsInSight(const QWidget& control, const QWidget& port)
{
    const QRect place{control.mapTo(&port, QPoint{}), control.size()};
    return place.top() >= 0
           && place.top() + std::min(place.height(), control.fontMetrics().height())
                  <= port.height();
}

/// By one notch towards the user, over the middle of a control. What it ignores goes to its
/// parents, as with a real wheel.
void turnWheel(QWidget& control)
{
    constexpr QPoint kNotch{0, -120};
    const QPointF middle{control.rect().center()};
    QWheelEvent event{middle,         control.mapToGlobal(middle), {},   kNotch, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase,           false};
    for (QWidget* receiver = &control; receiver; receiver = receiver->parentWidget()) {
        event.accept();
        QApplication::sendEvent(receiver, &event);
        if (event.isAccepted())
            return;
    }
}

QString textOf(const QWidget& control)
{
    if (const auto* button = qobject_cast<const QAbstractButton*>(&control))
        return button->text();
    const auto* label = qobject_cast<const QLabel*>(&control);
    return label && label->buddy() ? label->text() : QString{};
}

/// That leads to a control which is in sight; empty where none does.
QString altKeyOf(const QWidget& control)
{
    const QWidget* around = &control;
    while (around && !qobject_cast<const QDockWidget*>(around))
        around = around->parentWidget();
    const bool isBehind = around && !around->isEnabled();
    return control.isVisible() && !isBehind ? QKeySequence::mnemonic(textOf(control)).toString()
                                            : QString{};
}

} // namespace

class TestInstructorWindow : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void initTestCase() { applyDarkTheme(*qApp); }

    void givesThePictureMostOfTheWindow_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("least");
        QTest::newRow("1280x800") << QSize{1280, 800} << 1.0 / 2.0;
        QTest::newRow("1920x1080") << QSize{1920, 1080} << 2.0 / 3.0;
    }
    void givesThePictureMostOfTheWindow()
    {
        QFETCH(const QSize, size);
        QFETCH(const double, least);
        const test::ScratchFolder kept;
        Shown shown{kept, size};
        QCOMPARE(shown.window.size(), size);
        qInfo("the picture has %.3f of the window", shown.share());
        QVERIFY2(shown.share() >= least, qPrintable(QString::number(shown.share())));
        shown.decide(SessionPhase::Running);
        Shown::settle();
        QVERIFY2(shown.share() >= least, qPrintable(QString::number(shown.share())));
    }

    /// Even without what its sentence covers.
    void leavesThePictureItsShareWhereSomethingNeedsAttention_data()
    {
        givesThePictureMostOfTheWindow_data();
    }
    void leavesThePictureItsShareWhereSomethingNeedsAttention()
    {
        QFETCH(const QSize, size);
        QFETCH(const double, least);
        const test::ScratchFolder kept;
        Shown shown{kept, size};
        shown.breakOffALesson();
        const auto& text = shown.find<QLabel>("attention");
        QVERIFY2(text.text().endsWith(QStringLiteral("parts seen through, view")),
                 qPrintable(text.text()));
        QVERIFY(text.height() >= text.heightForWidth(text.width()));
        const QRect covered = shown.attentionAt();
        QVERIFY(!covered.isEmpty());
        QVERIFY(shown.pictureAt().contains(covered));
        const double left =
            shown.share()
            - double(covered.width()) * covered.height() / (double(size.width()) * size.height());
        qInfo("the picture has %.3f of the window beside its sentence", left);
        QVERIFY2(left >= least, qPrintable(QString::number(left)));
    }

    /// Of which one is at the upper edge, as the patient lies.
    void writesNoSideOverWhatNeedsAttention()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.respiration.setPosition(BodyPosition::RightLateral);
        shown.takeEffect();
        shown.find<QToolButton>("front").click();
        shown.breakOffALesson();
        const int bottom = shown.attentionAt().bottom();
        const auto left = [&shown]() -> QRect {
            for (const QLabel* label : shown.find<SceneView>("scene").findChildren<QLabel*>())
                if (label->text() == QStringLiteral("Left") && label->isVisible())
                    return {label->mapTo(&shown.window, QPoint{}), label->size()};
            return {};
        };
        const auto isAbove = [&] { return left().bottom() < shown.pictureAt().center().y(); };
        QVERIFY(soon([&] { return !left().isNull() && isAbove(); }, kDrawn));
        QVERIFY(soon([&] { return left().top() > bottom; }, kDrawn));
    }

    void holdsItsHighestPanelsWithoutScrolling_data()
    {
        QTest::addColumn<QSize>("opened");
        QTest::newRow("opened so") << QSize{1920, 1080};
        QTest::newRow("made larger") << QSize{1280, 800};
    }
    void holdsItsHighestPanelsWithoutScrolling()
    {
        QFETCH(const QSize, opened);
        const test::ScratchFolder kept;
        Shown shown{kept, opened};
        shown.window.resize(1920, 1080);
        Shown::settle();
        for (const char* name :
             {"conditionDock", "gasDock", "airwayDock", "partsDock", "invitationDock"}) {
            QDockWidget& dock = shown.dock(name);
            dock.raise();
            Shown::settle();
            const auto* area = qobject_cast<QScrollArea*>(dock.widget());
            qInfo("%s: %d pixels of %d", name, area->viewport()->height(),
                  area->widget()->height());
            QVERIFY2(area->verticalScrollBar()->maximum() == 0, name);
        }
        QVERIFY(shown.share() >= 2.0 / 3.0);
        shown.dock("airwayDock").raise();
        const auto& airway = *qobject_cast<QScrollArea*>(shown.dock("airwayDock").widget());
        for (const AirwayGroup& group : airwayGroups()) {
            const QByteArray heading = headingOf(group);
            shown.find<QPushButton>(heading.constData()).click();
            Shown::settle();
            QVERIFY2(airway.verticalScrollBar()->maximum() == 0, heading.constData());
        }
    }

    /// Whichever of the groups is chosen, also in the lowest window.
    void holdsAGroupOfTheAirwayWithoutScrolling()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.airway.setEvents(presetNamed("anaphylaxis")->events);
        shown.takeEffect();
        shown.action("showAirway").trigger();
        Shown::settle();
        const auto& view = *qobject_cast<QScrollArea*>(shown.dock("airwayDock").widget());
        for (const AirwayGroup& group : airwayGroups()) {
            const QByteArray heading = headingOf(group);
            shown.find<QPushButton>(heading.constData()).click();
            Shown::settle();
            qInfo("%s: %d pixels of %d", heading.constData(), view.viewport()->height(),
                  view.widget()->minimumSizeHint().height());
            QVERIFY2(view.verticalScrollBar()->maximum() == 0, heading.constData());
        }
    }

    /// And what takes it back, beside the state of the patient.
    void saysWhichPresetIsSetInANarrowWindow()
    {
        const test::ScratchFolder kept;
        Shown shown{kept, {1280, 800}};
        const auto says = [&shown](const QString& text) {
            return soon([&] { return shown.find<QLabel>("status").text().contains(text); });
        };
        shown.airway.setEvents(presetNamed("anaphylaxis")->events);
        shown.takeEffect();
        QVERIFY(says(QStringLiteral("Airway: Anaphylaxis")));
        QVERIFY(
            shown.find<QToolButton>("undoChange").text().endsWith(QStringLiteral("Anaphylaxis")));
        shown.airway.setChangeTime(std::chrono::seconds{600});
        shown.airway.setEvents(presetNamed("pregnant")->events);
        shown.takeEffect();
        shown.takeEffect(); // and is on its way
        QVERIFY(says(QStringLiteral(" more")));
        QVERIFY(says(QStringLiteral("Condition:")));
    }

    /// All numbers, in the lowest window, too.
    void holdsTheBedsideMonitorWithoutScrolling_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280x800") << QSize{1280, 800};
        QTest::newRow("1920x1080") << QSize{1920, 1080};
    }
    void holdsTheBedsideMonitorWithoutScrolling()
    {
        QFETCH(const QSize, size);
        const test::ScratchFolder kept;
        Shown shown{kept, size};
        shown.action("showMonitor").trigger();
        Shown::settle();
        const auto& view = *qobject_cast<QScrollArea*>(shown.dock("monitorDock").widget());
        const auto& monitor = *view.widget()->findChild<BedsideMonitor*>();
        qInfo("the panel has %d pixels of height, its monitor %d", view.viewport()->height(),
              monitor.height());
        QCOMPARE(view.verticalScrollBar()->maximum(), 0);
        QCOMPARE(view.widget()->height(), view.viewport()->height()); // and takes all that there is
    }

    void mutesAllSoundsWhicheverPanelIsInFront()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.action("showWaveforms").trigger();
        Shown::settle();
        auto& button = shown.find<QToolButton>("muteOfConsole");
        QVERIFY(button.isVisible() && button.isEnabled());
        button.click();
        QVERIFY(shown.vitals.model().isMuted());
        QVERIFY(button.text().contains(QStringLiteral("■")));
        QApplication::setActiveWindow(&shown.window); // the display has no window manager
        QTest::keyClick(&shown.window, Qt::Key_F10);
        QVERIFY(!shown.vitals.model().isMuted());
    }

    /// Beside a scroll bar, too, and with everything set and on its way.
    void holdsTheWordsOfTheAirwayInItsColumn()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.action("showAirway").trigger();
        shown.find<QPushButton>("airwayGroup_all").click();
        AirwayEvents all;
        for (int kind = 0; kind < kAirwayEventKinds; ++kind)
            all.push_back({static_cast<AirwayEventKind>(kind), 0.5});
        shown.airway.setChangeTime(std::chrono::seconds{600});
        shown.airway.setEvents(all);
        Shown::settle();
        shown.takeEffect();
        Shown::settle();
        const auto& view = *qobject_cast<QScrollArea*>(shown.dock("airwayDock").widget());
        QVERIFY(view.verticalScrollBar()->maximum() > 0);
        QCOMPARE(view.widget()->width(), view.viewport()->width());
    }

    /// What stands first in a panel, and what has the keyboard, also where it was scrolled.
    void bringsEachPanelFromItsBeginning()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        int scrolled = 0;
        for (QDockWidget* dock : shown.window.findChildren<QDockWidget*>()) {
            PanelDocks::bring(*dock);
            Shown::settle();
            const auto& area = *qobject_cast<QScrollArea*>(dock->widget());
            area.verticalScrollBar()->setValue(area.verticalScrollBar()->maximum());
            scrolled += int(area.verticalScrollBar()->value() > 0);
            PanelDocks::bring(*dock);
            Shown::settle();
            const QByteArray name = dock->objectName().toUtf8();
            for (const QWidget* control :
                 std::array<const QWidget*, 2>{firstIn(area), shown.window.focusWidget()})
                if (control && area.isAncestorOf(control))
                    QVERIFY2(beginsInSight(*control, *area.viewport()),
                             (name + ": " + control->objectName().toUtf8() + ", keyboard "
                              + (shown.window.focusWidget()
                                     ? shown.window.focusWidget()->objectName().toUtf8()
                                     : QByteArray{}))
                                 .constData());
        }
        QVERIFY(scrolled > 0);
    }

    /// Also where the mouse is over a choice, a number or a slider.
    void scrollsAPanelByTheWheel()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        PanelDocks::bring(shown.dock("airwayDock"));
        shown.find<QPushButton>("airwayGroup_all").click();
        Shown::settle();
        QScrollBar& bar =
            *qobject_cast<QScrollArea*>(shown.dock("airwayDock").widget())->verticalScrollBar();
        for (const char* name : {"airwayPreset", "goitre", "goitreSlider"}) {
            auto& control = shown.find<QWidget>(name);
            bar.setValue(0);
            turnWheel(control);
            QVERIFY2(bar.value() > 0, name);
            QVERIFY2(control.focusPolicy() != Qt::WheelFocus, name);
        }
        QVERIFY(shown.airway.events().empty());
        shown.airway.setSeverity(AirwayEventKind::Goitre, 0.5);
        shown.takeEffect();
        auto& goitre = shown.find<CheckedSpinBox>("goitre");
        QApplication::setActiveWindow(&shown.window); // the display has no window manager
        goitre.setFocus();
        turnWheel(goitre);
        QCOMPARE(goitre.value(), 40);
        auto& preset = shown.find<QComboBox>("airwayPreset"); // each step is a decision
        preset.setFocus();
        const int before = preset.currentIndex();
        turnWheel(preset);
        QCOMPARE(preset.currentIndex(), before);
    }

    /// Each choice acts at once: the patient shall not have those that a hand passes.
    void stepsThroughAListThatIsOpenOnly()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        PanelDocks::bring(shown.dock("gasDock"));
        auto& seat = shown.find<QComboBox>("tubeSeat");
        const auto before = shown.node.state()->lastApplied();
        for (const auto key : {Qt::Key_Down, Qt::Key_Up, Qt::Key_PageDown, Qt::Key_End}) {
            QTest::keyClick(&seat, key);
            QVERIFY(test::soon([&] { return seat.view()->isVisible(); }));
            QCOMPARE(seat.currentIndex(), 0);
            seat.hidePopup();
        }
        QTest::keyClick(&seat, Qt::Key_Down);
        QVERIFY(test::soon([&] { return seat.view()->isVisible(); }));
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(seat.view(), Qt::Key_Down);
        QCOMPARE(shown.node.state()->lastApplied(), before);
        QTest::keyClick(seat.view(), Qt::Key_Return);
        QCOMPARE(seat.currentIndex(), 3);
        QVERIFY(shown.node.state()->lastApplied() > before);
    }

    /// It was shown, hidden and is shown again; *Show* brings the keyboard to the row of the tube.
    void tellsAWholeSentenceEachTime()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.node.linkReports = {{kTom, LinkState::Connected, {}, {}, {}},
                                  {kOlga, LinkState::Connected, {}, {}, {}}};
        shown.decide(SessionPhase::Running);
        shown.takeEffect();
        const auto look = [&] {
            shown.node.advance(std::chrono::seconds{1});
            shown.takeEffect();
            shown.attention.look();
            Shown::settle();
        };
        shown.node.decide(fact::IntubationNoted{{.step = IntubationStep::InOesophagus,
                                                 .at = *shown.node.now(),
                                                 .seat = TubeSeat::Oesophagus},
                                                {}});
        look();
        const auto& text = shown.find<QLabel>("attention");
        for (int round = 0; round < 3; ++round) {
            QVERIFY(text.isVisible());
            QVERIFY2(text.width() >= text.fontMetrics().horizontalAdvance(text.text()),
                     qPrintable(QString::number(text.width())));
            shown.node.decide(fact::TubePlaced{{TubeSeat::Trachea, millimetres(6.5)}});
            look();
            QVERIFY2(!text.isVisible(), qPrintable(text.text()));
            shown.node.decide(fact::TubePlaced{});
            look();
        }
        QApplication::setActiveWindow(&shown.window); // the display has no window manager
        shown.find<QPushButton>("attend").click();
        QVERIFY(shown.find<QComboBox>("tubeSeat").hasFocus());
    }

    /// Of a point that was lost, among the steps beneath the patient.
    void leadsFromTheReportToTheMoment()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.decide(SessionPhase::Running);
        std::vector<SessionTime> noted;
        for (const auto step : {IntubationStep::BladeIn, IntubationStep::TubePastTeeth,
                                IntubationStep::ThroughCords}) {
            shown.node.advance(std::chrono::seconds{2});
            noted.push_back(*shown.node.now());
            shown.node.decide(fact::IntubationNoted{.event = {.step = step, .at = noted.back()}});
        }
        shown.takeEffect();
        QVERIFY(shown.find<QLabel>("tryPoints").textInteractionFlags()
                & Qt::LinksAccessibleByKeyboard); // they are links, see TestTryPanel
        Q_EMIT shown.find<TryPanel>("tries").momentAsked(noted[1]);
        const auto& steps = shown.find<QListView>("intubation");
        QCOMPARE(steps.currentIndex().row(), 1);
    }

    /// And what leads to the strategies.
    void keepsTheDriftInSight()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        PathReport path;
        path.peer = kTom;
        path.traffic = TrafficReport{};
        path.external = ExternalVerdict{};
        shown.node.pathReports = {path};
        shown.node.reports = {{FakeSessionNode::kTube, std::chrono::milliseconds{21}, 0.14, 0.8}};
        shown.node.announce();
        shown.action("showNetwork").trigger();
        Shown::settle();
        QDockWidget& dock = shown.dock("networkDock");
        const QWidget& port = *qobject_cast<QScrollArea*>(dock.widget())->viewport();
        const auto& table = *dock.findChild<QTableView*>();
        const auto& research = shown.find<QPushButton>("research");
        int drifts = 0;
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            const QModelIndex what = table.model()->index(row, NetworkFiguresModel::What);
            if (!what.data().toString().contains(QStringLiteral("drift (limit)")))
                continue;
            const QRect place = table.visualRect(what);
            QVERIFY(table.viewport()->rect().contains(place));
            QVERIFY(table.viewport()->mapTo(&port, place.bottomLeft()).y() < port.height());
            ++drifts;
        }
        QCOMPARE(drifts, 1);
        QVERIFY(research.mapTo(&port, QPoint{0, research.height()}).y() <= port.height());
    }

    /// In the next session, too.
    void remembersWhichEventsOfTheAirwayAreInSight()
    {
        const test::ScratchFolder kept;
        {
            Shown shown{kept};
            shown.action("showAirway").trigger();
            shown.find<QPushButton>("airwayGroup_larynx").click();
        }
        Shown again{kept};
        again.action("showAirway").trigger();
        Shown::settle();
        QVERIFY(again.find<QPushButton>("airwayGroup_larynx").isChecked());
        QVERIFY(again.find<CheckedSpinBox>("laryngospasm").isVisible());
        QVERIFY(!again.find<CheckedSpinBox>("tongue_oedema").isVisible());
    }

    void namesEachPanelWhole_data() { givesThePictureMostOfTheWindow_data(); }
    void namesEachPanelWhole()
    {
        QFETCH(const QSize, size);
        const test::ScratchFolder kept;
        Shown shown{kept, size};
        int tabs = 0;
        for (const QTabBar* bar :
             shown.window.findChildren<QTabBar*>(QString{}, Qt::FindDirectChildrenOnly)) {
            for (int tab = 0; tab < bar->count(); ++tab) {
                const QString name = bar->tabText(tab);
                const QRect place = bar->tabRect(tab);
                QVERIFY2(bar->rect().contains(place), qPrintable(name));
                // With what is left free beside it; less is an ellipsis.
                QVERIFY2(place.width() >= bar->fontMetrics().horizontalAdvance(name) + 10,
                         qPrintable(name));
            }
            tabs += bar->isVisible() ? bar->count() : 0;
        }
        QVERIFY(tabs >= 7);
        for (const QRect& button : shown.buttons())
            QVERIFY(shown.window.rect().contains(button));
        QCOMPARE(shown.buttons().size(), 9); // none is behind an arrow
    }

    void namesTwoStationsWhole()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.node.addStation("Room 2");
        shown.takeEffect();
        Shown::settle();
        const auto& tabs = shown.find<QTabBar>("stations");
        QVERIFY(tabs.isVisible());
        QCOMPARE(tabs.count(), 2);
        QCOMPARE(tabs.tabText(0), QStringLiteral("Station 1: 3 here"));
        QCOMPARE(tabs.tabText(1), QStringLiteral("Room 2: 0 here"));
        for (int tab = 0; tab < tabs.count(); ++tab)
            QVERIFY(tabs.rect().contains(tabs.tabRect(tab)));
    }

    void keepsStatesOfParticipantsInSight()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const auto table = [&shown]() -> const QTableView& {
            return shown.find<QTableView>("table");
        };
        shown.node.linkReports = {{kTom, LinkState::Connected, {}, {}, {}},
                                  {kOlga, LinkState::Connected, {}, {}, {}}};
        shown.node.pathReports.push_back(
            {.peer = kTom, .meanDelay = std::chrono::milliseconds{40}});
        shown.node.decide(
            fact::ParticipantJoined{{}, Role::Trainee, "Maximiliane-Charlotte von Hohenlohe-Abcd"});
        shown.takeEffect();
        shown.dock("participantsDock").raise();
        Shown::settle();
        const auto isInSight = [&table](int column) {
            return table().columnViewportPosition(column) + table().columnWidth(column)
                   <= table().viewport()->width();
        };
        const int last = shown.participants.rowCount() - 1;
        QVERIFY(soon([&] {
            return isInSight(ParticipantsModel::State) && isInSight(ParticipantsModel::Delay)
                   && isInSight(ParticipantsModel::Same)
                   && table().rowHeight(last) > table().rowHeight(0);
        }));
    }

    /// In a window in which the panel is scrolled.
    void keepsTheTimesOfItsCurvesInSightWhileTheyAreMeasured()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.decide(SessionPhase::Running);
        QDockWidget& dock = shown.dock("waveformDock");
        dock.raise();
        Shown::settle();
        for (int i = 0; i < 300; ++i) {
            shown.node.advance(std::chrono::milliseconds{20});
            shown.trace.sample();
        }
        shown.find<QToolButton>("freeze").click();
        const QList<WaveformPlot*> plots = dock.findChildren<WaveformPlot*>();
        QCOMPARE(plots.size(), 3);
        for (const double share : {0.36, 0.46}) { // of which there are values
            const QRectF frame = plots[0]->drawing().frame;
            QTest::mouseClick(plots[0], Qt::LeftButton, {},
                              {int(frame.left() + share * frame.width()), 30});
        }
        Shown::settle();
        QVERIFY(shown.find<QLabel>("measured").text().contains(QStringLiteral("between")));
        const QWidget& view = *qobject_cast<QScrollArea*>(dock.widget())->viewport();
        for (const WaveformPlot* plot : plots)
            QVERIFY(plot->mapTo(&view, QPoint{0, plot->height()}).y() <= view.height());
    }

    void bringsAClosedPanelBackByItsKey()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        QDockWidget& network = shown.dock("networkDock");
        network.close();
        QVERIFY(network.isHidden());
        shown.action("showNetwork").trigger();
        QVERIFY(!network.isHidden());
        QVERIFY(network.isEnabled());
    }

    void laysAllPanelsAsAtFirst()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.dock("networkDock").close();
        shown.dock("breathingDock").setFloating(true);
        shown.window.addDockWidget(Qt::RightDockWidgetArea, &shown.dock("partsDock"));
        shown.action("standardLayout").trigger();
        Shown::settle();
        for (const QDockWidget* dock : shown.window.findChildren<QDockWidget*>()) {
            QVERIFY2(!dock->isHidden() && !dock->isFloating(), qPrintable(dock->objectName()));
            QCOMPARE(shown.window.dockWidgetArea(const_cast<QDockWidget*>(dock)),
                     Qt::LeftDockWidgetArea);
        }
        QVERIFY(shown.share() >= 0.5);
    }

    void canCloseMoveAndFloatEachPanel()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const auto docks = shown.window.findChildren<QDockWidget*>();
        QCOMPARE(std::size_t(docks.size()), kPanels);
        std::set<QString> keys;
        for (QDockWidget* dock : docks)
            QCOMPARE(dock->features(), QDockWidget::DockWidgetClosable
                                           | QDockWidget::DockWidgetMovable
                                           | QDockWidget::DockWidgetFloatable);
        for (const QAction* action : shown.find<QToolButton>("panels").menu()->actions())
            if (!action->shortcut().isEmpty())
                QVERIFY(keys.insert(action->shortcut().toString()).second);
        QVERIFY(keys.size() >= kPanels + 2);
    }

    void floatsAPanelWithAFrame()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        QDockWidget& waveforms = shown.dock("waveformDock");
        waveforms.setFloating(true);
        QVERIFY(soon([&] { return !waveforms.windowFlags().testFlag(Qt::FramelessWindowHint); }));
        QVERIFY(waveforms.windowFlags().testFlag(Qt::WindowTitleHint));
        QVERIFY(waveforms.windowFlags().testFlag(Qt::WindowMaximizeButtonHint));
        QVERIFY(waveforms.windowFlags().testFlag(Qt::WindowCloseButtonHint));
        QVERIFY(waveforms.isVisible());
        QVERIFY(waveforms.isFloating());
    }

    /// A window of its own, in which keys of the main window do nothing by themselves.
    void undoesFromAPanelThatFloats()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        QDockWidget& panel = shown.floating("breathingDock");
        auto& volume = shown.find<CheckedSpinBox>("tidalVolume");
        QCOMPARE(volume.window(), static_cast<QWidget*>(&panel));
        const int before = volume.value();
        volume.setValue(before + 100);
        shown.takeEffect();
        const auto inForce = [&shown] {
            return qRound(shown.breathing.value(BreathingParameter::TidalVolume));
        };
        QCOMPARE(inForce(), before + 100);
        QCOMPARE(QApplication::activeWindow(), static_cast<QWidget*>(&panel));
        QTest::keySequence(&volume, QKeySequence{QKeySequence::Undo});
        shown.takeEffect();
        QCOMPARE(inForce(), before);
        QCOMPARE(volume.value(), before);
    }

    void bringsAndClosesPanelsFromOneThatFloats()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        QDockWidget& network = shown.dock("networkDock");
        network.close();
        QDockWidget& panel = shown.floating("breathingDock");
        QTest::keyClick(&panel, Qt::Key_N, Qt::ControlModifier);
        QVERIFY(!network.isHidden());
        QApplication::setActiveWindow(&panel);
        shown.find<CheckedSpinBox>("tidalVolume").setFocus();
        QTest::keyClick(&panel, Qt::Key_F4, Qt::ControlModifier);
        QVERIFY(panel.isHidden());
        QVERIFY(!network.isHidden());
    }

    void hasEveryKeyInAPanelThatFloats()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const QList<QAction*> keys = shown.withKeys();
        QVERIFY(std::size_t(keys.size()) >= kPanels + 7); // session, windows, close and undo
        for (const QDockWidget* dock : shown.window.findChildren<QDockWidget*>())
            for (QAction* action : keys)
                QVERIFY2(dock->actions().contains(action),
                         qPrintable(dock->objectName() + QLatin1Char{' '}
                                    + action->shortcut().toString()));
    }

    void remembersThePanels()
    {
        const test::ScratchFolder kept;
        {
            Shown shown{kept};
            shown.dock("networkDock").close();
            shown.dock("waveformDock").setFloating(true);
            shown.window.addDockWidget(Qt::RightDockWidgetArea, &shown.dock("partsDock"));
            shown.window.close();
        }
        Shown again{kept};
        QVERIFY(again.dock("networkDock").isHidden());
        QVERIFY(again.dock("waveformDock").isFloating());
        QVERIFY(again.dock("waveformDock").isVisible());
        QCOMPARE(again.window.dockWidgetArea(&again.dock("partsDock")), Qt::RightDockWidgetArea);
    }

    /// Some time before the end, which a console that is killed does not see.
    void remembersThePanelsWhileItRuns()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const KeptConsole keeper{kept.path()};
        QVERIFY(soon([&] { return !keeper.panels().isEmpty(); })); // as they were at first
        const QByteArray before = keeper.panels();
        shown.dock("networkDock").close();
        shown.dock("waveformDock").setFloating(true);
        QVERIFY(soon([&] { return keeper.panels() != before; }));
        Shown again{kept};
        QVERIFY(again.dock("networkDock").isHidden());
        QVERIFY(again.dock("waveformDock").isFloating());
    }

    void remembersWhereAPanelFloats()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        QDockWidget& panel = shown.floating("waveformDock");
        const KeptConsole keeper{kept.path()};
        QVERIFY(soon([&] { return !keeper.panels().isEmpty(); }));
        const QByteArray before = keeper.panels();
        panel.move(panel.pos() + QPoint{40, 30});
        QVERIFY(soon([&] { return keeper.panels() != before; }));
    }

    void keepsItsButtonsWhereTheyAre()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const QList<QRect> before = shown.buttons();
        for (const SessionPhase phase : {SessionPhase::Running, SessionPhase::Paused}) {
            shown.decide(phase);
            shown.node.advance(std::chrono::minutes{101});
            Shown::settle();
            QCOMPARE(shown.buttons(), before);
        }
        shown.action("end").trigger(); // asks
        Shown::settle();
        QCOMPARE(shown.action("end").text(), QStringLiteral("Really end?"));
        QCOMPARE(shown.buttons(), before);
    }

    /// Pressed once more, it would be the button that ends the session.
    void keepsTheKeyboardAtStartAndPause()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const auto button = [&shown](const char* name) {
            return shown.find<QToolBar>("sessionBar").widgetForAction(&shown.action(name));
        };
        const auto press = [&](const char* pressed, const char* next) {
            QCOMPARE(shown.window.focusWidget(), button(pressed));
            QTest::keyClick(button(pressed), Qt::Key_Space);
            QCOMPARE(shown.window.focusWidget(), button(pressed)); // until it takes effect
            shown.node.advance(std::chrono::seconds{1});
            QVERIFY(soon([&] { return shown.action(next).isEnabled(); }));
            QVERIFY(!shown.action(pressed).isEnabled());
            QCOMPARE(shown.window.focusWidget(), button(next));
        };
        button("start")->setFocus();
        press("start", "pause");
        press("pause", "start");
    }

    void endsOnlyByASecondPressAfterAPause()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.decide(SessionPhase::Running);
        QAction& end = shown.action("end");
        QVERIFY(!end.autoRepeat());
        const auto phase = [&shown] {
            shown.node.advance(std::chrono::seconds{1}); // what was decided takes effect
            return shown.session.phase();
        };
        QCOMPARE(phase(), SessionPhase::Running);
        QTest::mouseDClick(shown.find<QToolBar>("sessionBar").widgetForAction(&end),
                           Qt::LeftButton);
        end.trigger(); // as a key that is held
        Shown::settle();
        QCOMPARE(phase(), SessionPhase::Running);
        Shown::settle(SecondPress::kLeastPause + std::chrono::milliseconds{200});
        end.trigger();
        Shown::settle();
        QCOMPARE(phase(), SessionPhase::Ended);
    }

    void saysWhatNeedsAttentionWithoutMovingThePicture()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.node.linkReports = {{kTom, LinkState::Connected, {}, {}, {}},
                                  {FakeSessionNode::kObserver, LinkState::Connected, {}, {}, {}}};
        shown.attention.look();
        Shown::settle();
        auto& text = shown.find<QLabel>("attention");
        QVERIFY(!text.isVisible());
        const QRect before = shown.pictureAt();
        shown.node.linkReports[0].state = LinkState::Away;
        shown.attention.look();
        Shown::settle();
        QVERIFY(text.isVisible());
        QVERIFY(text.text().startsWith(QStringLiteral("▲ Tom is away")));
        QCOMPARE(shown.pictureAt(), before);
    }

    /// To a person who starts a console again that stopped.
    void showsAgainWhatBrokeOff()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.node.linkReports = {{kTom, LinkState::Connected, {}, {}, {}},
                                  {FakeSessionNode::kObserver, LinkState::Connected, {}, {}, {}}};
        auto& scene = shown.find<SceneView>("scene");
        auto& what = shown.find<QComboBox>("what");
        scene.setLooks({{scene.parts().front().id, {.highlighted = true}}});
        what.setCurrentIndex(2);
        shown.find<QSlider>("slider").setValue(40);
        const SceneSettings settings = scene.settings();
        Lesson lesson = lessonOf(settings);
        lesson.showsView = true;
        shown.node.decide(fact::LessonShown{kTom, lesson}, FakeSessionNode::kInstructor);
        shown.node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ina"});
        scene.setLooks({}); // it begins as usual
        what.setCurrentIndex(0);
        shown.find<QSlider>("slider").setValue(70);
        shown.attention.look();
        const auto& text = shown.find<QLabel>("attention");
        QVERIFY2(text.accessibleName().startsWith(QStringLiteral("Shown to Tom until")),
                 qPrintable(text.accessibleName()));
        shown.find<QPushButton>("attend").click();
        const auto isShown = [&shown, &lesson] {
            const auto state = shown.node.state();
            const auto& now = state->stations().at(FakeSessionNode::kStation).lesson;
            return now && now->to == kTom && now->lesson == lesson;
        };
        QVERIFY(isShown());
        QVERIFY(scene.settings() == settings);
        shown.node.advance(std::chrono::seconds{1});
        Shown::settle(); // from now on the picture is followed
        QVERIFY(isShown());
        shown.attention.look();
        QVERIFY(shown.attention.all().empty());
    }

    void keepsPartsAndCutOfEachStation_data()
    {
        QTest::addColumn<bool>("isAnother");
        QTest::newRow("the same patient") << false;
        QTest::newRow("another patient") << true;
    }
    void keepsPartsAndCutOfEachStation()
    {
        QFETCH(const bool, isAnother);
        const SharedPatientModel other = isAnother ? anotherPatient() : ConsoleDesk::child();
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.addRoom(other);
        auto& what = shown.find<QComboBox>("what");
        auto& parts = shown.find<PartsPanel>("parts");
        const std::uint16_t first = shown.find<SceneView>("scene").parts().front().id;
        const QString name =
            QString::fromStdString(shown.find<SceneView>("scene").parts().front().name);
        parts.put({{first, {.highlighted = true}}});
        parts.choose(first);
        what.setCurrentIndex(2);
        shown.find<QSlider>("slider").setValue(40);
        const SceneSettings before = shown.settings();
        shown.look(kRoom, other);
        QVERIFY(shown.settings() == SceneSettings{});
        QVERIFY(parts.chosenName().isEmpty());
        what.setCurrentIndex(1);
        const SceneSettings inRoom = shown.settings();
        shown.look(FakeSessionNode::kStation, ConsoleDesk::child());
        QVERIFY(shown.settings() == before);
        QCOMPARE(what.currentIndex(), 2);
        QCOMPARE(shown.find<QSlider>("slider").value(), 40);
        QCOMPARE(parts.chosenName(), name);
        shown.look(kRoom, other);
        QVERIFY(shown.settings() == inRoom);
    }

    /// Each at its station, whichever is drawn.
    void takesBackPartsAndCutOfAnotherStation()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.addRoom(anotherPatient());
        auto& what = shown.find<QComboBox>("what");
        auto& parts = shown.find<PartsPanel>("parts");
        what.setCurrentIndex(2);
        parts.put({{shown.find<SceneView>("scene").parts().front().id, {.highlighted = true}}});
        shown.look(kRoom, anotherPatient());
        what.setCurrentIndex(1);
        const SceneSettings inRoom = shown.settings();
        QVERIFY(inRoom.section);
        what.setCurrentIndex(0);
        shown.pressUndo();
        QVERIFY(shown.settings() == inRoom);
        shown.pressUndo();
        shown.pressUndo();
        shown.pressUndo();
        QVERIFY(shown.settings() == SceneSettings{});
        QVERIFY(!shown.find<QToolButton>("undoChange").isEnabled());
        shown.look(FakeSessionNode::kStation, ConsoleDesk::child());
        QVERIFY(shown.settings() == SceneSettings{});
        QCOMPARE(what.currentIndex(), 0);
    }

    /// Not even while the picture is of the other station's patient.
    void showsOnTheSameAfterAGlanceAtAnotherStation()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        QObject::connect(&shown.stations, &StationsModel::shownChanged, &shown.lesson,
                         &LessonModel::setStation);
        shown.addRoom(anotherPatient());
        const auto isFollowed = [&shown] {
            shown.node.advance(std::chrono::seconds{1});
            Shown::settle();
            const auto state = shown.node.state();
            return state->stations().at(FakeSessionNode::kStation).lesson;
        };
        shown.find<QComboBox>("what").setCurrentIndex(2);
        shown.lesson.setTarget(kTom);
        shown.lesson.setOn(true);
        const auto before = isFollowed();
        QVERIFY(before && before->to == kTom && before->lesson.section.isCut);
        shown.stations.show(kRoom);
        QVERIFY(isFollowed() == before);
        shown.look(kRoom, anotherPatient());
        QVERIFY(isFollowed() == before);
        shown.stations.show(FakeSessionNode::kStation);
        QVERIFY(shown.lesson.isOn());
        QVERIFY(isFollowed() == before);
        shown.look(FakeSessionNode::kStation, ConsoleDesk::child());
        QVERIFY(isFollowed() == before);
        shown.find<QComboBox>("what").setCurrentIndex(0);
        QVERIFY(!isFollowed()->lesson.section.isCut);
    }

    /// And says so, and leaves the picture as it is.
    void showsNothingAgainThatCannotBeShown()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.find<QComboBox>("what").setCurrentIndex(2);
        const SceneSettings settings = shown.find<SceneView>("scene").settings();
        Attention matter;
        matter.concern = Concern::BrokenOff;
        matter.station = FakeSessionNode::kStation;
        Q_EMIT shown.attention.showWanted(matter);
        QVERIFY(shown.find<QStatusBar>("statusBar")
                    .currentMessage()
                    .startsWith(QStringLiteral("Not shown yet")));
        QVERIFY(shown.find<SceneView>("scene").settings() == settings);
    }

    void showsWhoIsMeant()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.dock("participantsDock").close();
        Attention matter;
        matter.concern = Concern::Away;
        matter.participant = kTom;
        Q_EMIT shown.attention.showWanted(matter);
        QVERIFY(!shown.dock("participantsDock").isHidden());
        const auto& table = shown.find<QTableView>("table");
        QCOMPARE(table.currentIndex().data(ParticipantsModel::kIdRole).toUInt(), uint{kTom.value});
        matter.concern = Concern::Developing;
        matter.station = FakeSessionNode::kStation;
        Q_EMIT shown.attention.showWanted(matter);
        QVERIFY(shown.dock("conditionDock").isEnabled()); // in front
    }

    void showsTheToolsOfItsTracker()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.action("showTracker").trigger();
        QDockWidget& dock = shown.dock("trackerDock");
        QVERIFY(dock.isEnabled()); // in front
        auto& tools = shown.find<QTableWidget>("toolTable");
        QCOMPARE(shown.window.focusWidget(),
                 static_cast<QWidget*>(&shown.find<QPushButton>("connectTracker")));
        QCOMPARE(tools.rowCount(), 0);
        QCOMPARE(dock.findChild<QLabel*>(QStringLiteral("trouble"))->text(),
                 QStringLiteral("This program has no tracker."));
        shown.sight = TrackerSight{{}, {{.name = QStringLiteral("Tube"), .isVisible = true}}};
        QVERIFY(soon([&] { return tools.rowCount() == 1; }));
        QCOMPARE(tools.item(0, 0)->text(), QStringLiteral("Tube"));
        dock.close(); // and the matter leads back to it
        Attention matter;
        matter.concern = Concern::Unseen;
        matter.participant = shown.node.self();
        Q_EMIT shown.attention.showWanted(matter);
        QVERIFY(!dock.isHidden());
    }

    void asksForATracker()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.action("showTracker").trigger();
        const QSignalSpy wanted{&shown.window, &InstructorWindow::trackerWanted};
        const QSignalSpy unwanted{&shown.window, &InstructorWindow::trackerUnwanted};
        shown.find<QPushButton>("connectTracker").click();
        QVERIFY(soon([&] { return wanted.size() == 1; }));
        shown.sight = TrackerSight{};
        QVERIFY(soon([&] { return shown.find<QPushButton>("withoutTracker").isEnabled(); }));
        shown.find<QPushButton>("withoutTracker").click();
        QCOMPARE(unwanted.size(), 1);
        Attention matter;
        matter.concern = Concern::Tracker;
        Q_EMIT shown.attention.showWanted(matter);
        QVERIFY(soon([&] { return wanted.size() == 2; }));
    }

    void hasEachKeyOfTheMenuOnce()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        std::set<QString> keys;
        for (const QAction* action : shown.find<QToolButton>("panels").menu()->actions())
            if (!action->isSeparator())
                QVERIFY2(keys.insert(QKeySequence::mnemonic(action->text()).toString()).second,
                         qPrintable(action->text()));
    }

    void hasASecondWindowWithTheSamePicture()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        QAction& wanted = shown.action("projectorShown");
        wanted.setChecked(true);
        const auto projector = [] {
            for (QWidget* window : QApplication::topLevelWidgets())
                if (auto* found = qobject_cast<ProjectorWindow*>(window))
                    return found;
            return static_cast<ProjectorWindow*>(nullptr);
        };
        QVERIFY(projector());
        auto& picture = *projector()->findChild<SceneView*>();
        QVERIFY(soon([&] { return picture.statistics().frames > 2; }));
        shown.find<QToolButton>("rightSide").click();
        const auto seenFrom = [](const SceneView& scene) {
            const CameraPose pose = scene.camera().pose();
            return Vec3{(pose.p_A_eye - pose.p_A_target).normalized()};
        };
        const Vec3 side = seenFrom(shown.find<SceneView>("scene"));
        QVERIFY(soon([&] { return seenFrom(picture).dot(side) > 0.999; }));
        projector()->close();
        QVERIFY(soon([&] { return !projector(); }));
        QVERIFY(!wanted.isChecked());
        wanted.setChecked(true);
        shown.window.close();
        QVERIFY(soon([&] { return !projector(); }));
    }

    void refusesAMotionThatIsOutOfRange()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        auto& motion = shown.find<CheckedDoubleSpinBox>("exaggeration");
        motion.selectAll();
        QTest::keyClicks(&motion, QStringLiteral("30"));
        QTest::keyClick(&motion, Qt::Key_Return);
        QCOMPARE(motion.value(), 1.0);
        const QString told = shown.find<QStatusBar>("statusBar").currentMessage();
        QVERIFY2(told.contains(QStringLiteral("30")), qPrintable(told));
    }

    void saysThatItsOwnToolsAreTracked()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const auto& status = shown.find<QLabel>("status");
        const QString nothing = QStringLiteral("Nothing is tracked");
        QVERIFY(soon([&] { return status.accessibleName().contains(nothing); }));
        shown.sight = TrackerSight{.tools = {{.name = QStringLiteral("Tube"), .isVisible = true},
                                             {.name = QStringLiteral("Stylus")}}};
        const QString own = QStringLiteral("Own tools tracked: 1");
        QVERIFY(soon([&] { return status.accessibleName().contains(own); }));
        QVERIFY(!status.accessibleName().contains(nothing));
    }

    /// Also while those that were ended go slowly.
    void tellsEventsOfTheAirwayUntilTheyAreGone()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const auto& status = shown.find<QLabel>("status");
        const auto isTold = [&](int severity) {
            const QString told = QStringLiteral("● Airway: Laryngospasm %1\u00a0%").arg(severity);
            return soon([&] { return status.accessibleName().contains(told); });
        };
        shown.airway.setSeverity(AirwayEventKind::Laryngospasm, 1.0);
        shown.takeEffect();
        QVERIFY(isTold(100));
        shown.airway.setChangeTime(std::chrono::seconds{600});
        shown.airway.clear();
        shown.takeEffect();
        shown.node.advance(std::chrono::seconds{60});
        QVERIFY(shown.airway.events().empty());
        QVERIFY(isTold(90));
    }

    /// 35 degrees where incisors and glottis are 79 mm apart, so 22 where it is 50.
    void tellsHowTheHeadOfAnInfantIsDrawn()
    {
        Anatomy anatomy = builtinPatient(BuiltinPatient::TwelveYears).value();
        AirwayLandmarks& at = anatomy.landmarks;
        at.p_A_incisors = at.p_A_glottis + 0.05 * (at.p_A_incisors - at.p_A_glottis).normalized();
        anatomy.contentHash = "an infant's way";
        const test::ScratchFolder kept;
        Shown shown{kept, {1280, 800}, patientOf(std::move(anatomy)).value()};
        shown.head.setPosition(kSniffing);
        shown.takeEffect();
        const auto& status = shown.find<QLabel>("status");
        const QString told = QStringLiteral("● Head position: neck 22° flexed, head 24° extended "
                                            "(this patient's neck flexes no farther)");
        QVERIFY(soon([&] { return status.accessibleName().contains(told); }));
    }

    void saysThatMotionIsShownLarger()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        const auto& status = shown.find<QLabel>("status");
        const QString told = QStringLiteral("▲ breathing shown 2.5 times as large as it is");
        QVERIFY(!status.accessibleName().contains(told));
        shown.find<CheckedDoubleSpinBox>("exaggeration").setValue(2.5);
        QVERIFY(soon([&] { return status.accessibleName().contains(told); }));
    }

    void hasEachAltKeyOnce_data()
    {
        QTest::addColumn<QByteArray>("change");
        QTest::addColumn<QByteArray>("people");
        for (const char* change : {"breathingDock", "conditionDock", "gasDock", "airwayDock",
                                   "actionsDock", "partsDock", "trackerDock"})
            for (const char* people : {"waveformDock", "laryngoscopeDock", "monitorDock", "tryDock",
                                       "participantsDock", "invitationDock", "networkDock"})
                QTest::addRow("%s and %s", change, people)
                    << QByteArray{change} << QByteArray{people};
    }
    // Whatever is in front, and whether or not a control can be used just then.
    void hasEachAltKeyOnce()
    {
        QFETCH(const QByteArray, change);
        QFETCH(const QByteArray, people);
        const test::ScratchFolder kept;
        Shown shown{kept};
        shown.node.sharePatient(FakeSessionNode::kInstructor);
        shown.decide(SessionPhase::Running);
        for (const QByteArray& dock : {change, people})
            shown.dock(dock.constData()).raise();
        Shown::settle();
        for (const QByteArray& dock : {change, people})
            QVERIFY2(shown.dock(dock.constData()).isEnabled(), dock.constData());
        QMap<QString, QStringList> keys;
        for (const QWidget* control : shown.window.findChildren<QWidget*>())
            if (const QString key = altKeyOf(*control); !key.isEmpty())
                keys[key] += control->objectName() + QLatin1Char{' '} + textOf(*control);
        QVERIFY(keys.size() > 5);
        for (const auto& [key, controls] : keys.toStdMap())
            QVERIFY2(controls.size() == 1,
                     qPrintable(key + QStringLiteral(": ") + controls.join(QStringLiteral(", "))
                                + QStringLiteral("; in use: ")
                                + QStringList{keys.keys()}.join(QLatin1Char{' '})));
    }

    /// The last first, whichever panel it was in.
    void takesBackByOneKeyWhatWasChangedAnywhere()
    {
        const test::ScratchFolder kept;
        KeptConsole{kept.path()}.keepViews(
            {{QStringLiteral("Above"), {0.0, -0.4, 1.9}, {0.0, 0.0, 1.3}, {0.0, 0.0, 1.0}}});
        Shown shown{kept};
        shown.node.sharePatient(FakeSessionNode::kInstructor);
        shown.node.decide(fact::ObjectShared{{}, kNobody, ObjectKind::OrganGroup, "lungs"});
        shown.node.decide(fact::ObjectShared{{}, kTom, ObjectKind::Head, "Head"});
        shown.node.addStation("Room 5");
        shown.takeEffect();
        const auto& undo = shown.find<QToolButton>("undoChange");
        QVERIFY(!undo.isEnabled());
        std::vector<QStringList> states;
        for (const Deed& deed : kDeeds) {
            states.push_back(statesOf(shown));
            deed.make(shown);
            shown.takeEffect();
            QVERIFY2(statesOf(shown) != states.back(), deed.name);
        }
        for (auto before = states.rbegin(); before != states.rend(); ++before) {
            QVERIFY(undo.isEnabled());
            shown.pressUndo();
            QCOMPARE(statesOf(shown), *before);
        }
        QVERIFY(!undo.isEnabled()); // nothing is left
        QVERIFY(!shown.node.refusal());
    }

    /// As long as it is the station's.
    void saysWhatThePatientCannotShowOfTheAirway()
    {
        const test::ScratchFolder kept;
        const SharedPatientModel tongueless = test::childWithout(PartRole::Tongue);
        Shown shown{kept, {1280, 800}, tongueless};
        shown.action("showAirway").trigger();
        Shown::settle();
        const auto& why = shown.find<QLabel>("tongue_oedemaNotShown");
        QVERIFY(why.isVisible());
        QVERIFY(why.text().contains(QStringLiteral("no tongue")));
        shown.node.decide(fact::AnatomyChosen{ConsoleDesk::child()->contentHash(), "Child"});
        shown.takeEffect();
        QVERIFY(!why.isVisible());
        shown.node.decide(fact::AnatomyChosen{tongueless->contentHash(), "Tongueless"});
        shown.takeEffect();
        QVERIFY(why.isVisible());
    }

    void goesFullScreenAndBack()
    {
        const test::ScratchFolder kept;
        Shown shown{kept};
        QAction& full = shown.action("fullScreen");
        QCOMPARE(full.shortcut(), QKeySequence{Qt::Key_F11});
        full.trigger();
        QVERIFY(shown.window.isFullScreen());
        full.trigger();
        QVERIFY(!shown.window.isFullScreen());
    }

    void comesBackToASavedView()
    {
        const test::ScratchFolder kept;
        KeptConsole keeper{kept.path()};
        keeper.keepViews(
            {{QStringLiteral("From & above"), {0.0, -0.4, 1.9}, {0.0, 0.0, 1.3}, {0.0, 0.0, 1.0}}});
        Shown shown{kept};
        QMenu& menu = *shown.find<QToolButton>("savedViews").menu();
        Q_EMIT menu.aboutToShow();
        QCOMPARE(menu.actions().front()->text(), QStringLiteral("From && above"));
        menu.actions().front()->trigger();
        const CameraPose pose = shown.find<SceneView>("scene").camera().pose();
        QVERIFY((pose.p_A_eye - Vec3{0.0, -0.4, 1.9}).norm() < 1e-9);
    }
};

CARINA_SCREEN_TEST(TestInstructorWindow)

} // namespace carina::instructor_window_test

#include "tst_instructor_window.moc"
