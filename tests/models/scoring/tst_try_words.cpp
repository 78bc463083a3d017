#include "models/scoring/try_words.h"

#include "engine/scoring/score/literature.h"
#include "tests/engine/scoring/score/tried.h"
#include "tests/support/test_class.h"

#include <QTranslator>

#include <algorithm>
#include <set>

namespace carina::try_words_test
{
namespace
{

using namespace carina::test;

TryReport reportOfGoodTry()
{
    return reportOf(goodTry(), DepthRule::TenthOfHeight, publishedRubric());
}

QString valueNamed(const std::vector<SummaryLine>& lines, const char* name)
{
    const auto found = std::ranges::find(lines, QString::fromLatin1(name), &SummaryLine::name);
    return found == lines.end() ? QString{} : found->value;
}

/// Knows the form of one number for one sentence.
class OneForm : public QTranslator
{
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* /*context*/, const char* text,
                                    const char* /*meaning*/, int number) const override
    {
        const bool isIt = number == 1 && qstrcmp(text, "%1 of %2 points") == 0;
        return isIt ? QStringLiteral("%1 of %2 point") : QString{};
    }
};

} // namespace

class TestTryWords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void haveATextForEachOfAll();
    void tellAGoodTryWithItsUnits();
    void tellThatADepthIsUncertain();
    void tellWhatWasNotMeasured();
    void tellWhatNeverHappened();
    void explainALostPointWithItsMoment();
    void tellThatAPenaltyWasNotGiven();
    void setFiguresOfTheLiteratureBeside();
    void tellWhatIsUncertainAndTooDeep();
    void takeTheSingularForOnePoint();
    void tellForcesWithTheirLimits();
    void tellOnlyTheMotionThatWasMeasured();
    void tellNoSaturationAsMoreThanItWas();
    void leaveOutPauses();
};

void TestTryWords::haveATextForEachOfAll()
{
    std::set<QString> metrics;
    for (std::size_t i = 0; i < kMetricCount; ++i)
        metrics.insert(metricText(static_cast<Metric>(i)));
    QCOMPARE(metrics.size(), kMetricCount);
    QVERIFY(!metrics.contains(QString{}));
    std::set<QString> advice;
    for (int i = 0; i <= int(kLastAdvice); ++i) {
        advice.insert(adviceText(static_cast<Advice>(i)));
        QVERIFY(adviceText(static_cast<Advice>(i)).endsWith(QLatin1Char('.')));
    }
    QCOMPARE(advice.size(), std::size_t(kLastAdvice) + 1);
    std::set<QString> outcomes;
    for (int i = 0; i <= int(kLastTryOutcome); ++i)
        outcomes.insert(outcomeText({.outcome = static_cast<TryOutcome>(i)}));
    QCOMPARE(outcomes.size(), std::size_t(kLastTryOutcome) + 1);
    for (const DepthRule rule : kDepthRules)
        QVERIFY(!ruleText(rule).isEmpty());
}

void TestTryWords::tellAGoodTryWithItsUnits()
{
    const auto lines = tryLines(reportOfGoodTry());
    QCOMPARE(outcomeText(goodTry()), QStringLiteral("✓ In the trachea"));
    QCOMPARE(valueNamed(lines, "Time to the first breath"), QStringLiteral("20.0\u00a0s"));
    QCOMPARE(valueNamed(lines, "Depth at the teeth"),
             QStringLiteral("20.0\u00a0cm; 20.0\u00a0cm by the rule 0.10 × height + 5\u00a0cm"));
    QCOMPARE(valueNamed(lines, "Tip above the carina"), QStringLiteral("30\u00a0mm"));
    QCOMPARE(valueNamed(lines, "Lowest oxygen saturation"),
             QStringLiteral("98\u00a0%, at 0:19\u00a0min; never below 90\u00a0%"));
    QCOMPARE(valueNamed(lines, "View"),
             QStringLiteral("80\u00a0% of the glottis, after 4.0\u00a0s"));
    QCOMPARE(valueNamed(lines, "Attempts"), QStringLiteral("1"));
    QCOMPARE(scoreText(reportOfGoodTry().score), QStringLiteral("100 of 100 points"));
    QVERIFY(notMeasuredText(goodTry()).isEmpty());
}

