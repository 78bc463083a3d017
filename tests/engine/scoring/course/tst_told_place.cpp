#include "engine/scoring/course/told_place.h"

#include "engine/scoring/course/try_metrics.h"
#include "tests/engine/scoring/course/hand_written_course.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <map>

namespace carina::told_place_test
{
namespace
{

using namespace carina::test;

/// What a person says, by the second at which they say it.
using Said = std::map<double, std::optional<TubeSeat>>;

/// The course of what was noted, with what was said of the place.
std::vector<IntubationEvent> courseWith(const HandWrittenCourse& noted, const Said& said)
{
    std::vector<ToldSeat> told;
    for (const auto& [seconds, seat] : said) {
        const SessionTime since = courseTime(seconds);
        const auto after = std::ranges::count_if(
            noted.events(), [since](const IntubationEvent& event) { return event.at <= since; });
        told.push_back({std::size_t(after), since, seat});
    }
    return courseAsTold(noted.events(), told);
}

TryMetrics metricsWith(const HandWrittenCourse& noted, const Said& said)
{
    return courseOf(courseWith(noted, said), courseTime(60.0));
}

} // namespace

class TestToldPlace : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesAllAsItIsNotedWhereNobodySaysAnything()
    {
        const HandWrittenCourse noted = lateRecognition();
        QVERIFY(courseWith(noted, {}) == noted.events());
    }

    void namesTheEndWhereverTheMonitorHasIt()
    {
        const std::map<TubeSeat, TryOutcome> ends{
            {TubeSeat::Trachea, TryOutcome::Trachea},
            {TubeSeat::RightMain, TryOutcome::RightMain},
            {TubeSeat::LeftMain, TryOutcome::LeftMain},
            {TubeSeat::Oesophagus, TryOutcome::OesophagusUnrecognised}};
        for (const auto& [seat, outcome] : ends)
            QCOMPARE(metricsWith(goodCourse(), {{40.0, seat}}).outcome, outcome);
        QCOMPARE(metricsWith(goodCourse(), {{40.0, TubeSeat::None}}).outcome,
                 TryOutcome::Abandoned);
    }

    /// It is where it is said to be since it passed the cords, at 20 s.
    void isInTheOesophagusSinceItPassed()
    {
        const TryMetrics metrics = metricsWith(goodCourse(), {{28.0, TubeSeat::Oesophagus}});
        QCOMPARE(metrics.oesophagus.size(), std::size_t{1});
        QCOMPARE(metrics.oesophagus[0].in, courseTime(20.0));
        QVERIFY(!metrics.oesophagus[0].out);
        QVERIFY(!metrics.throughCords);
        QVERIFY(!metrics.firstBreath);
        QVERIFY(!metrics.depth);
    }

