#include "models/respiration/breathing_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/breathing/breathing_panel.h"
#include "ui/panels/session/undo_button.h"
#include "widgets/checked_spin_box.h"

namespace carina::undo_button_test
{

using test::FakeSessionNode;

class TestUndoButton : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesAndTakesBack();
    void leavesRoomBesideALongText();
    void listsTheHistory();
    void takesBackFromWithinANumberBox();
};

void TestUndoButton::namesAndTakesBack()
{
    ChangeHistory history;
    UndoButton button{history};
    QVERIFY(!button.isEnabled());
    int taken = 0;
    history.add(button, QStringLiteral("PEEP → 8 cmH2O"), [&taken] { ++taken; });
    QVERIFY(button.isEnabled());
    QVERIFY(button.text().contains(QStringLiteral("PEEP → 8 cmH2O")));
    QCOMPARE(button.accessibleName(), QStringLiteral("Undo: PEEP → 8 cmH2O"));
    button.click();
    QCOMPARE(taken, 1);
    QVERIFY(!button.isEnabled());
}

/// The line of a console 1280 pixels wide says more beside it than what it takes back.
void TestUndoButton::leavesRoomBesideALongText()
{
    constexpr int kMost = 400; // pixels
    ChangeHistory history;
    UndoButton button{history};
    const QString change =
        QStringLiteral("Airway → ") + QStringLiteral("Tongue oedema 50 % + ").repeated(8);
    history.add(button, change, [] {});
    QVERIFY(button.sizeHint().width() <= kMost);
    QVERIFY(button.text().startsWith(QStringLiteral("Undo: Airway → Tongue oedema 50 %")));
    QCOMPARE(button.accessibleName(), QStringLiteral("Undo: ") + change);
    QVERIFY(button.toolTip().contains(change));
}

void TestUndoButton::listsTheHistory()
{
    ChangeHistory history;
    UndoButton button{history};
    QStringList taken;
    for (const char* name : {"first", "second", "third"}) {
        const QString text = QString::fromLatin1(name);
        history.add(button, text, [&taken, text] { taken << text; });
    }
    Q_EMIT button.menu()->aboutToShow();
    const QList<QAction*> actions = button.menu()->actions();
    QCOMPARE(actions.size(), 3);
    QCOMPARE(actions[0]->text(), QStringLiteral("third"));
    actions[1]->trigger();
    QCOMPARE(taken, (QStringList{QStringLiteral("third"), QStringLiteral("second")}));
    QCOMPARE(history.texts(), QStringList{QStringLiteral("first")});
}

void TestUndoButton::takesBackFromWithinANumberBox()
{
    FakeSessionNode node;
    SessionModel session{node};
    BreathingModel breathing{session, FakeSessionNode::kStation};
    ChangeHistory history;
    breathing.setHistory(history);
    QWidget window;
    auto* panel = new BreathingPanel{&window};
    panel->setModel(breathing);
    new UndoButton{history, &window};
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    auto& volume = *panel->findChild<CheckedSpinBox*>(QStringLiteral("tidalVolume"));
    const int before = volume.value();
    const auto settle = [&node] {
        node.advance(std::chrono::milliseconds{100});
        node.announce();
        QCoreApplication::sendPostedEvents();
    };
    volume.setFocus();
    volume.selectAll();
    QTest::keyClicks(&volume, QStringLiteral("400"));
    QTest::keyClick(&volume, Qt::Key_Return);
    settle();
    QCOMPARE(qRound(breathing.value(BreathingParameter::TidalVolume)), 400);
    QTest::keySequence(&volume, QKeySequence{QKeySequence::Undo});
    settle();
    QCOMPARE(qRound(breathing.value(BreathingParameter::TidalVolume)), before);
    QCOMPARE(volume.value(), before);
    QVERIFY(history.isEmpty());
    volume.clearFocus(); // proposes nothing more
    settle();
    QVERIFY(history.isEmpty());
}

CARINA_SCREEN_TEST(TestUndoButton)

} // namespace carina::undo_button_test

#include "tst_undo_button.moc"