void TestTryWords::tellThatADepthIsUncertain()
{
    TryMetrics metrics = goodTry();
    metrics.depth->confidence = 0.62;
    metrics.depthWanted.reset();
    const TryReport report = reportOf(metrics, DepthRule::TenthOfHeight, publishedRubric());
    QCOMPARE(valueNamed(tryLines(report), "Depth at the teeth"),
             QStringLiteral("20.0\u00a0cm (62\u00a0% sure)"));
}

void TestTryWords::tellWhatWasNotMeasured()
{
    const TryMetrics metrics = courseOf(goodCourse().events(), courseTime(50.0));
    const TryReport report = reportOf(metrics, DepthRule::TenthOfHeight, publishedRubric());
    QCOMPARE(valueNamed(tryLines(report), "Lowest oxygen saturation"),
             QStringLiteral("not measured"));
    QVERIFY(notMeasuredText(metrics).contains(QStringLiteral("Incisors, highest force")));
    QVERIFY(scoreText(report.score).endsWith(QStringLiteral("more could not be judged")));
    QCOMPARE(valueNamed(judgementLines(report), "Equipment prepared"),
             QStringLiteral("○ not measured, does not count"));
}

void TestTryWords::tellWhatNeverHappened()
{
    const TryReport report =
        reportOf(oesophagealTry(), DepthRule::TenthOfHeight, publishedRubric());
    const auto lines = tryLines(report);
    QCOMPARE(outcomeText(report.metrics), QStringLiteral("▲ In the oesophagus, not recognised"));
    QCOMPARE(valueNamed(lines, "Time to the first breath"), QStringLiteral("never"));
    QCOMPARE(valueNamed(lines, "View"), QStringLiteral("never"));
    QCOMPARE(valueNamed(lines, "Longest time in the oesophagus"), QStringLiteral("60.0\u00a0s"));
}

void TestTryWords::explainALostPointWithItsMoment()
{
    TryMetrics metrics = goodTry();
    metrics.firstBreath = courseTime(200.0);
    metrics.ended = courseTime(220.0);
    const TryReport report = reportOf(metrics, DepthRule::TenthOfHeight, publishedRubric());
    QCOMPARE(valueNamed(judgementLines(report), "Time to the first breath"),
             QStringLiteral("▲ 0 of 10 points: 190.0\u00a0s, expected: at most 150.0\u00a0s; "
                            "2:30\u00a0min into the try"));
}

void TestTryWords::tellThatAPenaltyWasNotGiven()
{
    const auto lines = judgementLines(reportOfGoodTry());
    QCOMPARE(valueNamed(lines, "Tube in a main bronchus"), QStringLiteral("✓ no penalty"));
    const auto failed =
        judgementLines(reportOf(oesophagealTry(), DepthRule::TenthOfHeight, publishedRubric()));
    QCOMPARE(valueNamed(failed, "Failed: not within 150 s, or in the oesophagus"),
             QStringLiteral("▲ -10 points: yes, expected: no; 0:10\u00a0min into the try"));
}

void TestTryWords::setFiguresOfTheLiteratureBeside()
{
    const auto lines = literatureLines(goodTry());
    QCOMPARE(lines.size(), kLiteratureFigures.size());
    QCOMPARE(valueNamed(lines, "Your head, up and down"),
             QStringLiteral("you 12\u00a0cm, experts 13\u00a0cm (SD 8\u00a0cm), novices 39\u00a0cm "
                            "(SD 8\u00a0cm) (St. Marianna Med J 10(2):51)"));
}

void TestTryWords::tellWhatIsUncertainAndTooDeep()
{
    TryReport report = reportOfGoodTry();
    report.metrics.outcome = TryOutcome::RightMain;
    report.metrics.confidence = 0.55;
    report.metrics.depth->aboveCarina = millimetres(-12.0);
    report.metrics.oxygen->below = std::chrono::seconds{30};
    report.metrics.oxygen->fellBelow = report.metrics.oxygen->lowestAt;
    const auto lines = tryLines(report);
    QCOMPARE(outcomeText(report.metrics),
             QStringLiteral("▲ In the right main bronchus (55\u00a0% sure)"));
    QCOMPARE(valueNamed(lines, "Tip beyond the carina"), QStringLiteral("▲ 12\u00a0mm"));
    QVERIFY(valueNamed(lines, "Lowest oxygen saturation")
                .endsWith(QStringLiteral("below 90\u00a0% for 30.0\u00a0s")));
}

