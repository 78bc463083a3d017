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
    ToldPlace place;
    std::vector<IntubationEvent> course;
    auto next = said.begin();
    const auto add = [&course](const std::vector<IntubationEvent>& steps) {
        course.insert(course.end(), steps.begin(), steps.end());
    };
    const auto sayUntil = [&](SessionTime t) {
        for (; next != said.end() && courseTime(next->first) < t; ++next)
            add(place.told(next->second, courseTime(next->first)));
    };
    for (const IntubationEvent& event : noted.events()) {
        sayUntil(event.at);
        add(place.noted(event));
    }
    sayUntil(SessionTime::max());
    return course;
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
        QVERIFY(metrics.oesophagus[0].wasVentilated); // at 30 s
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

    void leavesNothingOfWhatIsTakenBack()
    {
        const TryMetrics metrics =
            metricsWith(goodCourse(), {{27.0, TubeSeat::Oesophagus}, {28.0, std::nullopt}});
        QCOMPARE(metrics.outcome, TryOutcome::Trachea);
        QVERIFY(metrics.oesophagus.empty());
        QCOMPARE(metrics.throughCords, courseTime(20.0));
        QCOMPARE(metrics.firstBreath, courseTime(30.0));
    }

    /// The monitor sees it leave at 60 s, and out at 61.
    void endsWithTheTubeThatItWasSaidOf()
    {
        const std::vector<IntubationEvent> course =
            courseWith(lateRecognition(), {{40.0, TubeSeat::Oesophagus}});
        const TryMetrics metrics = courseOf(course, courseTime(90.0));
        QCOMPARE(metrics.outcome, TryOutcome::Trachea);
        QCOMPARE(metrics.oesophagus.size(), std::size_t{1});
        QCOMPARE(metrics.oesophagus[0].in, courseTime(20.0));
        QCOMPARE(metrics.oesophagus[0].out, courseTime(61.0));
        QCOMPARE(metrics.throughCords, courseTime(75.0));
    }

    void passesItsOwnWayBetweenTwoPlaces()
    {
        const TryMetrics metrics =
            metricsWith(goodCourse(), {{40.0, TubeSeat::Oesophagus}, {50.0, TubeSeat::LeftMain}});
        QCOMPARE(metrics.outcome, TryOutcome::LeftMain);
        QCOMPARE(metrics.oesophagus[0].in, courseTime(20.0));
        QCOMPARE(metrics.oesophagus[0].out, courseTime(50.0));
        QCOMPARE(metrics.throughCords, courseTime(50.0));
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
    }
};

CARINA_TEST(TestToldPlace)

} // namespace carina::told_place_test

#include "tst_told_place.moc"
