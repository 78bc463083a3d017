#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/patient/actions_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

namespace carina::actions_panel_test
{

using test::FakeSessionNode;

class TestActionsPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turnsThePatientByItsControls();
    void goesOnByKeyboardAlone();
    void hasNoAxisForScaling();
    void showsEachSpeedInItsUnit();
    void keepsTheSpeedThatIsBeingTyped();
    void refusesASpeedWithItsRange();
    void givesItToWhomIsChosen();
    void keepsTheChosenHeirWhileOthersCome();
    void asksAndTakesTheWishBack();
    void letsOnlyAnInstructorTakeOver();
    void showsAnObserverASentenceInstead();
    void liftsMovesUndoesAndPutsBackByItsControls();
    void liftsByKeyboardAlone();
    void namesEveryControlForAScreenReader();
};

namespace
{

using std::chrono::seconds;

constexpr ObjectId kPatient = FakeSessionNode::kPatient;

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    SharedObjectModel object{session, FakeSessionNode::kStation};
    ObjectActionModel model{object};
    ActionsPanel panel;

    explicit Desk(ParticipantId self, ParticipantId owner = FakeSessionNode::kTrainee) : node{self}
    {
        node.sharePatient(owner);
        panel.setModel(model);
        panel.show();
        QApplication::setActiveWindow(&panel); // the display has no window manager
    }
    template <class Widget> [[nodiscard]] Widget& find(const char* name) const
    {
        return *panel.findChild<Widget*>(QLatin1String{name});
    }
    [[nodiscard]] QPushButton& button(const char* name) const { return find<QPushButton>(name); }
    [[nodiscard]] QString words(const char* name) const { return find<QLabel>(name).text(); }
    /// What another did becomes known.
    void deliver()
    {
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    /// The lungs can be lifted out, too.
    void shareLungs()
    {
        node.decide(fact::ObjectShared{{}, kNobody, ObjectKind::OrganGroup, "lungs"});
        QCoreApplication::sendPostedEvents();
    }
    void choose(const char* box, int place)
    {
        auto& combo = find<QComboBox>(box);
        combo.setFocus();
        QTest::keyClick(&combo, Qt::Key_Home);
        for (int i = 0; i < place; ++i)
            QTest::keyClick(&combo, Qt::Key_Down);
    }
};

} // namespace

void TestActionsPanel::turnsThePatientByItsControls()
{
    Desk desk{FakeSessionNode::kTrainee};
    QCOMPARE(desk.words("owner"), QStringLiteral("● you"));
    QVERIFY(desk.button("begin").isEnabled());
    QVERIFY(!desk.button("stop").isEnabled() && !desk.button("reset").isEnabled());
    desk.choose("axis", 1);
    desk.find<QDoubleSpinBox>("speed").setValue(45.0);
    desk.button("begin").click();
    QCOMPARE(desk.words("motion"), QStringLiteral("● Turns about y at 45.0 °/s"));
    QVERIFY(!desk.button("begin").isEnabled() && desk.button("stop").isEnabled());
    desk.node.advance(seconds{2});
    desk.button("stop").click();
    QCOMPARE(desk.words("motion"), QStringLiteral("■ At rest"));
    QCOMPARE(
        desk.words("place"),
        QStringLiteral(
            "▲ Away from its original place: turned 90.0°, moved 0.0\u00a0mm, size 100.0\u00a0%"));
    desk.button("reset").click();
    QCOMPARE(desk.words("place"), QStringLiteral("In its original place"));
    QVERIFY(!desk.button("reset").isEnabled());
}

