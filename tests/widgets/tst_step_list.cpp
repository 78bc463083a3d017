#include "widgets/step_list.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

namespace carina
{

class TestStepList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysEachStateByShapeAndWord();
    void speaksEachStep();
    void setsTheStepOfNowOff();
    void letsNobodyInWhereTheReasonIsGiven();
    void tellsWhichStepWasChosen();
    void hidesTheStepsThatAreNoMore();
};

namespace
{

const std::vector<StepList::Step> kSteps{
    {QStringLiteral("Tracker"), StepState::Done},
    {QStringLiteral("Stylus"), StepState::Now},
    {QStringLiteral("Touch"), StepState::Open, QStringLiteral("Find the tip first.")}};

struct Shown {
    Shown() { list.setSteps(kSteps); }
    [[nodiscard]] QPushButton& button(int step) const
    {
        return *list.findChild<QPushButton*>(QStringLiteral("step%1").arg(step));
    }
    StepList list;
};

} // namespace

void TestStepList::saysEachStateByShapeAndWord()
{
    const Shown shown;
    QCOMPARE(shown.button(1).text(), QStringLiteral("✓  &1  Tracker – done"));
    QCOMPARE(shown.button(2).text(), QStringLiteral("●  &2  Stylus – now"));
    QCOMPARE(shown.button(3).text(), QStringLiteral("○  &3  Touch – open"));
}

void TestStepList::speaksEachStep()
{
    const Shown shown;
    QCOMPARE(shown.button(1).accessibleName(), QStringLiteral("Step 1, Tracker: done"));
    QCOMPARE(shown.button(3).accessibleName(), QStringLiteral("Step 3, Touch: open"));
}

void TestStepList::setsTheStepOfNowOff()
{
    const Shown shown;
    QVERIFY(!shown.button(1).isDefault());
    QVERIFY(shown.button(2).isDefault());
    QVERIFY(!shown.button(3).isDefault());
}

void TestStepList::letsNobodyInWhereTheReasonIsGiven()
{
    Shown shown;
    QVERIFY(shown.button(1).isEnabled());
    QVERIFY(!shown.button(3).isEnabled());
    QCOMPARE(shown.button(3).toolTip(), QStringLiteral("Find the tip first."));
    std::vector<StepList::Step> later = kSteps;
    later[2].whyNot.clear();
    shown.list.setSteps(later);
    QVERIFY(shown.button(3).isEnabled());
    QVERIFY(shown.button(3).toolTip().isEmpty());
}

void TestStepList::tellsWhichStepWasChosen()
{
    const Shown shown;
    QSignalSpy chosen{&shown.list, &StepList::chosen};
    shown.button(2).click();
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen[0][0].toInt(), 1);
}

void TestStepList::hidesTheStepsThatAreNoMore()
{
    Shown shown;
    shown.list.setSteps({kSteps[0]});
    QVERIFY(!shown.button(1).isHidden());
    QVERIFY(shown.button(2).isHidden());
    shown.list.setSteps(kSteps);
    QVERIFY(!shown.button(2).isHidden());
}

} // namespace carina

QTEST_MAIN(carina::TestStepList)
#include "tst_step_list.moc"
