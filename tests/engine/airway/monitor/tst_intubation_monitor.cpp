#include "engine/airway/monitor/intubation_monitor.h"
#include "tests/engine/airway/monitor/monitored_run.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <utility>

namespace carina::intubation_monitor_test
{

using test::Disturbance;
using test::inserted;
using test::momentsOf;
using test::monitored;
using test::MonitoredRun;
using test::Motion;
using test::Route;
using test::secondsOf;

namespace
{

constexpr double kTime = 0.1;          // s
constexpr double kDepth = 3e-3;        // m
constexpr double kRegistration = 6e-3; // m, three times its error at the cords in any direction
constexpr double kSpeed = 0.04;        // m/s, of the tube
constexpr double kFrom = 0.060;        // m in front of the teeth the tube waits until 1 s

double timeAt(double along) { return 1.0 + (kFrom + along) / kSpeed; }

/// In at `from`, and out again some time later.
double bladeAt(double t, double from, double until)
{
    constexpr double kFastest = 0.2; // m/s
    return std::clamp(std::min(kFastest * (t - from), kFastest * (until - t)), -0.05, 0.045);
}

bool isOne(const MonitoredRun& run, IntubationStep step, double seconds)
{
    const auto found = run.of(step);
    return found.size() == 1 && std::abs(secondsOf(found.front()) - seconds) < kTime;
}

/// A tip past the cords, as it lies between the ways.
AirwayMoment beyondCords(double seconds, double past, double towardsOesophagus)
{
    AirwayMoment moment;
    moment.at = SessionTime{fromSeconds(seconds)};
    moment.tube = Validity::Tracked;
    moment.p_A_tip = {0.0, 0.0, 0.125 - past};
    moment.pastTeeth = metres(0.09 + past);
    moment.pastCords = metres(past);
    moment.measuredPastCords = moment.pastCords;
    moment.towardsOesophagus = metres(towardsOesophagus);
    moment.tracheaToOesophagus = millimetres(14.0);
    moment.aboveCarina = metres(0.125 - past);
    moment.depthAtTeeth = moment.pastTeeth;
    return moment;
}

/// A tip that goes 40 mm/s, from 20 mm above the cords' plane at 0 s.
template <class Towards> std::vector<AirwayMoment> downwards(double to, Towards towardsOesophagus)
{
    std::vector<AirwayMoment> moments;
    for (int i = 0; i < 300; ++i) {
        const double past = std::min(kSpeed * 0.02 * i - 0.02, to);
        moments.push_back(beyondCords(0.02 * i, past, towardsOesophagus(past)));
    }
    return moments;
}

/// Both shapes of the tube are apart from a depth behind the cords on.
std::vector<AirwayMoment> bent(std::vector<AirwayMoment> moments, double by, double from = -0.02)
{
    for (AirwayMoment& moment : moments)
        if (moment.pastCords.si >= from)
            moment.besides = metres(by);
    return moments;
}

/// A tip that goes on into the left main bronchus, so far behind the carina.
std::vector<AirwayMoment> intoTheLeft(double behindCarina)
{
    auto moments = downwards(0.125 + behindCarina, [](double) { return -0.007; });
    for (AirwayMoment& moment : moments)
        if (moment.aboveCarina < Length{}) {
            moment.towardsLeft = -0.4 * moment.aboveCarina;
            moment.rightToLeft = -0.9 * moment.aboveCarina;
        }
    return moments;
}

} // namespace

class TestIntubationMonitor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void notesAGoodIntubationInItsOrder()
    {
        std::mt19937 random{1};
        const Motion motion{.tip = inserted(0.190, kSpeed),
                            .blade = [](double t) { return bladeAt(t, 0.5, 8.0); },
                            .seconds = 12.0};
        const MonitoredRun run = monitored(momentsOf(Route::Trachea, motion, {}, random));
        const double cords = test::cordsAlong(test::drawnWays(), Route::Trachea);
        QVERIFY(isOne(run, IntubationStep::BladeIn, 0.5));
        QVERIFY(isOne(run, IntubationStep::GlottisSeen, 0.5 + 0.03 / 0.2));
        QVERIFY(isOne(run, IntubationStep::TubePastTeeth, timeAt(0.0)));
        QVERIFY(isOne(run, IntubationStep::ThroughCords, timeAt(cords)));
        QVERIFY(isOne(run, IntubationStep::BladeOut, 8.0));
        QCOMPARE(run.events.size(), 5U);
        const IntubationEvent through = run.of(IntubationStep::ThroughCords).front();
        QCOMPARE(through.seat, TubeSeat::Trachea);
        QVERIFY(std::abs(through.depthAtTeeth.si - cords) < kDepth);
        QVERIFY(std::abs(through.tipAboveCarina.si - 0.125) < kDepth);
        QVERIFY(through.glotticOpening == 0.6 && through.confidence > 0.95);
        QCOMPARE(run.course.attempts, 1);
        QVERIFY(std::abs(run.course.tip.depthAtTeeth.si - 0.190) < kDepth);
        QVERIFY(run.course.confidence > 0.95);
    }

