#include "engine/scoring/course/try_metrics.h"

#include "tests/engine/scoring/course/hand_written_course.h"
#include "tests/support/test_class.h"

namespace carina::try_metrics_test
{
namespace
{

using namespace carina::test;

TryMetrics courseUntil(const HandWrittenCourse& course, double ended_s)
{
    return courseOf(course.events(), courseTime(ended_s));
}

} // namespace

class TestTryMetrics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellTheTimesOfAGoodTry();
    void tellWhereTheTubeLies();
    void takeTheDepthAtWhichTheTubeRestsInTheEnd();
    void claimNoDepthWhereTheShapesParted();
    void tellASideAndThatItWasPulledBack();
    void tellAnOesophagusThatWasRecognisedLate();
    void tellAnOesophagusThatWasNotRecognised();
    void believeAMonitorThatConcludesAnew();
    void tellThatATryWasGivenUp();
    void forgetTheCuffOfATubeThatIsOut();
    void countAttempts();
    void forgetAPassageThatWasUndone();
    void takeTheConfidenceOfTheLastSeat();
    void tellTheLargestViewThatAnyStepTells();
    void areNoSurerOfTheDepthThanOfTheSeat();
};

void TestTryMetrics::tellTheTimesOfAGoodTry()
{
    const TryMetrics metrics = courseUntil(goodCourse(), 50.0);
    QCOMPARE(metrics.outcome, TryOutcome::Trachea);
    QCOMPARE(metrics.begun, courseTime(10.0));
    QCOMPARE(metrics.ended, courseTime(50.0));
    QCOMPARE(metrics.view, courseTime(14.0));
    QCOMPARE(metrics.throughCords, courseTime(20.0));
    QCOMPARE(metrics.firstBreath, courseTime(30.0));
    QCOMPARE(metrics.cuffInflated, courseTime(26.0));
    QCOMPARE(metrics.bladeTime, Duration{std::chrono::seconds{14}});
    QCOMPARE(metrics.glotticOpening, 0.8);
    QVERIFY(metrics.hadBlade);
    QVERIFY(metrics.oesophagus.empty());
}

/// The view goes on opening after it is seen; before, nothing was.
void TestTryMetrics::tellTheLargestViewThatAnyStepTells()
{
    HandWrittenCourse course;
    course.seen(0.9)
        .at(10.0, IntubationStep::TubePastTeeth) // of an attempt before this try
        .seen(0.0)
        .at(11.0, IntubationStep::BladeIn);
    QVERIFY(!courseUntil(course, 50.0).glotticOpening);
    course.seen(0.1).at(14.0, IntubationStep::GlottisSeen);
    QCOMPARE(courseUntil(course, 50.0).glotticOpening, 0.1);
    course.seen(0.8).at(24.0, IntubationStep::BladeOut);
    QCOMPARE(courseUntil(course, 50.0).glotticOpening, 0.8);
}

void TestTryMetrics::areNoSurerOfTheDepthThanOfTheSeat()
{
    HandWrittenCourse course;
    course.at(10.0, IntubationStep::TubePastTeeth)
        .sure(0.4)
        .at(20.0, IntubationStep::ThroughCords, TubeSeat::Trachea)
        .sure(1.0)
        .at(21.0, IntubationStep::ShapesApart)
        .at(22.0, IntubationStep::ShapesTogether)
        .at(23.0, IntubationStep::BladeOut);
    QCOMPARE(courseUntil(course, 50.0).depth->confidence, 0.4);
}

void TestTryMetrics::tellWhereTheTubeLies()
{
    const TryMetrics metrics = courseUntil(goodCourse(), 50.0);
    const TubeDepth depth = metrics.depth.value();
    QCOMPARE(inMillimetres(depth.atTeeth), 200.0);
    QCOMPARE(inMillimetres(depth.aboveCarina), 30.0);
    QCOMPARE(depth.at, courseTime(30.0));
}

void TestTryMetrics::takeTheDepthAtWhichTheTubeRestsInTheEnd()
{
    HandWrittenCourse course = goodCourse();
    course.deep(214.0, 16.0).sure(0.9).at(41.0, IntubationStep::AtRest, TubeSeat::Trachea);
    const TubeDepth depth = courseUntil(course, 50.0).depth.value();
    QCOMPARE(inMillimetres(depth.atTeeth), 214.0);
    QCOMPARE(inMillimetres(depth.aboveCarina), 16.0);
    QCOMPARE(depth.confidence, 0.9);
    QCOMPARE(depth.at, courseTime(41.0));
}

void TestTryMetrics::claimNoDepthWhereTheShapesParted()
{
    HandWrittenCourse course = goodCourse();
    course.at(32.0, IntubationStep::ShapesApart).at(33.0, IntubationStep::CuffInflated);
    QVERIFY(!courseUntil(course, 50.0).depth);
    course.at(34.0, IntubationStep::ShapesTogether);
    QVERIFY(courseUntil(course, 50.0).depth);
}

