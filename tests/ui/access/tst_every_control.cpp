#include "engine/io/anatomy_set/anatomy_cache.h"
#include "tests/support/soon.h"
#include "tests/ui/access/control_walk.h"
#include "tests/ui/instructor/console_desk.h"
#include "tests/ui/trainee/trainee_desk.h"
#include "ui/start/end_page.h"
#include "ui/start/start_page.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/theme/dark_theme.h"

#include <QDockWidget>

namespace carina::every_control_test
{
namespace
{

using test::ConsoleDesk;
using test::FakeSessionNode;
using test::faultsOfControls;
using test::soon;

void settle()
{
    bool isDue = false;
    QTimer::singleShot(50, qApp, [&isDue] { isDue = true; });
    QVERIFY(soon([&isDue] { return isDue; }));
}

void verifyControls(QWidget& window)
{
    const QStringList faults = faultsOfControls(window);
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char{'\n'})));
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
        for (const char* change :
             {"breathingDock", "conditionDock", "actionsDock", "partsDock", "trackerDock"})
            for (const char* people :
                 {"waveformDock", "participantsDock", "invitationDock", "networkDock"})
                QTest::addRow("%s and %s", change, people)
                    << QByteArray{change} << QByteArray{people};
    }
    void ofTheConsole()
    {
        QFETCH(const QByteArray, change);
        QFETCH(const QByteArray, people);
        const test::ScratchFolder kept;
        ConsoleDesk desk{kept};
        desk.node.sharePatient(FakeSessionNode::kInstructor);
        desk.node.decide(fact::PhaseChanged{SessionPhase::Running});
        VentilatorSettings ventilator;
        ventilator.mode = VentilationMode::VolumeControl;
        desk.node.decide(fact::VentilatorSet{ventilator});
        desk.window.resize(1280, 800);
        desk.window.show();
        settle();
        for (const QByteArray& dock : {change, people})
            desk.find<QDockWidget>(dock.constData()).raise();
        settle();
        verifyControls(desk.window);
    }

    void ofTheTraineesWindow_data()
    {
        QTest::addColumn<int>("panel");
        QTest::newRow("actions") << 0;
        QTest::newRow("parts") << 1;
        QTest::newRow("tracker") << 2;
    }
    void ofTheTraineesWindow()
    {
        QFETCH(const int, panel);
        test::TraineeDesk desk;
        desk.node.sharePatient(FakeSessionNode::kTrainee);
        desk.window.resize(1280, 800);
        desk.window.show();
        settle();
        QDockWidget* dock = desk.window.findChildren<QDockWidget*>().at(panel);
        dock->show();
        dock->raise();
        settle();
        verifyControls(desk.window);
    }
};

CARINA_SCREEN_TEST(TestEveryControl)

} // namespace carina::every_control_test

#include "tst_every_control.moc"