    /// The view begins small; what is told is the most of it that was seen in the attempt.
    void tellsTheLargestViewOfAnAttempt()
    {
        IntubationMonitor monitor;
        std::vector<IntubationEvent> events;
        const auto look = [&](double from, double to, double inMouth, double opening) {
            for (int i = int(50.0 * from); i < int(50.0 * to); ++i) {
                AirwayMoment moment;
                moment.at = SessionTime{fromSeconds(0.02 * i)};
                moment.blade = Validity::Tracked;
                moment.bladePastTeeth = metres(inMouth);
                moment.glottis = opening;
                std::ranges::copy(monitor.take(moment), std::back_inserter(events));
            }
        };
        look(0.0, 1.0, -0.05, 0.0);
        look(1.0, 2.0, 0.04, 0.1);
        look(2.0, 3.0, 0.04, 0.7);
        look(3.0, 4.0, 0.04, 0.2);
        look(4.0, 7.0, -0.05, 0.0);
        look(7.0, 8.0, 0.04, 0.3);
        const MonitoredRun run{events, monitor.course()};
        QCOMPARE(run.of(IntubationStep::GlottisSeen).at(0).glotticOpening, 0.1);
        QCOMPARE(run.of(IntubationStep::BladeOut).at(0).glotticOpening, 0.7);
        QCOMPARE(run.of(IntubationStep::GlottisSeen).at(1).glotticOpening, 0.3);
    }

    void tellsWhereTheTubeWent_data()
    {
        QTest::addColumn<int>("route");
        QTest::addColumn<double>("depth");
        QTest::addColumn<int>("seat");
        QTest::newRow("trachea") << int(Route::Trachea) << 0.190 << int(TubeSeat::Trachea);
        QTest::newRow("oesophagus") << int(Route::Oesophagus) << 0.190 << int(TubeSeat::Oesophagus);
        QTest::newRow("right") << int(Route::RightMain) << 0.237 << int(TubeSeat::RightMain);
        QTest::newRow("left") << int(Route::LeftMain) << 0.237 << int(TubeSeat::LeftMain);
        QTest::newRow("too shallow") << int(Route::Trachea) << 0.080 << int(TubeSeat::None);
    }

    /// Twenty registrations, each with noise and dropouts.
    void tellsWhereTheTubeWent()
    {
        QFETCH(const int, route);
        QFETCH(const double, depth);
        QFETCH(const int, seat);
        const PatientWays ways = test::drawnWays();
        const double cords = test::cordsAlong(ways, Route(route));
        for (unsigned seed = 0; seed < 20; ++seed) {
            std::mt19937 random{seed};
            Disturbance disturbance;
            disturbance.X_AA = test::drawnRegistration(random, ways.p_A_incisors());
            const Motion motion{.tip = inserted(depth, kSpeed), .seconds = 9.5};
            const MonitoredRun run =
                monitored(momentsOf(Route(route), motion, disturbance, random));
            QCOMPARE(int(run.course.seat), seat);
            QVERIFY(std::abs(run.course.tip.depthAtTeeth.si - depth) < kDepth + kRegistration);
            const bool isInOesophagus = TubeSeat(seat) == TubeSeat::Oesophagus;
            const auto passed = run.of(isInOesophagus ? IntubationStep::InOesophagus
                                                      : IntubationStep::ThroughCords);
            const std::size_t once = TubeSeat(seat) == TubeSeat::None ? 0 : 1;
            QCOMPARE(passed.size(), once);
            for (const IntubationEvent& event : passed)
                QVERIFY(std::abs(secondsOf(event) - timeAt(cords))
                        < kTime + kRegistration / kSpeed);
            const bool isPastCarina = depth > 0.22;
            QCOMPARE(run.events.size(), 1 + once + (isPastCarina ? 1 : 0));
        }
    }

