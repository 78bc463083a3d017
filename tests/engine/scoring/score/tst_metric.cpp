#include "engine/scoring/score/literature.h"
#include "engine/scoring/score/metric.h"
#include "tests/engine/scoring/score/tried.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <set>
#include <string>

namespace carina::metric_test
{
namespace
{

using namespace carina::test;

constexpr double kRounding = 1e-6;

std::vector<Metric> allMetrics()
{
    std::vector<Metric> all;
    for (std::size_t i = 0; i < kMetricCount; ++i)
        all.push_back(static_cast<Metric>(i));
    return all;
}

} // namespace

class TestMetric : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasAWordOfItsOwn();
    void isInItsUnit_data();
    void isInItsUnit();
    void isMeasuredOfAGoodTry();
    void isMissingWhereNothingMeasuredIt();
    void isNotMissingWhereTheTryNeverCameToIt();
    void needsALaryngoscopeForTheView();
    void knowsOfNoViewThatNobodyRead();
    void isLinkedToItsMoment();
    void failsLateAndInTheOesophagus();
    void standsBesideTheLiterature();
};

void TestMetric::hasAWordOfItsOwn()
{
    std::set<std::string> words;
    for (const Metric metric : allMetrics()) {
        words.insert(entryOf(metric).word);
        QCOMPARE(metricOf(entryOf(metric).word), std::optional{metric});
    }
    QCOMPARE(words.size(), kMetricCount);
    QVERIFY(!metricOf("speed"));
    QVERIFY(!metricOf(""));
}

void TestMetric::isInItsUnit_data()
{
    QTest::addColumn<Metric>("metric");
    QTest::addColumn<double>("value");
    QTest::newRow("view") << Metric::TimeToView << 4.0;
    QTest::newRow("cords") << Metric::TimeToCords << 10.0;
    QTest::newRow("breath") << Metric::TimeToBreath << 20.0;
    QTest::newRow("blade") << Metric::BladeTime << 14.0;
    QTest::newRow("attempts") << Metric::Attempts << 1.0;
    QTest::newRow("glottis") << Metric::GlottisSeen << 1.0;
    QTest::newRow("opening") << Metric::GlotticOpening << 80.0;
    QTest::newRow("trachea") << Metric::InTrachea << 1.0;
    QTest::newRow("bronchus") << Metric::InBronchus << 0.0;
    QTest::newRow("oesophagus") << Metric::InOesophagus << 0.0;
    QTest::newRow("oesophageal time") << Metric::OesophagealTime << 0.0;
    QTest::newRow("depth") << Metric::DepthError << 5.0;
    QTest::newRow("carina") << Metric::AboveCarina << 30.0;
    QTest::newRow("cuff") << Metric::CuffInflated << 1.0;
    QTest::newRow("head") << Metric::HeadExtension << 22.0;
    QTest::newRow("saturation") << Metric::LowestSaturation << 98.0;
    QTest::newRow("below 90") << Metric::TimeBelow90 << 0.0;
    QTest::newRow("incisors") << Metric::IncisorPeak << 0.0;
    QTest::newRow("tongue") << Metric::TonguePeak << 32.0;
    QTest::newRow("tongue, mean") << Metric::TongueMean << 20.0;
    QTest::newRow("tongue, integral") << Metric::TongueImpulse << 240.0;
    QTest::newRow("plane") << Metric::PlaneTilt << 8.207015; // 2.5e-3 (180 / pi)^2
    QTest::newRow("path") << Metric::HandPath << 60.0;
    QTest::newRow("jerk of the hand") << Metric::HandJerk << 5.0;
    QTest::newRow("travel") << Metric::HeadTravel << 12.0;
    QTest::newRow("jerk of the head") << Metric::HeadJerk << 2.0;
    QTest::newRow("auscultated") << Metric::Auscultated << 1.0;
}

void TestMetric::isInItsUnit()
{
    QFETCH(const Metric, metric);
    QFETCH(const double, value);
    TryMetrics metrics = goodTry();
    metrics.depthWanted = millimetres(205.0);
    QVERIFY(std::abs(valueOf(metrics, metric).value() - value) < kRounding);
}

void TestMetric::isMeasuredOfAGoodTry() { QVERIFY(notMeasured(goodTry()).empty()); }