void TestActionsPanel::goesOnByKeyboardAlone()
{
    Desk desk{FakeSessionNode::kTrainee};
    desk.panel.setFocus();
    QCOMPARE(QApplication::focusWidget(), &desk.find<QComboBox>("object"));
    QStringList path;
    for (int i = 0; i < 8; ++i) {
        path << QApplication::focusWidget()->objectName();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    const QStringList first{QStringLiteral("object"), QStringLiteral("handOver"),
                            QStringLiteral("heir"),   QStringLiteral("kind"),
                            QStringLiteral("axis"),   QStringLiteral("speed"),
                            QStringLiteral("begin"),  QStringLiteral("object")};
    QCOMPARE(path, first); // what does nothing now is passed by
    desk.button("begin").setFocus();
    QTest::keyClick(&desk.button("begin"), Qt::Key_Space);
    desk.node.advance(seconds{1});
    QCOMPARE(QApplication::focusWidget(), &desk.button("stop"));
    QTest::keyClick(&desk.button("stop"), Qt::Key_Space);
    QCOMPARE(QApplication::focusWidget(), &desk.button("reset"));
    QTest::keyClick(&desk.button("reset"), Qt::Key_Space);
    QVERIFY(desk.model.isInPlace());
}

void TestActionsPanel::hasNoAxisForScaling()
{
    Desk desk{FakeSessionNode::kTrainee};
    QVERIFY(desk.find<QComboBox>("axis").isEnabled());
    desk.choose("kind", 2);
    QVERIFY(!desk.find<QComboBox>("axis").isEnabled());
    desk.choose("kind", 1);
    QVERIFY(desk.find<QComboBox>("axis").isEnabled());
}

void TestActionsPanel::showsEachSpeedInItsUnit()
{
    Desk desk{FakeSessionNode::kTrainee};
    const auto& speed = desk.find<QDoubleSpinBox>("speed");
    QCOMPARE(speed.text(), QStringLiteral("30.0 °/s"));
    desk.choose("kind", 1);
    QCOMPARE(speed.text(), QStringLiteral("10.0 mm/s"));
    QCOMPARE(speed.maximum(), 200.0);
    desk.choose("kind", 2);
    QCOMPARE(speed.text(), QStringLiteral("10.0 %/s"));
    QCOMPARE(speed.minimum(), -50.0);
}

void TestActionsPanel::keepsTheSpeedThatIsBeingTyped()
{
    Desk desk{FakeSessionNode::kTrainee};
    desk.button("begin").click();
    auto& speed = desk.find<QDoubleSpinBox>("speed");
    speed.setFocus();
    speed.selectAll();
    QTest::keyClicks(&speed, QStringLiteral("4"));
    desk.node.advance(seconds{1});
    Q_EMIT desk.model.changed(); // it goes on turning
    QTest::keyClicks(&speed, QStringLiteral("5"));
    Q_EMIT desk.model.changed();
    QVERIFY2(speed.text().startsWith(QStringLiteral("45")), qPrintable(speed.text()));
    QTest::keyClick(&speed, Qt::Key_Return);
    QCOMPARE(desk.model.speed(), 45.0);
}

// It was 72.
void TestActionsPanel::refusesASpeedWithItsRange()
{
    Desk desk{FakeSessionNode::kTrainee};
    auto& speed = desk.find<QDoubleSpinBox>("speed");
    const double before = desk.model.speed();
    speed.setFocus();
    speed.selectAll();
    QTest::keyClicks(&speed, QStringLiteral("720"));
    QTest::keyClick(&speed, Qt::Key_Return);
    QCOMPARE(desk.model.speed(), before);
    QCOMPARE(speed.value(), before);
    QVERIFY(desk.find<QLabel>("refused").isVisible());
    QVERIFY(desk.words("refused").contains(QStringLiteral("720")));
    QVERIFY(desk.words("refused").contains(QStringLiteral("360")));
}

void TestActionsPanel::givesItToWhomIsChosen()
{
    Desk desk{FakeSessionNode::kTrainee};
    desk.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tess"});
    desk.node.decide(fact::ObjectWanted{kPatient}, ParticipantId{4});
    desk.deliver();
    desk.choose("heir", 0); // before Ina, who did not ask
    desk.button("handOver").click();
    desk.deliver();
    QCOMPARE(desk.words("owner"), QStringLiteral("◆ Tess"));
    QVERIFY(!desk.button("handOver").isEnabled() && !desk.button("begin").isEnabled());
}

void TestActionsPanel::keepsTheChosenHeirWhileOthersCome()
{
    Desk desk{FakeSessionNode::kTrainee};
    desk.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tess"});
    desk.deliver();
    desk.choose("heir", 0);
    desk.node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ivo"});
    desk.node.decide(fact::ObjectWanted{kPatient}, ParticipantId{4});
    desk.deliver();
    QCOMPARE(desk.find<QComboBox>("heir").count(), 3);
    QCOMPARE(desk.find<QComboBox>("heir").itemText(0), QStringLiteral("Tess"));
    QCOMPARE(desk.find<QComboBox>("heir").currentText(), QStringLiteral("Ina"));
}

void TestActionsPanel::asksAndTakesTheWishBack()
{
    Desk desk{FakeSessionNode::kTrainee, FakeSessionNode::kInstructor};
    QCOMPARE(desk.button("ask").text(), QStringLiteral("A&sk for it"));
    desk.button("ask").click();
    desk.deliver();
    QCOMPARE(desk.words("wish"), QStringLiteral("Asking for it: you"));
    desk.button("ask").click();
    desk.deliver();
    QVERIFY(desk.words("wish").isEmpty());
}

void TestActionsPanel::letsOnlyAnInstructorTakeOver()
{
    QVERIFY(!Desk{FakeSessionNode::kTrainee}.button("takeOver").isVisible());
    Desk desk{FakeSessionNode::kInstructor};
    QVERIFY(desk.button("takeOver").isVisible() && desk.button("takeOver").isEnabled());
    QVERIFY(!desk.button("begin").isEnabled());
    desk.button("takeOver").click();
    desk.deliver();
    QVERIFY(!desk.button("takeOver").isEnabled() && desk.button("begin").isEnabled());
}

void TestActionsPanel::showsAnObserverASentenceInstead()
{
    const Desk desk{FakeSessionNode::kObserver};
    QVERIFY(desk.find<QLabel>("obstacle").isVisible());
    QVERIFY(desk.words("obstacle").startsWith(QStringLiteral("Observers cannot move anything.")));
    for (const QWidget* control : desk.find<QWidget>("controls").findChildren<QWidget*>())
        QVERIFY(!control->isVisible());
    QVERIFY(!Desk{FakeSessionNode::kTrainee}.find<QLabel>("obstacle").isVisible());
}

void TestActionsPanel::liftsMovesUndoesAndPutsBackByItsControls()
{
    Desk desk{FakeSessionNode::kTrainee};
    QVERIFY(!desk.button("lift").isEnabled()); // the patient has no place to be lifted out of
    desk.shareLungs();
    desk.choose("object", 1);
    QVERIFY(desk.button("lift").isEnabled());
    QVERIFY(!desk.button("putBack").isEnabled() && !desk.button("begin").isEnabled());
    desk.button("lift").click();
    desk.deliver();
    QCOMPARE(desk.words("owner"), QStringLiteral("● you"));
    QVERIFY(!desk.button("lift").isEnabled() && desk.button("putBack").isEnabled());
    desk.find<QDoubleSpinBox>("speed").setValue(45.0);
    desk.button("begin").click();
    desk.node.advance(seconds{2});
    desk.button("stop").click();
    QVERIFY(desk.words("place").contains(QStringLiteral("turned 90.0°")));
    QVERIFY(desk.button("undoAction").isEnabled());
    desk.button("undoAction").click();
    QCOMPARE(desk.words("place"), QStringLiteral("In its original place"));
    QVERIFY(!desk.button("undoAction").isEnabled());
    desk.button("putBack").click();
    desk.deliver();
    QCOMPARE(desk.words("owner"), QStringLiteral("○ nobody: in its place"));
    desk.button("lift").click();
    desk.deliver();
    QVERIFY(desk.button("putAllBack").isEnabled());
    desk.button("putAllBack").click();
    desk.deliver();
    QVERIFY(!desk.button("putAllBack").isEnabled());
    QCOMPARE(desk.words("owner"), QStringLiteral("○ nobody: in its place"));
}

void TestActionsPanel::liftsByKeyboardAlone()
{
    Desk desk{FakeSessionNode::kTrainee};
    desk.shareLungs();
    desk.choose("object", 1);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), &desk.button("lift"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    desk.deliver();
    QCOMPARE(QApplication::focusWidget(), &desk.button("putBack"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    desk.deliver();
    QCOMPARE(desk.words("owner"), QStringLiteral("○ nobody: in its place"));
    QVERIFY(QApplication::focusWidget() && QApplication::focusWidget()->isEnabled());
}

void TestActionsPanel::namesEveryControlForAScreenReader()
{
    const Desk desk{FakeSessionNode::kInstructor};
    for (const QPushButton* button : desk.panel.findChildren<QPushButton*>()) {
        QVERIFY2(!button->text().isEmpty(), qPrintable(button->objectName()));
        QVERIFY2(!button->toolTip().isEmpty(), qPrintable(button->objectName()));
    }
    for (const char* name : {"object", "heir", "kind", "axis", "speed", "owner", "motion", "place"})
        QVERIFY2(!desk.find<QWidget>(name).accessibleName().isEmpty(), name);
}

CARINA_SCREEN_TEST(TestActionsPanel)

} // namespace carina::actions_panel_test

#include "tst_actions_panel.moc"