    /// The third time the blade goes in again after a second: that is no other attempt.
    void countsAttempts()
    {
        std::mt19937 random{2};
        const auto blade = [](double t) {
            return std::max({bladeAt(t, 1.0, 4.0), bladeAt(t, 7.0, 9.0), bladeAt(t, 12.0, 14.0),
                             bladeAt(t, 15.0, 18.0)});
        };
        const MonitoredRun run = monitored(momentsOf(
            Route::Trachea, {.tip = inserted(-0.05, kSpeed), .blade = blade, .seconds = 22.0}, {},
            random));
        QCOMPARE(run.course.attempts, 3);
        const auto in = run.of(IntubationStep::BladeIn);
        const auto out = run.of(IntubationStep::BladeOut);
        QVERIFY(in.size() == 3 && out.size() == 3);
        for (const auto& [event, seconds] :
             {std::pair{in[0], 1.0}, std::pair{in[1], 7.0}, std::pair{in[2], 12.0},
              std::pair{out[0], 4.0}, std::pair{out[1], 9.0}, std::pair{out[2], 18.0}})
            QVERIFY(std::abs(secondsOf(event) - seconds) < kTime);
        QCOMPARE(run.of(IntubationStep::GlottisSeen).size(), 3U);
    }

    /// A neck that is flexed shortens the way: the carina comes 30 mm towards a tip that was 10 mm
    /// above it, and goes again.
    void neckFlexedAfterwardsTakesTheTipPastTheCarina()
    {
        std::mt19937 random{3};
        const auto waysAt = [](double t) {
            const double d = std::clamp(std::min(0.02 * (t - 10.0), 0.02 * (15.0 - t)), 0.0, 0.03);
            return moved(test::drawnWays(), [d](const Vec3& p) {
                return Vec3{p + d * std::clamp(1.0 - p.z() / 0.125, 0.0, 1.0) * Vec3::UnitZ()};
            });
        };
        const double depth = lengthOf(test::drawnWays().overTongue).si + 0.115;
        const MonitoredRun run = monitored(momentsOf(
            Route::Trachea, {.tip = inserted(depth, kSpeed), .seconds = 18.0}, {}, random, waysAt));
        QVERIFY(isOne(run, IntubationStep::PastCarina, 10.5));
        QVERIFY(isOne(run, IntubationStep::BackAboveCarina, 14.5));
        QCOMPARE(run.of(IntubationStep::PastCarina).front().seat, TubeSeat::RightMain);
        QCOMPARE(run.course.seat, TubeSeat::Trachea);
        QVERIFY(run.of(IntubationStep::BackAboveCords).empty());
    }

    void tubeTakenOutIsToldStepByStep()
    {
        std::mt19937 random{4};
        const auto tip = [](double t) {
            return std::min(inserted(0.190, kSpeed)(t), inserted(0.190, kSpeed)(17.0 - t));
        };
        const MonitoredRun run =
            monitored(momentsOf(Route::Oesophagus, {.tip = tip, .seconds = 17.0}, {}, random));
        const double cords = test::cordsAlong(test::drawnWays(), Route::Oesophagus);
        QVERIFY(isOne(run, IntubationStep::InOesophagus, timeAt(cords)));
        QVERIFY(isOne(run, IntubationStep::OutOfOesophagus, 17.0 - timeAt(cords)));
        QVERIFY(isOne(run, IntubationStep::TubeOut, 17.0 - timeAt(0.0)));
        QCOMPARE(run.course.seat, TubeSeat::None);
    }

