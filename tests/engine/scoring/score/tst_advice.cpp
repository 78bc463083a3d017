#include "engine/scoring/score/advice.h"

#include "tests/engine/scoring/score/tried.h"
#include "tests/support/test_class.h"

#include <functional>

namespace carina::advice_test
{
namespace
{

using namespace carina::test;
using Change = std::function<void(TryMetrics&)>;

/// Metrics of a good try, but for one thing.
std::vector<Advice> adviceAfter(const Change& change)
{
    TryMetrics metrics = goodTry();
    change(metrics);
    return adviceFor(metrics);
}

} // namespace

class TestAdvice : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void praisesAGoodTryByAHarderOne();
    void comesFirstForWhatWentWrong_data();
    void comesFirstForWhatWentWrong();
    void beginsWithTheOesophagus();
    void isAlwaysThree();
    void saysNothingOfWhatWasNotMeasured();
};

void TestAdvice::praisesAGoodTryByAHarderOne()
{
    QCOMPARE(adviceFor(goodTry()),
             (std::vector{Advice::TryHarderPatient, Advice::TryOtherManikin, Advice::Repeat}));
}

void TestAdvice::comesFirstForWhatWentWrong_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<Advice>("advice");
    const auto row = [](const char* name, Advice advice, const Change& change) {
        QTest::newRow(name) << change << advice;
    };
    row("late recognition", Advice::RecogniseSooner, [](TryMetrics& of) {
        of.oesophagus.push_back({courseTime(12.0), courseTime(30.0)});
    });
    row("beyond the carina", Advice::PullTubeBack,
        [](TryMetrics& of) { of.outcome = TryOutcome::LeftMain; });
    row("little oxygen", Advice::VentilateBetween,
        [](TryMetrics& of) { of.oxygen->below = std::chrono::seconds{1}; });
    row("no view", Advice::SeeGlottisFirst, [](TryMetrics& of) { of.view.reset(); });
    row("a view, and no tube", Advice::ShapeTube,
        [](TryMetrics& of) { of.outcome = TryOutcome::Abandoned; });
    row("two attempts", Advice::ChangeSomething,
        [](TryMetrics& of) { of.attempts.push_back(courseTime(15.0)); });
    row("teeth", Advice::SpareTheTeeth,
        [](TryMetrics& of) { of.incisors->aboveWarning = std::chrono::milliseconds{200}; });
    row("too shallow", Advice::AdvanceTube,
        [](TryMetrics& of) { of.depthWanted = millimetres(211.0); });
    row("too deep", Advice::WithdrawTube,
        [](TryMetrics& of) { of.depthWanted = millimetres(189.0); });
    row("no cuff", Advice::InflateCuff, [](TryMetrics& of) { of.cuffInflated.reset(); });
    row("tongue", Advice::SpareTheTongue,
        [](TryMetrics& of) { of.tongue->aboveWarning = std::chrono::milliseconds{200}; });
    row("head", Advice::ExtendHead, [](TryMetrics& of) { of.headExtension = degrees(3.0); });
    row("blade", Advice::HoldBladeUpright,
        [](TryMetrics& of) { of.plane->squaredTilt = 0.02; }); // 66 square degrees
    row("bending", Advice::BendLess, [](TryMetrics& of) { of.head->verticalTravel = metres(0.4); });
    row("slow", Advice::BeQuicker, [](TryMetrics& of) { of.firstBreath = courseTime(71.0); });
}

void TestAdvice::comesFirstForWhatWentWrong()
{
    QFETCH(const Change, change);
    QFETCH(const Advice, advice);
    QCOMPARE(adviceAfter(change).front(), advice);
}

void TestAdvice::beginsWithTheOesophagus()
{
    QCOMPARE(adviceFor(oesophagealTry()),
             (std::vector{Advice::TakeTubeOut, Advice::RecogniseSooner, Advice::SeeGlottisFirst}));
}

void TestAdvice::isAlwaysThree()
{
    QCOMPARE(adviceFor(goodTry()).size(), kAdviceGiven);
    QCOMPARE(adviceFor(courseOf(lateRecognition().events(), courseTime(105.0))).size(),
             kAdviceGiven);
}

void TestAdvice::saysNothingOfWhatWasNotMeasured()
{
    const auto given = adviceFor(courseOf(goodCourse().events(), courseTime(50.0)));
    QCOMPARE(given, adviceFor(goodTry()));
}

CARINA_TEST(TestAdvice)

} // namespace carina::advice_test

#include "tst_advice.moc"
