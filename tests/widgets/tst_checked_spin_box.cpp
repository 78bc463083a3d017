#include "tests/support/test_class.h"
#include "widgets/checked_spin_box.h"

#include <QShortcut>
#include <QSignalSpy>

namespace carina::checked_spin_box_test
{
namespace
{

template <class Box> void type(Box& box, const QString& text)
{
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
}

/// A window with a box and an undo of its own.
template <class Box> struct Window {
    QWidget window;
    Box box{&window};
    QShortcut undo{QKeySequence::Undo, &window};
    QSignalSpy undone{&undo, &QShortcut::activated};

    Window()
    {
        box.setRange(20, 1000);
        box.setKeyboardTracking(false);
        box.setSuffix(QStringLiteral(" ml"));
        box.setValue(280);
        window.show();
        box.setFocus();
    }
    void press(QKeySequence::StandardKey key) { QTest::keySequence(&box, QKeySequence{key}); }
};

template <class Box> void leavesUndoToTheWindow()
{
    Window<Box> with;
    QVERIFY(QTest::qWaitForWindowActive(&with.window));
    type(with.box, QStringLiteral("400"));
    with.press(QKeySequence::Undo);
    QCOMPARE(with.undone.count(), 1);
    QCOMPARE(with.box.value(), 400);
    QTest::keyClicks(&with.box, QStringLiteral("5")); // half typed
    with.press(QKeySequence::Undo);
    QCOMPARE(with.undone.count(), 1);
    QVERIFY(!with.box.text().contains(QLatin1Char{'5'}));
}

/// Nor is an earlier number put back where the window has no undo.
template <class Box> void keepsWhatWasEntered()
{
    Window<Box> with;
    with.undo.setEnabled(false);
    type(with.box, QStringLiteral("400"));
    for (const auto key : {QKeySequence::Undo, QKeySequence::Redo}) {
        with.press(key);
        QVERIFY(with.box.text().contains(QStringLiteral("400")));
    }
    with.box.clearFocus();
    QCOMPARE(with.box.value(), 400);
}

} // namespace

class TestCheckedSpinBox : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesWhatIsInTheRange()
    {
        CheckedSpinBox box;
        box.setRange(20, 1000);
        box.setSuffix(QStringLiteral(" ml"));
        box.setValue(280);
        const QSignalSpy refused{&box, &CheckedSpinBox::refused};
        type(box, QStringLiteral("450"));
        QCOMPARE(box.value(), 450);
        QCOMPARE(refused.count(), 0);
    }

    // It does not become 999, nor the end of the range.
    void refusesWhatIsOutsideWithTheRange_data()
    {
        QTest::addColumn<QString>("typed");
        for (const char* typed : {"9999", "1001", "5", "123456"})
            QTest::newRow(typed) << QString::fromLatin1(typed);
    }
    void refusesWhatIsOutsideWithTheRange()
    {
        QFETCH(QString, typed);
        CheckedSpinBox box;
        box.setRange(20, 1000);
        box.setKeyboardTracking(false);
        box.setSuffix(QStringLiteral(" ml"));
        box.setValue(280);
        const QSignalSpy refused{&box, &CheckedSpinBox::refused};
        type(box, typed);
        QCOMPARE(box.value(), 280);
        QCOMPARE(box.text(), QStringLiteral("280 ml"));
        QVERIFY(refused.count() >= 1);
        const QString why = refused.last()[0].toString();
        for (const QString& part : {typed, box.locale().toString(20), box.locale().toString(1000)})
            QVERIFY2(why.contains(part), qPrintable(why));
    }

    void refusesDecimalsLikewise()
    {
        CheckedDoubleSpinBox box;
        box.setRange(0.5, 5.0);
        box.setKeyboardTracking(false);
        box.setValue(1.5);
        const QSignalSpy refused{&box, &CheckedDoubleSpinBox::refused};
        type(box, QStringLiteral("77"));
        QCOMPARE(box.value(), 1.5);
        QVERIFY(refused.count() >= 1);
        type(box, QStringLiteral("2.25"));
        QCOMPARE(box.value(), 2.25);
    }

    void leavesTheKeyOfUndoToTheWindow()
    {
        leavesUndoToTheWindow<CheckedSpinBox>();
        leavesUndoToTheWindow<CheckedDoubleSpinBox>();
    }

    void keepsWhatWasEnteredAgainstTheKeyOfUndo()
    {
        keepsWhatWasEntered<CheckedSpinBox>();
        keepsWhatWasEntered<CheckedDoubleSpinBox>();
    }

    void takesNoLetters()
    {
        CheckedSpinBox box;
        box.setRange(0, 50);
        box.setValue(7);
        type(box, QStringLiteral("x"));
        QCOMPARE(box.value(), 7);
    }
};

CARINA_SCREEN_TEST(TestCheckedSpinBox)

} // namespace carina::checked_spin_box_test

#include "tst_checked_spin_box.moc"
