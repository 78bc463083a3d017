#include "tests/support/test_class.h"
#include "ui/panels/undo_button.h"

namespace carina::undo_button_test
{

class TestUndoButton : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesAndTakesBack();
    void listsTheHistory();
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

CARINA_SCREEN_TEST(TestUndoButton)

} // namespace carina::undo_button_test

#include "tst_undo_button.moc"