    void jumpingSampleIsLeftOut()
    {
        std::mt19937 random{5};
        auto moments = momentsOf(Route::Trachea, {.tip = inserted(0.060, kSpeed)}, {}, random);
        const MonitoredRun calm = monitored(moments);
        AirwayMoment& jump = moments[300];
        jump = beyondCords(toSeconds(jump.at.time_since_epoch()), 0.13, -0.007);
        jump.aboveCarina = millimetres(-5.0);
        const MonitoredRun jumping = monitored(moments);
        QVERIFY(jumping.events == calm.events);
        QCOMPARE(jumping.course.seat, TubeSeat::None);
    }

    /// Shallow places spoke for the oesophagus; ten deeper ones do not.
    void evidenceTurnsWhatWasConcluded()
    {
        const auto moments =
            downwards(0.08, [](double past) { return past < 0.010 ? 0.005 : -0.007; });
        const MonitoredRun run = monitored(moments);
        QVERIFY(isOne(run, IntubationStep::InOesophagus, 0.5));
        QVERIFY(isOne(run, IntubationStep::OutOfOesophagus, 0.5));
        QVERIFY(isOne(run, IntubationStep::ThroughCords, 0.5));
        QVERIFY(run.of(IntubationStep::InOesophagus).front().confidence < run.course.confidence);
        QCOMPARE(run.course.seat, TubeSeat::Trachea);
    }

    /// At 20 mm it has to be concluded, from odds of 1.5 to 1; what is seen farther down is odds of
    /// some 8 to 1 against it in all.
    void evidenceTurnsSoonerWhatWasConcludedFromLittle()
    {
        const auto moments =
            downwards(0.08, [](double past) { return past < 0.022 ? -0.0002 : 0.0013; });
        const MonitoredRun run = monitored(moments);
        QVERIFY(isOne(run, IntubationStep::ThroughCords, 0.5));
        QVERIFY(run.of(IntubationStep::ThroughCords).front().confidence < 0.7);
        QVERIFY(isOne(run, IntubationStep::InOesophagus, 0.5));
        QCOMPARE(run.course.seat, TubeSeat::Oesophagus);
        QVERIFY(run.course.confidence > 0.75 && run.course.confidence < 0.95);
    }

    void strongConclusionStaysWhereWeakEvidenceComesAfterIt()
    {
        const auto moments =
            downwards(0.04, [](double past) { return past < 0.010 ? -0.005 : 0.0028; });
        const MonitoredRun run = monitored(moments);
        QCOMPARE(run.course.seat, TubeSeat::Trachea);
        QVERIFY(run.of(IntubationStep::InOesophagus).empty());
        QVERIFY(run.course.confidence <= 0.5); // it is against what is concluded
    }

    void doubtfulPlaceHasLittleConfidence()
    {
        const MonitoredRun run = monitored(downwards(0.08, [](double) { return -0.0003; }));
        QCOMPARE(run.course.seat, TubeSeat::Trachea);
        QVERIFY(run.of(IntubationStep::ThroughCords).front().confidence < 0.7);
        QVERIFY(run.course.confidence < 0.7);
    }

    /// Where the connector does not tell the way, what usually happens does.
    void bentTubeIsTakenToBeInTheTrachea()
    {
        for (const double towards : {-0.006, 0.0, 0.006}) {
            const auto rigid = downwards(0.08, [towards](double) { return towards; });
            const MonitoredRun run = monitored(bent(rigid, 0.03));
            QCOMPARE(run.course.seat, TubeSeat::Trachea);
            QVERIFY(isOne(run, IntubationStep::ThroughCords, 0.5));
            QVERIFY(run.of(IntubationStep::InOesophagus).empty());
            QVERIFY(run.course.confidence < 0.45);
        }
    }