void TestMetric::isMissingWhereNothingMeasuredIt()
{
    const TryMetrics metrics = courseOf(goodCourse().events(), courseTime(50.0));
    const std::vector<Metric> missing = notMeasured(metrics);
    for (const Metric metric :
         {Metric::DepthError, Metric::HeadExtension, Metric::LowestSaturation, Metric::TimeBelow90,
          Metric::IncisorPeak, Metric::TongueImpulse, Metric::PlaneTilt, Metric::HandPath,
          Metric::HeadJerk, Metric::Prepared, Metric::Auscultated})
        QVERIFY(std::ranges::count(missing, metric) == 1);
    for (const Metric metric : {Metric::TimeToView, Metric::AboveCarina, Metric::CuffInflated})
        QVERIFY(std::ranges::count(missing, metric) == 0);
}

void TestMetric::isNotMissingWhereTheTryNeverCameToIt()
{
    const TryMetrics metrics = oesophagealTry();
    for (const Metric metric : {Metric::TimeToView, Metric::TimeToCords, Metric::TimeToBreath,
                                Metric::DepthError, Metric::AboveCarina}) {
        QVERIFY(!valueOf(metrics, metric));
        QVERIFY(neverCameTo(metrics, metric));
        QVERIFY(std::ranges::count(notMeasured(metrics), metric) == 0);
    }
    QVERIFY(!neverCameTo(goodTry(), Metric::TimeToBreath));
}

void TestMetric::needsALaryngoscopeForTheView()
{
    HandWrittenCourse blind;
    blind.at(5.0, IntubationStep::TubePastTeeth);
    const TryMetrics metrics = courseOf(blind.events(), courseTime(9.0));
    for (const Metric metric : {Metric::TimeToView, Metric::GlottisSeen, Metric::BladeTime}) {
        QVERIFY(!valueOf(metrics, metric));
        QVERIFY(!neverCameTo(metrics, metric));
    }
}

void TestMetric::knowsOfNoViewThatNobodyRead()
{
    HandWrittenCourse unread;
    unread.at(5.0, IntubationStep::BladeIn);
    TryMetrics metrics = courseOf(unread.events(), courseTime(9.0));
    QCOMPARE(valueOf(metrics, Metric::GlottisSeen), std::optional{0.0});
    metrics.isViewRead = false;
    for (const Metric metric : {Metric::TimeToView, Metric::GlottisSeen, Metric::GlotticOpening}) {
        QVERIFY(!valueOf(metrics, metric));
        QVERIFY(!neverCameTo(metrics, metric));
        QVERIFY(std::ranges::count(notMeasured(metrics), metric) == 1);
    }
}

void TestMetric::isLinkedToItsMoment()
{
    const TryMetrics good = goodTry();
    QCOMPARE(momentOf(good, Metric::LowestSaturation), courseTime(29.0));
    QCOMPARE(momentOf(good, Metric::TonguePeak), courseTime(18.0));
    QCOMPARE(momentOf(good, Metric::HandJerk), courseTime(11.0));
    QCOMPARE(momentOf(good, Metric::HeadJerk), courseTime(12.0));
    QCOMPARE(momentOf(good, Metric::DepthError), courseTime(30.0));
    QVERIFY(!momentOf(good, Metric::HandPath));
    QVERIFY(!momentOf(good, Metric::OesophagealTime));
    QCOMPARE(momentOf(oesophagealTry(), Metric::OesophagealTime), courseTime(20.0));
    const TryMetrics late = courseOf(lateRecognition().events(), courseTime(105.0));
    QCOMPARE(momentOf(late, Metric::Attempts), courseTime(65.0));
    QCOMPARE(valueOf(late, Metric::OesophagealTime), 40.0);
    QVERIFY(!momentOf(late, Metric::LowestSaturation)); // not measured
}

void TestMetric::failsLateAndInTheOesophagus()
{
    TryMetrics metrics = goodTry();
    QCOMPARE(valueOf(metrics, Metric::Failed), 0.0);
    metrics.throughCords = metrics.begun + kFailedAfter + std::chrono::seconds{1};
    QCOMPARE(valueOf(metrics, Metric::Failed), 1.0);
    QCOMPARE(valueOf(oesophagealTry(), Metric::Failed), 1.0);
    QCOMPARE(momentOf(oesophagealTry(), Metric::Failed), courseTime(20.0));
}

void TestMetric::standsBesideTheLiterature()
{
    for (const LiteratureFigure& figure : kLiteratureFigures) {
        QCOMPARE(literatureOf(figure.metric), &figure); // one for each
        QVERIFY(figure.expert.mean < figure.novice.mean);
        QVERIFY(!std::string{figure.source}.empty());
    }
    QVERIFY(!literatureOf(Metric::HandPath)); // which did not tell them apart
}

CARINA_TEST(TestMetric)

} // namespace carina::metric_test

#include "tst_metric.moc"