void TestTryWords::takeTheSingularForOnePoint()
{
    OneForm translator;
    QCoreApplication::installTranslator(&translator);
    QCOMPARE(scoreText({.points = 1.0, .possible = 1.0, .ofAll = 1.0}),
             QStringLiteral("1 of 1 point"));
    QCOMPARE(scoreText({.points = 0.5, .possible = 1.5, .ofAll = 1.5}),
             QStringLiteral("0.5 of 1.5 points"));
}

void TestTryWords::tellForcesWithTheirLimits()
{
    TryMetrics metrics;
    metrics.incisors = ForceFigures{.peak = newtons(45.0),
                                    .mean = newtons(12.0),
                                    .aboveWarning = std::chrono::milliseconds{3100},
                                    .aboveFault = std::chrono::milliseconds{400}};
    metrics.tongue = ForceFigures{.peak = newtons(38.0), .mean = newtons(20.0), .impulse = 90.0};
    const auto lines = handlingLines(metrics);
    QCOMPARE(valueNamed(lines, "Incisors, highest force"),
             QStringLiteral("▲ 45\u00a0N, 12\u00a0N on average; above 20\u00a0N for 3.1\u00a0s; "
                            "above 40\u00a0N for 0.4\u00a0s"));
    QCOMPARE(valueNamed(lines, "Tongue, highest force"),
             QStringLiteral("38\u00a0N, 20\u00a0N on average"));
    QCOMPARE(valueNamed(lines, "Tongue, force over time"), QStringLiteral("90\u00a0N\u00a0s"));
}

void TestTryWords::tellOnlyTheMotionThatWasMeasured()
{
    TryMetrics metrics;
    QVERIFY(handlingLines(metrics).empty());
    metrics.hand = MotionFigures{.path = metres(0.5), .meanJerk = 4.0};
    const auto lines = handlingLines(metrics);
    QCOMPARE(lines.size(), std::size_t{3}); // smoothness needs motion
    QCOMPARE(valueNamed(lines, "Path of the laryngoscope"), QStringLiteral("50\u00a0cm"));
    QCOMPARE(valueNamed(lines, "Jerk of the laryngoscope"), QStringLiteral("4.0\u00a0m/s³"));
}

/// 89.7 % is below 90 %, be it for less than the try could measure.
void TestTryWords::tellNoSaturationAsMoreThanItWas()
{
    TryMetrics metrics = goodTry();
    metrics.oxygen = OxygenFigures{.first = 0.99, .lowest = 0.897, .lowestAt = metrics.ended};
    metrics.oxygen->fellBelow = metrics.ended;
    const auto lines = tryLines(reportOf(metrics, DepthRule::TenthOfHeight, publishedRubric()));
    const QString told = valueNamed(lines, "Lowest oxygen saturation");
    QVERIFY2(told.startsWith(QStringLiteral("▲ 89\u00a0%")), qPrintable(told));
    QVERIFY2(told.endsWith(QStringLiteral("below 90\u00a0% for 0.0\u00a0s")), qPrintable(told));
    metrics.oxygen = OxygenFigures{.first = 1.0, .lowest = 0.90};
    const auto kept = tryLines(reportOf(metrics, DepthRule::TenthOfHeight, publishedRubric()));
    QVERIFY(valueNamed(kept, "Lowest oxygen saturation").startsWith(QStringLiteral("90\u00a0%")));
}

/// Twenty seconds into the try, and thirty in a pause.
void TestTryWords::leaveOutPauses()
{
    TryMetrics metrics = goodTry();
    metrics.pauses.add(metrics.begun + std::chrono::seconds{10},
                       metrics.begun + std::chrono::seconds{40});
    metrics.oxygen =
        OxygenFigures{.lowest = 0.95, .lowestAt = metrics.begun + std::chrono::seconds{50}};
    const auto lines = tryLines(reportOf(metrics, DepthRule::TenthOfHeight, publishedRubric()));
    const QString told = valueNamed(lines, "Lowest oxygen saturation");
    QVERIFY2(told.contains(QStringLiteral("at 0:20\u00a0min")), qPrintable(told));
}

CARINA_TEST(TestTryWords)

} // namespace carina::try_words_test

#include "tst_try_words.moc"
