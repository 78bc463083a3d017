#include "engine/io/anatomy_set/anatomy_cache.h"
#include "tests/ui/access/control_walk.h"
#include "tests/ui/instructor/console_desk.h"
#include "tests/ui/trainee/trainee_desk.h"
#include "ui/start/end_page.h"
#include "ui/start/start_page.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/theme/dark_theme.h"

#include <QDockWidget>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace carina::every_control_test
{
namespace
{

using test::awaitLayout;
using test::ConsoleDesk;
using test::FakeSessionNode;
using test::faultsOfControls;
using test::namesUsedTwice;
using test::soon;
using test::verifyControls;

constexpr std::array kChange{"breathingDock", "conditionDock", "gasDock",    "airwayDock",
                             "actionsDock",   "partsDock",     "trackerDock"};
constexpr std::array kPeople{"waveformDock", "monitorDock", "participantsDock", "invitationDock",
                             "networkDock"};
constexpr std::array kLookedAt{"laryngoscopeDock", "tryDock"}; ///< beside the others

/// While a patient is ventilated that can be moved.
void runSession(ConsoleDesk& desk)
{
    desk.node.sharePatient(FakeSessionNode::kInstructor);
    desk.node.decide(fact::PhaseChanged{SessionPhase::Running});
    VentilatorSettings ventilator;
    ventilator.mode = VentilationMode::VolumeControl;
    desk.node.decide(fact::VentilatorSet{ventilator});
    desk.window.resize(1280, 800);
    desk.window.show();
    awaitLayout();
}

/// The panels of a trainee's window that have controls, by their titles.
void nameTraineesPanels()
{
    QTest::addColumn<QString>("panel");
    for (const char* title :
         {"Actions", "Parts", "Tracker", "Laryngoscope", "Bedside monitor", "Hands"})
        QTest::newRow(title) << QString::fromLatin1(title);
}

/// In its own window where the output is a headset's.
QDockWidget& shownPanel(test::TraineeDesk& desk, const QString& title)
{
    desk.node.sharePatient(FakeSessionNode::kTrainee);
    desk.window.resize(1280, 800);
    desk.window.show();
    awaitLayout();
    const auto docks = desk.window.findChildren<QDockWidget*>();
    QDockWidget& dock = **std::ranges::find(docks, title, &QDockWidget::windowTitle);
    dock.show();
    dock.raise();
    awaitLayout();
    return dock;
}

} // namespace

/// Each control of each window has a name, and is reached by the keyboard.
class TestEveryControl : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void initTestCase() { applyDarkTheme(*qApp); }

    void findsWhatHasNoName()
    {
        QWidget window;
        auto* named = new QLineEdit{&window};
        named->setAccessibleName(QStringLiteral("Name"));
        auto* out = new QComboBox{&window};
        out->setObjectName(QStringLiteral("planted"));
        out->setFocusPolicy(Qt::ClickFocus);
        window.show();
        QCOMPARE(faultsOfControls(window),
                 (QStringList{QStringLiteral("QComboBox planted has no name"),
                              QStringLiteral("QComboBox planted is not reached by Tab")}));
    }

    void ofTheStartPage()
    {
        const test::ScratchFolder folder;
        folder.write("session-20260102-101112-000.sqlite", "no database");
        StoredSessionsModel stored{folder.path()};
        PlannedPatient patient{AnatomyCache::defaultFolder()};
        StartPage page{
            stored,
            patient,
            {.name = QStringLiteral("Ward 3"), .patient = QStringLiteral("child")},
            [](const QString&, const PatientModel*) { return std::vector<ReadyLine>{}; }};
        page.show();
        QVERIFY(soon([&] { return stored.isComplete() && patient.patient().has_value(); },
                     std::chrono::seconds{60}));
        QVERIFY(page.findChild<QAbstractItemView*>(QStringLiteral("earlier"))->isVisible());
        verifyControls(page);
    }

    void ofTheEndPage()
    {
        EndPage page{{{QStringLiteral("Session"), QStringLiteral("Ward 3")}}};
        page.show();
        verifyControls(page);
    }

    void ofTheConsole_data()
    {
        QTest::addColumn<QByteArray>("change");
        QTest::addColumn<QByteArray>("people");
        for (const char* change : kChange)
            for (const char* people : kPeople)
                QTest::addRow("%s and %s", change, people)
                    << QByteArray{change} << QByteArray{people};
        for (const char* lookedAt : kLookedAt)
            QTest::addRow("%s", lookedAt) << QByteArray{kChange[0]} << QByteArray{lookedAt};
    }
    void ofTheConsole()
    {
        QFETCH(const QByteArray, change);
        QFETCH(const QByteArray, people);
        const test::ScratchFolder kept;
        ConsoleDesk desk{kept};
        runSession(desk);
        for (const QByteArray& dock : {change, people})
            desk.find<QDockWidget>(dock.constData()).raise();
        awaitLayout();
        verifyControls(desk.window);
    }

    void hasANameOfItsOwn()
    {
        const test::ScratchFolder kept;
        ConsoleDesk console{kept};
        const QStringList twice = namesUsedTwice(console.window);
        QVERIFY2(twice.isEmpty(), qPrintable(twice.join(u' ')));
        test::TraineeDesk trainee;
        const QStringList twiceThere = namesUsedTwice(trainee.window);
        QVERIFY2(twiceThere.isEmpty(), qPrintable(twiceThere.join(u' ')));
    }

    void ofTheConsoleWhereTwoMattersNeedAttention()
    {
        const test::ScratchFolder kept;
        ConsoleDesk desk{kept};
        desk.node.linkReports = {{FakeSessionNode::kTrainee, LinkState::Away, {}, {}, {}},
                                 {FakeSessionNode::kObserver, LinkState::Away, {}, {}, {}}};
        runSession(desk);
        desk.attention.look();
        awaitLayout();
        QVERIFY(desk.find<QPushButton>("attend").isVisible());
        QVERIFY(desk.find<QToolButton>("moreAttention").isVisible());
        verifyControls(desk.window);
    }

    void ofAPanelThatFloats_data()
    {
        QTest::addColumn<QByteArray>("panel");
        for (const char* panel : kChange)
            QTest::newRow(panel) << QByteArray{panel};
        for (const char* panel : kPeople)
            QTest::newRow(panel) << QByteArray{panel};
    }
    void ofAPanelThatFloats()
    {
        QFETCH(const QByteArray, panel);
        const test::ScratchFolder kept;
        ConsoleDesk desk{kept};
        runSession(desk);
        auto& dock = desk.find<QDockWidget>(panel.constData());
        dock.raise(); // only what is in front can be taken out by hand
        awaitLayout();
        dock.setFloating(true);
        awaitLayout();
        QVERIFY(dock.isWindow() && dock.isEnabled());
        verifyControls(dock);
    }

    void ofTheTraineesWindow_data() { nameTraineesPanels(); }
    void ofTheTraineesWindow()
    {
        QFETCH(const QString, panel);
        test::TraineeDesk desk;
        shownPanel(desk, panel);
        verifyControls(desk.window);
    }

    void ofTheTraineesPanelBesideAHeadset_data() { nameTraineesPanels(); }
    void ofTheTraineesPanelBesideAHeadset()
    {
        QFETCH(const QString, panel);
        test::TraineeDesk desk{ViewOutput::Mono};
        QDockWidget& dock = shownPanel(desk, panel);
        QVERIFY(dock.isWindow() && dock.isEnabled());
        verifyControls(dock);
    }
};

CARINA_SCREEN_TEST(TestEveryControl)

} // namespace carina::every_control_test

#include "tst_every_control.moc"
