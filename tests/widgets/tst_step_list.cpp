#include "tests/support/test_class.h"
#include "widgets/step_list.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

namespace carina::step_list_test
{

class TestStepList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysEachStateByShapeAndWord();
    void speaksEachStep();
    void setsTheStepThatIsShownOff();
    void saysBeneathWhyAStepIsNoFurther();
    void letsAnyStepBeEntered();
    void tellsWhichStepWasChosen();
    void hidesTheStepsThatAreNoMore();
};

namespace
{

const std::vector<StepList::Step> kSteps{
    {.title = QStringLiteral("Tracker"), .state = StepState::Done},
    {.title = QStringLiteral("Stylus"), .state = StepState::Open, .isHere = true},
    {.title = QStringLiteral("Touch"),
     .state = StepState::Waits,
     .why = QStringLiteral("Find the tip first.")},
    {.title = QStringLiteral("Fit"), .state = StepState::Begun},
    {.title = QStringLiteral("Verify"),
     .state = StepState::Stale,
     .why = QStringLiteral("Fitted again since.")}};

struct Shown {
    Shown() { list.setSteps(kSteps); }
    [[nodiscard]] QPushButton& button(int step) const
    {
        return *list.findChild<QPushButton*>(QStringLiteral("step%1").arg(step));
    }
    /// What is said beneath the steps, from the top.
    [[nodiscard]] QStringList reasons() const
    {
        QStringList reasons;
        for (const QLabel* label : list.findChildren<QLabel*>())
            if (!label->isHidden())
                reasons << label->text();
        return reasons;
    }
    StepList list;
};

} // namespace

void TestStepList::saysEachStateByShapeAndWord()
{
    const Shown shown;
    QCOMPARE(shown.button(1).text(), QStringLiteral("✓  &1  Tracker – done"));
    QCOMPARE(shown.button(2).text(), QStringLiteral("○  &2  Stylus – open"));
    QCOMPARE(shown.button(3).text(), QStringLiteral("·  &3  Touch – not yet"));
    QCOMPARE(shown.button(4).text(), QStringLiteral("◐  &4  Fit – begun"));
    QCOMPARE(shown.button(5).text(), QStringLiteral("▲  &5  Verify – redo"));
}

void TestStepList::speaksEachStep()
{
    const Shown shown;
    QCOMPARE(shown.button(1).accessibleName(), QStringLiteral("Step 1, Tracker: done"));
    QCOMPARE(shown.button(2).accessibleName(), QStringLiteral("Step 2, Stylus: open, shown now"));
    QCOMPARE(shown.button(3).accessibleName(), QStringLiteral("Step 3, Touch: not yet"));
    QCOMPARE(shown.button(3).accessibleDescription(), QStringLiteral("Find the tip first."));
    QVERIFY(shown.button(1).accessibleDescription().isEmpty());
}

void TestStepList::setsTheStepThatIsShownOff()
{
    const Shown shown;
    for (int step = 1; step <= 5; ++step)
        QCOMPARE(shown.button(step).isDefault(), step == 2);
}

void TestStepList::saysBeneathWhyAStepIsNoFurther()
{
    Shown shown;
    QCOMPARE(shown.reasons(), (QStringList{QStringLiteral("Find the tip first."),
                                           QStringLiteral("Fitted again since.")}));
    std::vector<StepList::Step> later = kSteps;
    later[2].why.clear();
    shown.list.setSteps(later);
    QCOMPARE(shown.reasons(), QStringList{QStringLiteral("Fitted again since.")});
}

void TestStepList::letsAnyStepBeEntered()
{
    const Shown shown;
    for (int step = 1; step <= 5; ++step)
        QVERIFY(shown.button(step).isEnabled());
}

void TestStepList::tellsWhichStepWasChosen()
{
    const Shown shown;
    QSignalSpy chosen{&shown.list, &StepList::chosen};
    shown.button(3).click();
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen[0][0].toInt(), 2);
}

void TestStepList::hidesTheStepsThatAreNoMore()
{
    Shown shown;
    shown.list.setSteps({kSteps[0]});
    QVERIFY(!shown.button(1).isHidden());
    QVERIFY(shown.button(2).isHidden());
    QVERIFY(shown.reasons().isEmpty());
    shown.list.setSteps(kSteps);
    QVERIFY(!shown.button(2).isHidden());
    QCOMPARE(shown.reasons().size(), 2);
}

CARINA_SCREEN_TEST(TestStepList)

} // namespace carina::step_list_test

#include "tst_step_list.moc"
