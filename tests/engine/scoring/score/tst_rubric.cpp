#include "engine/scoring/score/rubric.h"

#include "tests/engine/scoring/score/tried.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::rubric_test
{
namespace
{

using namespace carina::test;

const Judgement& judgementOf(const Score& score, Metric metric)
{
    const auto found = std::ranges::find(
        score.judgements, metric, [](const Judgement& judged) { return judged.criterion.metric; });
    return *found;
}

Rubric only(const Criterion& criterion) { return {.criteria = {criterion}}; }

} // namespace

class TestRubric : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesAllPointsForAGoodTry();
    void doesNotCountWhatWasNotMeasured();
    void takesAwayForTheOesophagus();
    void takesAwayForABronchus();
    void linksALateBreathToTheMomentItWasDue();
    void linksALossToNoMomentBeforeTheTry();
    void losesWhatTheTryNeverCameTo();
    void meetsALimitExactly_data();
    void meetsALimitExactly();
    void linksALowSaturationToItsMoment();
};

void TestRubric::givesAllPointsForAGoodTry()
{
    const Score score = scoreOf(goodTry(), publishedRubric());
    QCOMPARE(score.points, 100.0);
    QCOMPARE(score.possible, 100.0);
    QCOMPARE(score.ofAll, 100.0);
    for (const Judgement& judged : score.judgements)
        QCOMPARE(judged.verdict, ItemVerdict::Met);
}

void TestRubric::doesNotCountWhatWasNotMeasured()
{
    TryMetrics metrics = goodTry();
    metrics.checks = {};
    metrics.depthWanted.reset();
    const Score score = scoreOf(metrics, publishedRubric());
    QCOMPARE(score.points, 40.0);
    QCOMPARE(score.possible, 40.0);
    QCOMPARE(score.ofAll, 100.0);
    QCOMPARE(std::ranges::count(score.judgements, ItemVerdict::NotMeasured, &Judgement::verdict),
             6);
    QVERIFY(!judgementOf(score, Metric::DepthError).moment);
}

/// No view, no depth, no cuff, no breath: four items lost, and a penalty.
void TestRubric::takesAwayForTheOesophagus()
{
    const Score score = scoreOf(oesophagealTry(), publishedRubric());
    QCOMPARE(score.points, -10.0);
    QCOMPARE(score.possible, 40.0);
    const Judgement& failed = judgementOf(score, Metric::Failed);
    QCOMPARE(failed.verdict, ItemVerdict::Missed);
    QCOMPARE(failed.points, -10.0);
    QCOMPARE(failed.moment, courseTime(20.0));
}

void TestRubric::takesAwayForABronchus()
{
    TryMetrics metrics = goodTry();
    metrics.outcome = TryOutcome::RightMain;
    const Score score = scoreOf(metrics, publishedRubric());
    QCOMPARE(score.points, 90.0);
    QCOMPARE(judgementOf(score, Metric::InBronchus).points, -10.0);
    QCOMPARE(judgementOf(score, Metric::InBronchus).moment, courseTime(30.0));
}

void TestRubric::linksALateBreathToTheMomentItWasDue()
{
    TryMetrics metrics = goodTry();
    metrics.firstBreath = courseTime(200.0);
    metrics.ended = courseTime(220.0);
    const Score score = scoreOf(metrics, publishedRubric());
    const Judgement& time = judgementOf(score, Metric::TimeToBreath);
    QCOMPARE(time.verdict, ItemVerdict::Missed);
    QCOMPARE(time.value, 190.0);
    QCOMPARE(time.moment, courseTime(160.0));
}

/// A limit below 0 is never met.
void TestRubric::linksALossToNoMomentBeforeTheTry()
{
    const Score score = scoreOf(
        goodTry(), only({.metric = Metric::TimeToView, .bound = Bound::AtMost, .limit = -5.0}));
    QCOMPARE(score.judgements.front().verdict, ItemVerdict::Missed);
    QCOMPARE(score.judgements.front().moment, goodTry().begun);
}

void TestRubric::losesWhatTheTryNeverCameTo()
{
    const Score score = scoreOf(oesophagealTry(), publishedRubric());
    const Judgement& time = judgementOf(score, Metric::TimeToBreath);
    QCOMPARE(time.verdict, ItemVerdict::Never);
    QVERIFY(!time.value);
    QCOMPARE(time.moment, courseTime(80.0)); // the end came before the limit
    QCOMPARE(judgementOf(score, Metric::DepthError).verdict, ItemVerdict::Never);
    QCOMPARE(judgementOf(score, Metric::HeadExtension).verdict, ItemVerdict::NotMeasured);
}

void TestRubric::meetsALimitExactly_data()
{
    QTest::addColumn<Bound>("bound");
    QTest::addColumn<double>("limit");
    QTest::addColumn<ItemVerdict>("verdict");
    QTest::newRow("at most, exactly") << Bound::AtMost << 32.0 << ItemVerdict::Met;
    QTest::newRow("at most, beyond") << Bound::AtMost << 31.9 << ItemVerdict::Missed;
    QTest::newRow("at least, exactly") << Bound::AtLeast << 32.0 << ItemVerdict::Met;
    QTest::newRow("at least, beyond") << Bound::AtLeast << 32.1 << ItemVerdict::Missed;
}

void TestRubric::meetsALimitExactly()
{
    QFETCH(const Bound, bound);
    QFETCH(const double, limit);
    QFETCH(const ItemVerdict, verdict);
    const Criterion criterion{.metric = Metric::TonguePeak,
                              .bound = bound,
                              .limit = limit,
                              .points = 3.0,
                              .penalty = 2.0};
    const Score score = scoreOf(goodTry(), only(criterion));
    QCOMPARE(score.judgements.front().verdict, verdict);
    QCOMPARE(score.points, verdict == ItemVerdict::Met ? 3.0 : -2.0);
}

void TestRubric::linksALowSaturationToItsMoment()
{
    const Score score =
        scoreOf(goodTry(),
                only({.metric = Metric::LowestSaturation, .bound = Bound::AtLeast, .limit = 99.0}));
    QCOMPARE(score.judgements.front().moment, courseTime(29.0));
}

CARINA_TEST(TestRubric)

} // namespace carina::rubric_test

#include "tst_rubric.moc"