    /// What usually happens is no evidence of this tube: nothing less sure is ever said of a way.
    void verdictByWhatIsUsualIsTheLeastSure()
    {
        const auto against = downwards(0.08, [](double) { return 0.006; });
        const MonitoredRun usual = monitored(bent(against, 0.03));
        QCOMPARE(usual.course.seat, TubeSeat::Trachea);
        QCOMPARE(usual.course.confidence, 0.4);
        QCOMPARE(usual.of(IntubationStep::ThroughCords).front().confidence, 0.4);
        const auto with = downwards(0.08, [](double) { return -0.006; });
        const MonitoredRun seen = monitored(bent(with, 0.006));
        QVERIFY(seen.course.confidence > 0.7 && seen.course.confidence <= 0.8);
    }

    void evidenceOfALittleBentTubeOverrulesWhatIsUsual()
    {
        const MonitoredRun run =
            monitored(bent(downwards(0.08, [](double) { return 0.007; }), 0.006));
        QCOMPARE(run.course.seat, TubeSeat::Oesophagus);
        QVERIFY(run.course.confidence <= 0.8);
    }

    /// As one whose stylet was drawn behind the cords.
    void tubeThatBendsFartherDownStaysWhereItWent()
    {
        const auto moments =
            downwards(0.08, [](double past) { return past < 0.025 ? 0.007 : -0.007; });
        const MonitoredRun run = monitored(bent(moments, 0.02, 0.025));
        QCOMPARE(run.course.seat, TubeSeat::Oesophagus);
        QVERIFY(isOne(run, IntubationStep::InOesophagus, 0.5));
        QVERIFY(run.of(IntubationStep::OutOfOesophagus).empty());
    }

    /// They agree where the tube rests; the way was taken by what is usual, against the evidence.
    void shapesThatComeTogetherMakeNoVerdictSurer()
    {
        auto moments = bent(downwards(0.08, [](double) { return 0.003; }), 0.03);
        for (AirwayMoment& moment : moments)
            if (moment.at > SessionTime{std::chrono::seconds{4}})
                moment.besides = {};
        const MonitoredRun run = monitored(moments);
        QVERIFY(!run.course.shapes.isIn);
        QCOMPARE(run.course.seat, TubeSeat::Trachea);
        QCOMPARE(run.course.confidence, 0.5);
    }

    /// More depth tells no more of it.
    void bentTubeIsConcludedEarlier()
    {
        const auto shallow = downwards(0.013, [](double) { return 0.0; });
        QCOMPARE(monitored(shallow).course.seat, TubeSeat::None);
        QCOMPARE(monitored(bent(shallow, 0.03)).course.seat, TubeSeat::Trachea);
        const MonitoredRun left = monitored(bent(intoTheLeft(0.013), 0.03));
        QCOMPARE(left.course.seat, TubeSeat::LeftMain);
        QVERIFY(left.course.confidence < 0.45);
    }

    void passageThatNobodySawIsLessSure()
    {
        auto moments = downwards(0.08, [](double) { return -0.007; });
        const MonitoredRun seen = monitored(moments);
        for (AirwayMoment& moment : moments)
            if (std::abs(moment.pastCords.si) < 0.006)
                moment.tube = Validity::Lost;
        const MonitoredRun unseen = monitored(moments);
        QVERIFY(isOne(unseen, IntubationStep::ThroughCords, 0.5));
        const double before = seen.of(IntubationStep::ThroughCords).front().confidence;
        const double after = unseen.of(IntubationStep::ThroughCords).front().confidence;
        QVERIFY(before > 0.95 && after < 0.75);
    }

    void depthIsFrozenWhileTheShapesAreApart()
    {
        auto moments = downwards(0.08, [](double) { return -0.007; });
        for (std::size_t i = 0; i < moments.size(); ++i)
            if (i >= 100 && i < 200) {
                moments[i].besides = millimetres(8.0);
                moments[i].depthAtTeeth = moments[i].depthAtTeeth + millimetres(12.0);
            }
        IntubationMonitor monitor;
        std::vector<IntubationEvent> events;
        for (std::size_t i = 0; i < moments.size(); ++i) {
            std::ranges::copy(monitor.take(moments[i]), std::back_inserter(events));
            if (i == 95)
                QVERIFY(monitor.course().confidence > 0.95);
            if (i == 150) {
                const IntubationEvent told =
                    monitor.told(IntubationStep::CuffInflated, moments[i].at);
                QVERIFY(told.confidence <= 0.8);
                QVERIFY(std::abs(told.besides.si - 0.008) < 1e-9);
            }
        }
        const MonitoredRun run{events, monitor.course()};
        QVERIFY(isOne(run, IntubationStep::ShapesApart, 2.0));
        QVERIFY(isOne(run, IntubationStep::ShapesTogether, 4.0));
        QVERIFY(std::abs(run.course.tip.depthAtTeeth.si - 0.17) < kDepth);
    }

