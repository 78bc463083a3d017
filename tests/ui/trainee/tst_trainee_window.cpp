#include "tests/engine/audio/gain_of.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "tests/ui/trainee/trainee_desk.h"
#include "ui/panels/airway/try_panel.h"
#include "ui/vitals/bedside_monitor_panel.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_view.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>

#include <utility>

namespace carina::trainee_window_test
{
namespace
{

using test::FakeSessionNode;
using test::soon;

/// A window that is shown, and hears its host.
struct Shown : test::TraineeDesk {
    explicit Shown(ViewOutput kind = ViewOutput::Screen) : TraineeDesk{kind}
    {
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        node.advance(std::chrono::seconds{1});
        LinkReport& link = node.linkReports.emplace_back();
        link.state = LinkState::Connected;
        window.resize(1024, 768);
        window.show();
    }
    void loseHost(std::chrono::milliseconds silence)
    {
        node.linkReports.front().state = LinkState::Away;
        node.linkReports.front().sinceLastDatagram = silence;
    }
    [[nodiscard]] QPushButton& another() const
    {
        return *window.findChild<QPushButton*>(QStringLiteral("another"));
    }
};

} // namespace

class TestTraineeWindow : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void offersAnotherSessionWhenThisOneHasEnded()
    {
        Shown shown;
        const QSignalSpy wanted{&shown.window, &TraineeWindow::anotherWanted};
        QVERIFY(!shown.another().isVisible());
        shown.node.decide(fact::PhaseChanged{SessionPhase::Ended});
        shown.node.advance(std::chrono::seconds{1});
        QVERIFY(soon([&] { return shown.another().isVisible(); }));
        QVERIFY(soon([&] {
            return shown.window.notice().contains(QStringLiteral("The session has ended"));
        }));
        shown.another().click();
        QCOMPARE(wanted.count(), 1);
    }

    void keepsTheMiddleOfThePictureFree()
    {
        Shown shown;
        shown.node.decide(fact::PhaseChanged{SessionPhase::Ended});
        shown.node.advance(std::chrono::seconds{1});
        QVERIFY(soon([&] { return shown.another().isVisible(); }));
        const QRect button = shown.another().geometry();
        const QRect window = shown.window.rect();
        QVERIFY(window.contains(button));
        QVERIFY(button.top() > 3 * window.height() / 4);
        int told = 0;
        for (const QLabel* notice :
             shown.window.findChildren<QLabel*>(QString{}, Qt::FindDirectChildrenOnly)) {
            told += notice->isVisible() ? 1 : 0;
            QVERIFY(!notice->isVisible() || !notice->geometry().intersects(button));
        }
        QCOMPARE(told, 1);
    }

    /// It was closed for good, or ended while this program was away.
    void offersAnotherSessionWhileTheHostIsSilent()
    {
        Shown shown;
        const QSignalSpy wanted{&shown.window, &TraineeWindow::anotherWanted};
        shown.loseHost(std::chrono::seconds{6});
        QVERIFY(soon([&] { return shown.another().isVisible(); }));
        QVERIFY(shown.window.notice().contains(QStringLiteral("does not answer")));
        QVERIFY(shown.window.focusWidget() != &shown.another()); // who works on keeps the keyboard
        shown.another().click();
        QCOMPARE(wanted.count(), 1);
        shown.node.linkReports.front() = {};
        shown.node.linkReports.front().state = LinkState::Connected; // it is back
        QVERIFY(soon([&] { return !shown.another().isVisible(); }));
    }

    void offersNothingInAShortGap()
    {
        Shown shown;
        shown.loseHost(std::chrono::seconds{2});
        QVERIFY(soon([&] {
            return shown.window.notice().contains(QStringLiteral("Connecting to the instructor"));
        }));
        QVERIFY(!shown.another().isVisible());
    }

