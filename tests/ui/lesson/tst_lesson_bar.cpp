#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/lesson/lesson_bar.h"

namespace carina::lesson_bar_test
{
namespace
{

using test::FakeSessionNode;

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    LessonModel model{session, FakeSessionNode::kStation};
    LessonBar bar;
    QToolButton* toggle = bar.findChild<QToolButton*>(QStringLiteral("showToOthers"));
    QToolButton* to = bar.findChild<QToolButton*>(QStringLiteral("showTo"));

    Desk()
    {
        bar.setModel(model);
        bar.show();
    }
    /// The choice with this text, once the menu is filled.
    [[nodiscard]] QAction* choice(const char* text) const
    {
        Q_EMIT to->menu()->aboutToShow();
        for (QAction* action : to->menu()->actions())
            if (action->text().remove(QLatin1Char{'&'}).startsWith(QLatin1String{text}))
                return action;
        return nullptr;
    }
    [[nodiscard]] std::optional<ShownLesson> shown() const
    {
        return node.state()->stations().at(FakeSessionNode::kStation).lesson;
    }
};

} // namespace

class TestLessonBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneSwitchShowsAndEnds()
    {
        Desk desk;
        QVERIFY(!desk.toggle->isChecked());
        QCOMPARE(desk.toggle->text(), QStringLiteral("○ Show"));
        const int width = desk.toggle->minimumWidth();
        QTest::keyClick(desk.toggle, Qt::Key_Space);
        QVERIFY(desk.shown() && desk.toggle->isChecked());
        QCOMPARE(desk.toggle->text(), QStringLiteral("● Shown"));
        QCOMPARE(desk.toggle->minimumWidth(), width);
        desk.toggle->click();
        QVERIFY(!desk.shown() && !desk.toggle->isChecked());
    }

    void showsToWhomIsChosenAndWithoutTheViewIfWanted()
    {
        Desk desk;
        QCOMPARE(desk.to->text(), QStringLiteral("To: Everybody here"));
        desk.choice("Tom")->trigger();
        QCOMPARE(desk.to->text(), QStringLiteral("To: Tom"));
        desk.toggle->click();
        QVERIFY(desk.shown()->to == FakeSessionNode::kTrainee && desk.shown()->lesson.showsView);
        QVERIFY(desk.choice("With my view")->isChecked());
        desk.choice("With my view")->trigger();
        QVERIFY(!desk.shown()->lesson.showsView);
    }

    void isNamedAndReachedByKeyboard()
    {
        const Desk desk;
        for (const QToolButton* button : {desk.toggle, desk.to}) {
            QVERIFY(!button->accessibleName().isEmpty());
            QVERIFY(button->focusPolicy() & Qt::TabFocus);
        }
    }
};

CARINA_SCREEN_TEST(TestLessonBar)

} // namespace carina::lesson_bar_test

#include "tst_lesson_bar.moc"