    void frozenDepthIsNotThatOfTheMoment()
    {
        auto moments = downwards(0.02, [](double) { return -0.007; });
        IntubationMonitor monitor;
        Length frozen{};
        for (std::size_t i = 0; i < moments.size(); ++i) {
            if (i >= 100)
                moments[i].besides = millimetres(8.0);
            if (i >= 150)
                moments[i].depthAtTeeth = millimetres(200.0);
            (void)monitor.take(moments[i]);
            if (i == 140)
                frozen = monitor.course().tip.depthAtTeeth;
        }
        QVERIFY(monitor.course().shapes.isIn);
        QVERIFY(monitor.course().tip.depthAtTeeth == frozen);
    }

    void realTubeThatPassesShutCordsIsToldOnce()
    {
        auto moments = downwards(0.04, [](double) { return -0.007; });
        const auto withShut = [&](bool atPassage) {
            auto shut = moments;
            for (AirwayMoment& moment : shut) {
                moment.areCordsShut = atPassage || moment.at > SessionTime{std::chrono::seconds{3}};
                if (atPassage)
                    moment.pastCords = std::min(moment.pastCords, millimetres(-1.0));
            }
            return monitored(shut);
        };
        const MonitoredRun passed = withShut(true);
        QVERIFY(isOne(passed, IntubationStep::PassedShut, 0.5));
        QCOMPARE(passed.course.seat, TubeSeat::None);
        QVERIFY(withShut(false).of(IntubationStep::PassedShut).empty());
    }

    void bladeThatIsNeverSeenAgainIsOut()
    {
        std::vector<AirwayMoment> moments;
        for (int i = 0; i < 800; ++i) {
            AirwayMoment moment;
            moment.at = SessionTime{fromSeconds(0.02 * i)};
            moment.blade = i < 100 ? Validity::Tracked : Validity::Lost;
            moment.bladePastTeeth = millimetres(i < 50 ? -20.0 : 40.0);
            moments.push_back(moment);
        }
        const MonitoredRun run = monitored(moments);
        QVERIFY(isOne(run, IntubationStep::BladeIn, 1.0));
        QVERIFY(isOne(run, IntubationStep::BladeOut, 2.0));
    }

    /// A copy of the course goes on as the one it was copied from.
    void courseIsACheckpoint()
    {
        std::mt19937 random{6};
        const auto moments = momentsOf(
            Route::LeftMain, {.tip = inserted(0.237, kSpeed), .seconds = 9.5}, {}, random);
        const MonitoredRun whole = monitored(moments);
        for (const std::size_t at : {50U, 190U, 245U, 400U}) {
            IntubationMonitor first;
            std::vector<IntubationEvent> events;
            for (std::size_t i = 0; i < at; ++i)
                std::ranges::copy(first.take(moments[i]), std::back_inserter(events));
            IntubationMonitor second{{}, first.course()};
            for (std::size_t i = at; i < moments.size(); ++i)
                std::ranges::copy(second.take(moments[i]), std::back_inserter(events));
            QVERIFY(events == whole.events);
            QVERIFY(second.course() == whole.course);
        }
    }

    void momentThatIsNotLaterSaysNothing()
    {
        const auto moments = downwards(0.08, [](double) { return -0.007; });
        IntubationMonitor monitor;
        for (const AirwayMoment& moment : moments) {
            (void)monitor.take(moment);
            const IntubationCourse before = monitor.course();
            QVERIFY(monitor.take(moment).empty() && monitor.course() == before);
        }
    }
};

CARINA_TEST(TestIntubationMonitor)

} // namespace carina::intubation_monitor_test

#include "tst_intubation_monitor.moc"