    void isInTheTracheaSinceItPassed()
    {
        HandWrittenCourse course;
        course.at(10.0, IntubationStep::TubePastTeeth)
            .at(20.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
            .at(30.0, IntubationStep::CuffInflated);
        const TryMetrics metrics = metricsWith(course, {{25.0, TubeSeat::Trachea}});
        QCOMPARE(metrics.throughCords, courseTime(20.0));
        QVERIFY(metrics.oesophagus.empty());
    }

    /// Before and after the first breath, at 30 s.
    void leavesNothingOfWhatIsTakenBack()
    {
        const TryMetrics noted = courseOf(goodCourse().events(), courseTime(60.0));
        for (const double said : {22.0, 27.0, 32.0, 40.0}) {
            const TryMetrics metrics = metricsWith(
                goodCourse(), {{said, TubeSeat::Oesophagus}, {said + 5.0, std::nullopt}});
            QCOMPARE(metrics.outcome, TryOutcome::Trachea);
            QVERIFY(metrics.oesophagus.empty());
            QCOMPARE(metrics.throughCords, noted.throughCords);
            QCOMPARE(metrics.firstBreath, noted.firstBreath);
            QCOMPARE(metrics.confidence, noted.confidence);
        }
    }

    /// Each place gets its own first breath from the mechanics; of the tube it is one.
    void hasOneFirstBreathOfOneTube()
    {
        HandWrittenCourse course = goodCourse();
        course.at(35.0, IntubationStep::FirstBreath);
        QCOMPARE(metricsWith(course, {{32.0, TubeSeat::RightMain}}).firstBreath, courseTime(30.0));
        QVERIFY(!metricsWith(course, {{32.0, TubeSeat::Oesophagus}}).firstBreath);
        QCOMPARE(metricsWith(course, {{32.0, TubeSeat::RightMain}}).throughCords, courseTime(20.0));
    }

    /// Where it went after the cords does not matter.
    void datesWhatIsSaidFromTheCordsOn()
    {
        HandWrittenCourse course;
        course.at(10.0, IntubationStep::TubePastTeeth)
            .at(20.0, IntubationStep::ThroughCords, TubeSeat::Trachea)
            .at(35.0, IntubationStep::PastCarina, TubeSeat::RightMain)
            .at(40.0, IntubationStep::BackAboveCarina, TubeSeat::Trachea);
        const TryMetrics metrics = metricsWith(course, {{50.0, TubeSeat::Oesophagus}});
        QCOMPARE(metrics.oesophagus.at(0).in, courseTime(20.0));
    }

    /// It left at 60 s by the monitor, and was out at 61.
    void endsWithTheTubeThatItWasSaidOf()
    {
        const std::vector<IntubationEvent> course =
            courseWith(lateRecognition(), {{40.0, TubeSeat::RightMain}});
        const TryMetrics metrics = courseOf(course, courseTime(90.0));
        QCOMPARE(metrics.outcome, TryOutcome::Trachea);
        QVERIFY(metrics.oesophagus.empty());
        QCOMPARE(metrics.throughCords, courseTime(75.0));
        const std::vector<IntubationEvent> until61{
            course.begin(),
            std::ranges::find(course, IntubationStep::TubeOut, &IntubationEvent::step)};
        QCOMPARE(until61.back().step, IntubationStep::BackAboveCords);
        QCOMPARE(until61.back().at, courseTime(60.0));
    }

    /// As with the arrows in a list.
    void believesWhatIsSaidLast()
    {
        const TryMetrics metrics =
            metricsWith(goodCourse(), {{40.0, TubeSeat::Oesophagus}, {50.0, TubeSeat::LeftMain}});
        QCOMPARE(metrics.outcome, TryOutcome::LeftMain);
        QVERIFY(metrics.oesophagus.empty());
        QCOMPARE(metrics.throughCords, courseTime(20.0));
    }

    /// Drawn back and pushed on between them: the monitor sees the depth.
    void datesAnotherPlaceFromTheNextPassage()
    {
        HandWrittenCourse course = goodCourse();
        course.at(40.0, IntubationStep::BackAboveCords, TubeSeat::None)
            .at(45.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
        const TryMetrics still = metricsWith(course, {{35.0, TubeSeat::Oesophagus}});
        QVERIFY(!still.throughCords); // by the monitor alone
        QVERIFY(!still.oesophagus.at(0).out);
        const TryMetrics metrics =
            metricsWith(course, {{35.0, TubeSeat::Oesophagus}, {50.0, TubeSeat::Trachea}});
        QCOMPARE(metrics.outcome, TryOutcome::Trachea);
        QCOMPARE(metrics.oesophagus.at(0).in, courseTime(20.0));
        QCOMPARE(metrics.oesophagus.at(0).out, courseTime(45.0));
        QCOMPARE(metrics.throughCords, courseTime(45.0));
    }

    /// The monitor has the tip above the cords all the while.
    void holdsAboveTheCordsSinceItIsSaid()
    {
        HandWrittenCourse course;
        course.at(10.0, IntubationStep::TubePastTeeth).at(40.0, IntubationStep::CuffInflated);
        const Said said{{30.0, TubeSeat::Oesophagus}};
        const TryMetrics there = metricsWith(course, said);
        QCOMPARE(there.outcome, TryOutcome::OesophagusUnrecognised);
        QCOMPARE(there.oesophagus.at(0).in, courseTime(30.0));
        course.at(50.0, IntubationStep::TubeOut);
        const TryMetrics out = metricsWith(course, said);
        QCOMPARE(out.outcome, TryOutcome::OesophagusRecognised);
        QCOMPARE(out.oesophagus.at(0).out, courseTime(50.0));
        const TryMetrics ended =
            metricsWith(course, {{30.0, TubeSeat::Oesophagus}, {51.0, std::nullopt}});
        QVERIFY(ended == out); // the setting ends with the tube
    }

    void leavesNothingAboveTheCordsOfWhatIsTakenBack()
    {
        HandWrittenCourse course;
        course.at(10.0, IntubationStep::TubePastTeeth).at(33.0, IntubationStep::CuffInflated);
        const TryMetrics noted = metricsWith(course, {});
        const Said takenBack{{30.0, TubeSeat::Oesophagus}, {35.0, std::nullopt}};
        QVERIFY(metricsWith(course, takenBack) == noted);
    }

    /// Where the monitor has the tip above the cords; another way has another breath.
    void hasTheBreathOfAPlaceThatIsCorrected()
    {
        HandWrittenCourse course;
        course.at(10.0, IntubationStep::TubePastTeeth).at(12.0, IntubationStep::FirstBreath);
        const Said refined{{11.0, TubeSeat::Trachea}, {20.0, TubeSeat::RightMain}};
        QCOMPARE(metricsWith(course, refined).firstBreath, courseTime(12.0));
        QCOMPARE(metricsWith(course, refined).throughCords, courseTime(11.0));
        course.at(22.0, IntubationStep::FirstBreath);
        const Said corrected{{11.0, TubeSeat::Oesophagus}, {20.0, TubeSeat::Trachea}};
        QCOMPARE(metricsWith(course, corrected).firstBreath, courseTime(12.0));
        QVERIFY(metricsWith(course, corrected).oesophagus.empty());
        const Said late{{20.0, TubeSeat::Trachea}}; // what was blown before went elsewhere
        QCOMPARE(metricsWith(course, late).firstBreath, courseTime(22.0));
    }

    /// The tip went on to the right, and came to rest deeper, after the first breath.
    void tellsOfTheEndWhatWasNotedLast()
    {
        HandWrittenCourse course = goodCourse();
        course.deep(260.0, -20.0)
            .at(40.0, IntubationStep::PastCarina, TubeSeat::RightMain)
            .deep(265.0, -25.0)
            .at(42.0, IntubationStep::AtRest);
        const TryMetrics noted = metricsWith(course, {});
        QCOMPARE(noted.outcome, TryOutcome::RightMain);
        const Said takenBack{{45.0, TubeSeat::Oesophagus}, {50.0, std::nullopt}};
        QVERIFY(metricsWith(course, takenBack) == noted);
        const TryMetrics told = metricsWith(course, {{45.0, TubeSeat::LeftMain}});
        QCOMPARE(told.outcome, TryOutcome::LeftMain);
        QCOMPARE(told.depth->atTeeth, millimetres(265.0));
        QCOMPARE(told.firstBreath, courseTime(30.0));
        const TryMetrics drawnBack = metricsWith(course, {{45.0, TubeSeat::Trachea}});
        QCOMPARE(drawnBack.depth->atTeeth, millimetres(265.0));
    }

    /// The tip stays where it is said to be as it passes the carina.
    void tellsTheDepthOfAPassageThatIsLeftOut()
    {
        HandWrittenCourse course = goodCourse();
        course.deep(260.0, -20.0).at(40.0, IntubationStep::PastCarina, TubeSeat::RightMain);
        const TryMetrics told = metricsWith(course, {{35.0, TubeSeat::Trachea}});
        QCOMPARE(told.outcome, TryOutcome::Trachea);
        QCOMPARE(told.depth->atTeeth, millimetres(260.0));
    }

    void isAsSureAsWhoSaysIt()
    {
        HandWrittenCourse course;
        course.at(10.0, IntubationStep::TubePastTeeth)
            .sure(0.25)
            .at(20.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
        QCOMPARE(metricsWith(course, {}).confidence, 0.25);
        QCOMPARE(metricsWith(course, {{30.0, TubeSeat::Oesophagus}}).confidence, 1.0);
        const Said takenBack{{30.0, TubeSeat::Oesophagus}, {40.0, std::nullopt}};
        QCOMPARE(metricsWith(course, takenBack).confidence, 0.25);
        course.sure(0.98).at(25.0, IntubationStep::BladeOut);
        QCOMPARE(metricsWith(course, takenBack).confidence, 0.25); // 0.98 of the blade
    }

    void knowsWhatIsSaidAtTheEnd()
    {
        const std::vector<IntubationEvent> good = goodCourse().events();
        const ToldSeat said{5, courseTime(25.0), TubeSeat::Oesophagus};
        QVERIFY(!toldAtEnd(good, {}));
        QCOMPARE(toldAtEnd(good, std::vector{said}), TubeSeat::Oesophagus);
        QVERIFY(!toldAtEnd(good, std::vector{said, {6, courseTime(27.0), std::nullopt}}));
        HandWrittenCourse out = goodCourse();
        out.at(40.0, IntubationStep::TubeOut, TubeSeat::None);
        QVERIFY(!toldAtEnd(out.events(), std::vector{said}));
    }
};

CARINA_TEST(TestToldPlace)

} // namespace carina::told_place_test

#include "tst_told_place.moc"
