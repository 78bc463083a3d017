#include "models/physiology/hands_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/breathing/hands_panel.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QToolButton>

#include <set>

namespace carina::hands_panel_test
{

using test::FakeSessionNode;

/// The trainee's controls of cuff, stylet and bag.
class TestHandsPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void inflatesAndDeflatesTheCuffByKeyboardAlone();
    void drawsAStyletThatIsThere();
    void squeezesTheBagAndLetsItGo();
    void saysWhoSqueezesTheBagInstead();
    void changesNothingForAnObserver();
    void givesEachActionAKeyAndANameOfItsOwn();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    HandsModel model{session, FakeSessionNode::kStation};
    HandsPanel panel;

    explicit Desk(ParticipantId self = FakeSessionNode::kTrainee) : node{self}
    {
        panel.setModel(model);
        panel.show();
        QApplication::setActiveWindow(&panel); // the display has no window manager
    }
    void settle()
    {
        node.advance(kLead);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] QAction& action(const char* name) const
    {
        return *panel.findChild<QAction*>(QLatin1String{name});
    }
    [[nodiscard]] QToolButton& buttonOf(const char* name) const
    {
        for (auto* button : panel.findChildren<QToolButton*>())
            if (button->defaultAction() == &action(name))
                return *button;
        qFatal("no button of %s", name);
    }
    void press(const char* name)
    {
        QToolButton& button = buttonOf(name);
        button.setFocus();
        QTest::keyClick(&button, Qt::Key_Space);
        settle();
    }
    [[nodiscard]] QString obstacle() const
    {
        const auto& label = *panel.findChild<QLabel*>(QStringLiteral("handsObstacle"));
        return label.isVisible() ? label.text() : QString{};
    }
};

} // namespace

void TestHandsPanel::inflatesAndDeflatesTheCuffByKeyboardAlone()
{
    Desk desk;
    QCOMPARE(desk.buttonOf("handsCuff").text(), QStringLiteral("Inflate the cuff"));
    desk.press("handsCuff");
    QVERIFY(desk.model.isCuffInflated());
    QCOMPARE(desk.buttonOf("handsCuff").text(), QStringLiteral("Deflate the cuff"));
    desk.press("handsCuff");
    QVERIFY(!desk.model.isCuffInflated());
}

void TestHandsPanel::drawsAStyletThatIsThere()
{
    Desk desk;
    QVERIFY(!desk.action("handsStylet").isEnabled());
    desk.node.decide(fact::IntubationNoted{
        {.step = IntubationStep::TubePastTeeth, .at = *desk.node.now()}, millimetres(6.5)});
    desk.settle();
    QVERIFY(desk.action("handsStylet").isEnabled());
    desk.press("handsStylet");
    QVERIFY(!desk.model.hasStylet());
    QVERIFY(!desk.action("handsStylet").isEnabled());
}

void TestHandsPanel::squeezesTheBagAndLetsItGo()
{
    Desk desk;
    desk.press("handsBag");
    QVERIFY(desk.model.isBagSqueezed());
    QVERIFY(desk.buttonOf("handsBag").isChecked());
    desk.press("handsBag");
    QVERIFY(!desk.model.isBagSqueezed());
    QVERIFY(!desk.buttonOf("handsBag").isChecked());
    desk.node.decide(fact::BagSqueezed{{perMinute(12.0), millilitres(300.0)}},
                     FakeSessionNode::kInstructor);
    desk.settle();
    QVERIFY(desk.buttonOf("handsBag").isChecked());
}

void TestHandsPanel::saysWhoSqueezesTheBagInstead()
{
    Desk desk;
    QVERIFY(desk.obstacle().isEmpty());
    desk.node.decide(fact::WorkTaken{FakeSessionNode::kInstructor, FakeSessionNode::kTrainee});
    desk.settle();
    QCOMPARE(desk.obstacle(), QStringLiteral("Ina is at work here and squeezes the bag."));
    QVERIFY(!desk.action("handsBag").isEnabled());
    QVERIFY(desk.action("handsCuff").isEnabled());
}

void TestHandsPanel::changesNothingForAnObserver()
{
    Desk desk{FakeSessionNode::kObserver};
    const int before = desk.node.proposed;
    QVERIFY(!desk.obstacle().isEmpty());
    for (QAction* action : desk.panel.handActions()) {
        QVERIFY(!action->isEnabled());
        action->trigger();
    }
    QCOMPARE(desk.node.proposed, before);
}

void TestHandsPanel::givesEachActionAKeyAndANameOfItsOwn()
{
    const Desk desk;
    std::set<QString> keys;
    std::set<QString> names;
    for (const QAction* action : desk.panel.handActions()) {
        keys.insert(action->shortcut().toString());
        names.insert(action->text());
        QVERIFY(action->toolTip().contains(action->shortcut().toString()));
    }
    QCOMPARE(keys.size(), desk.panel.handActions().size());
    QCOMPARE(names.size(), desk.panel.handActions().size());
    QVERIFY(!keys.contains(QString{}) && !names.contains(QString{}));
}

CARINA_SCREEN_TEST(TestHandsPanel)

} // namespace carina::hands_panel_test

#include "tst_hands_panel.moc"