void TestTryMetrics::tellASideAndThatItWasPulledBack()
{
    HandWrittenCourse course = goodCourse();
    course.deep(260.0, -30.0).at(31.0, IntubationStep::PastCarina, TubeSeat::LeftMain);
    QCOMPARE(courseUntil(course, 50.0).outcome, TryOutcome::LeftMain);
    QCOMPARE(inMillimetres(courseUntil(course, 50.0).depth->aboveCarina), -30.0);
    HandWrittenCourse right = goodCourse();
    right.at(31.0, IntubationStep::PastCarina, TubeSeat::RightMain);
    QCOMPARE(courseUntil(right, 50.0).outcome, TryOutcome::RightMain);
    right.at(40.0, IntubationStep::BackAboveCarina, TubeSeat::Trachea);
    QCOMPARE(courseUntil(right, 50.0).outcome, TryOutcome::Trachea);
}

void TestTryMetrics::tellAnOesophagusThatWasRecognisedLate()
{
    const TryMetrics metrics = courseUntil(lateRecognition(), 105.0);
    QCOMPARE(metrics.outcome, TryOutcome::Trachea);
    QCOMPARE(metrics.oesophagus.size(), std::size_t{1});
    const OesophagealStay stay = metrics.oesophagus.front();
    QCOMPARE(stay.in, courseTime(20.0));
    QCOMPARE(stay.out, courseTime(60.0));
    QCOMPARE(metrics.firstBreath, courseTime(85.0)); // not that into the stomach
}

void TestTryMetrics::tellAnOesophagusThatWasNotRecognised()
{
    HandWrittenCourse course;
    course.at(10.0, IntubationStep::BladeIn)
        .at(17.0, IntubationStep::TubePastTeeth)
        .at(20.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus);
    const TryMetrics metrics = courseUntil(course, 200.0);
    QCOMPARE(metrics.outcome, TryOutcome::OesophagusUnrecognised);
    QVERIFY(!metrics.oesophagus.front().out);
    QVERIFY(!metrics.depth);
    QVERIFY(!metrics.firstBreath);
    QCOMPARE(metrics.bladeTime, Duration{std::chrono::seconds{190}}); // still in
}

/// It took the trachea for the oesophagus, and is told so by the way of the tip beyond.
void TestTryMetrics::believeAMonitorThatConcludesAnew()
{
    HandWrittenCourse course;
    course.at(10.0, IntubationStep::BladeIn)
        .at(20.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
        .at(21.0, IntubationStep::BladeOut)
        .at(20.0, IntubationStep::OutOfOesophagus, TubeSeat::None)
        .at(20.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
    const TryMetrics metrics = courseUntil(course, 60.0);
    QCOMPARE(metrics.outcome, TryOutcome::Trachea);
    QCOMPARE(metrics.throughCords, courseTime(20.0));
    QVERIFY(metrics.oesophagus.empty());
}

void TestTryMetrics::tellThatATryWasGivenUp()
{
    HandWrittenCourse course;
    course.at(10.0, IntubationStep::BladeIn).at(40.0, IntubationStep::BladeOut);
    QCOMPARE(courseUntil(course, 50.0).outcome, TryOutcome::Abandoned);
    course.at(51.0, IntubationStep::TubePastTeeth)
        .at(52.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
        .at(55.0, IntubationStep::OutOfOesophagus, TubeSeat::None);
    QCOMPARE(courseUntil(course, 70.0).outcome, TryOutcome::OesophagusRecognised);
}

void TestTryMetrics::forgetTheCuffOfATubeThatIsOut()
{
    HandWrittenCourse course = goodCourse();
    course.at(40.0, IntubationStep::BackAboveCords, TubeSeat::None)
        .at(41.0, IntubationStep::TubeOut)
        .at(44.0, IntubationStep::TubePastTeeth)
        .at(46.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
    QVERIFY(!courseUntil(course, 50.0).cuffInflated);
    course.at(48.0, IntubationStep::CuffInflated);
    QCOMPARE(courseUntil(course, 50.0).cuffInflated, courseTime(48.0));
}

void TestTryMetrics::countAttempts()
{
    QCOMPARE(courseUntil(lateRecognition(), 105.0).attempts,
             (std::vector{courseTime(10.0), courseTime(65.0)}));
    HandWrittenCourse blind; // without a laryngoscope that is seen
    blind.at(5.0, IntubationStep::TubePastTeeth);
    QCOMPARE(courseUntil(blind, 9.0).attempts, std::vector{courseTime(5.0)});
    QVERIFY(!courseUntil(blind, 9.0).hadBlade);
}

void TestTryMetrics::forgetAPassageThatWasUndone()
{
    HandWrittenCourse course = goodCourse();
    course.at(40.0, IntubationStep::BackAboveCords, TubeSeat::None);
    const TryMetrics metrics = courseUntil(course, 60.0);
    QCOMPARE(metrics.outcome, TryOutcome::Abandoned);
    QVERIFY(!metrics.throughCords);
    QVERIFY(!metrics.firstBreath);
    QVERIFY(!metrics.depth);
}

void TestTryMetrics::takeTheConfidenceOfTheLastSeat()
{
    HandWrittenCourse course;
    course.sure(0.9)
        .at(10.0, IntubationStep::BladeIn)
        .sure(0.4)
        .at(20.0, IntubationStep::ThroughCords, TubeSeat::Trachea)
        .sure(0.8)
        .at(30.0, IntubationStep::BladeOut);
    QCOMPARE(courseUntil(course, 60.0).confidence, 0.4);
}

CARINA_TEST(TestTryMetrics)

} // namespace carina::try_metrics_test

#include "tst_try_metrics.moc"