    /// Which lie tabbed outside of the window.
    void tabPassesByPanelsThatAreShut()
    {
        Shown shown;
        shown.node.decide(fact::PhaseChanged{SessionPhase::Ended});
        shown.node.advance(std::chrono::seconds{1});
        QVERIFY(soon([&] { return shown.another().isVisible(); }));
        for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
            shown.another().setFocus();
            QTest::keyClick(&shown.another(), key);
            QVERIFY(!qobject_cast<QTabBar*>(shown.window.focusWidget()));
        }
    }

    /// Who has no tracker turns a headset's picture by mouse; the screen's camera stays.
    void turnsAHeadsetsPictureByMouse()
    {
        Shown shown{ViewOutput::Mono};
        SceneView& scene = shown.window.stationScene().scene();
        QVERIFY(soon([&] { return scene.frame().isHeadSteered; }));
        const auto looks = [&scene]() -> Vec3 {
            const RigidTransform& X_AD = scene.frame().eyes->front().X_AD;
            return X_AD * Vec3{0.0, 0.0, -1.0} - X_AD.translation();
        };
        const Vec3 p_A_mouth = shown.drawn->landmarks().p_A_incisors;
        const Vec3 p_A_eye = scene.frame().eyes->front().X_AD.translation();
        const Vec3 before = looks();
        QVERIFY((p_A_mouth - p_A_eye).normalized().dot(before) > 0.999);
        QVERIFY(shown.window.notice().contains(QStringLiteral("by mouse")));
        Q_EMIT scene.headTurned(0.0, 0.5);
        QVERIFY(soon([&] { return looks().dot(before) < 0.99; }));
        Q_EMIT scene.headReturned();
        QVERIFY(soon([&] { return looks().dot(before) > 0.9999; }));
    }

    /// Beside the picture, and who works on keeps the keyboard.
    void opensTheDebriefingWhenATryHasEnded()
    {
        Shown shown;
        auto* panel = shown.window.findChild<TryPanel*>();
        QVERIFY(!panel->isVisible());
        shown.tries.watch();
        const auto note = [&shown](IntubationStep step) {
            shown.node.decide(fact::IntubationNoted{{.step = step, .at = *shown.node.now()}, {}});
            shown.node.advance(std::chrono::seconds{1});
            shown.tries.watch();
        };
        note(IntubationStep::BladeIn);
        note(IntubationStep::BladeOut);
        QVERIFY(!panel->isVisible());
        shown.node.advance(TryCourse::kOutFor);
        shown.tries.watch();
        QVERIFY(soon([&] { return panel->isVisible(); }));
        QVERIFY(!panel->isAncestorOf(shown.window.focusWidget()));
        const auto* outcome = panel->findChild<QLabel*>(QStringLiteral("tryOutcome"));
        QVERIFY(outcome->text().contains(QStringLiteral("Given up")));
    }

    /// Also while the picture has the keyboard, and without the panel.
    void handlesCuffAndBagByKey()
    {
        Shown shown;
        QApplication::setActiveWindow(&shown.window);
        const auto tubeAndBag = [&shown] {
            const auto state = shown.node.state();
            const auto& there = state->stations().at(FakeSessionNode::kStation).respiration;
            const SessionTime last = SessionTime::max();
            return std::pair{there.tube().cuffInflatedAt(last),
                             there.settingsAt(last).bag.rate > Frequency{}};
        };
        QCOMPARE(tubeAndBag(), (std::pair{false, false}));
        QTest::keyClick(&shown.window, Qt::Key_F7);
        QCOMPARE(tubeAndBag(), (std::pair{true, false}));
        QTest::keyClick(&shown.window, Qt::Key_F9);
        QCOMPARE(tubeAndBag(), (std::pair{true, true}));
        shown.node.advance(std::chrono::seconds{1});
        QVERIFY(soon([&] { return shown.hands.travellingText().isEmpty(); }));
        QTest::keyClick(&shown.window, Qt::Key_F9);
        QTest::keyClick(&shown.window, Qt::Key_F7);
        QCOMPARE(tubeAndBag(), (std::pair{false, false}));
    }

    void soundsWhileTheBedsideMonitorIsOpen()
    {
        Shown shown;
        QApplication::setActiveWindow(&shown.window);
        auto& model = shown.vitals.model();
        const auto isHeard = [&model] {
            return test::gainOf(model.sounds().mixer(), SoundKind::Alarm) > 0.0;
        };
        QVERIFY(!isHeard());
        auto& panel = *shown.window.findChild<BedsideMonitorPanel*>();
        auto& dock = *qobject_cast<QDockWidget*>(panel.parentWidget());
        dock.show();
        QVERIFY(soon(isHeard));
        QTest::keyClick(&shown.window, Qt::Key_F10);
        QVERIFY(model.isMuted() && !isHeard());
        QTest::keyClick(&shown.window, Qt::Key_F10);
        QVERIFY(isHeard());
        dock.hide();
        QVERIFY(soon([&] { return !isHeard(); }));
    }

    void keepsAHeadsetsPictureFree()
    {
        Shown shown{ViewOutput::SideBySide};
        shown.loseHost(std::chrono::seconds{6});
        QVERIFY(soon(
            [&] { return shown.window.notice().contains(QStringLiteral("does not answer")); }));
        bool isDue = false;
        QTimer::singleShot(300, &shown.window, [&isDue] { isDue = true; });
        QVERIFY(soon([&isDue] { return isDue; })); // the window looked
        QVERIFY(!shown.another().isVisible());
    }
};

CARINA_SCREEN_TEST(TestTraineeWindow)

} // namespace carina::trainee_window_test

#include "tst_trainee_window.moc"
