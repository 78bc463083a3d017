#include "engine/airway/monitor/intubation_monitor.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace carina::monitor_limits_test
{

using std::chrono::milliseconds;

namespace
{

constexpr milliseconds kStep{20};
const double kError = std::hypot(1.5e-3, std::numbers::pi / 180.0 * 0.100); // m, at the cords

/// A tip 10 mm past the teeth, above the cords.
AirwayMoment inMouth()
{
    AirwayMoment moment;
    moment.tube = Validity::Tracked;
    moment.blade = Validity::Tracked;
    moment.bladePastTeeth = millimetres(-30.0);
    moment.pastTeeth = millimetres(10.0);
    moment.pastCords = millimetres(-60.0);
    moment.measuredPastCords = moment.pastCords;
    moment.tracheaToOesophagus = millimetres(14.0);
    moment.towardsOesophagus = millimetres(-7.0);
    moment.aboveCarina = millimetres(100.0);
    return moment;
}

AirwayMoment inTrachea(double pastCords, double aboveCarina)
{
    AirwayMoment moment = inMouth();
    moment.pastTeeth = millimetres(150.0);
    moment.pastCords = metres(pastCords);
    moment.measuredPastCords = moment.pastCords;
    moment.aboveCarina = metres(aboveCarina);
    return moment;
}

/// One second of a moment.
void stay(IntubationMonitor& monitor, AirwayMoment moment, SessionTime& now)
{
    for (int i = 0; i < 50; ++i) {
        now += kStep;
        moment.at = now;
        static_cast<void>(monitor.take(moment));
    }
}

/// How long after its first moment on the other side a passage is known, the values being steady.
std::optional<milliseconds> knownAfter(const AirwayMoment& before, AirwayMoment after,
                                       IntubationStep step)
{
    IntubationMonitor monitor;
    SessionTime now{};
    stay(monitor, before, now);
    for (milliseconds since{0}; since < milliseconds{4000}; since += kStep) {
        now += kStep;
        after.at = now;
        for (const IntubationEvent& noted : monitor.take(after))
            if (noted.step == step)
                return since;
    }
    return std::nullopt;
}

double below(double sigmas) { return 0.5 * (1.0 + std::erf(sigmas / std::sqrt(2.0))); }

} // namespace

class TestMonitorLimits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// How far and for how long a value is on the other side until that is a passage.
    void passageIsKnownInItsTime_data()
    {
        using Change = std::function<void(AirwayMoment&)>;
        QTest::addColumn<Change>("before");
        QTest::addColumn<Change>("after");
        QTest::addColumn<int>("step");
        QTest::addColumn<int>("known_ms"); // -1: never
        const auto row = [](const char* name, Length AirwayMoment::*value, double before_mm,
                            double after_mm, IntubationStep step, int known_ms) {
            QTest::newRow(name) << Change{[=](AirwayMoment& moment) {
                moment.*value = millimetres(before_mm);
            }} << Change{[=](AirwayMoment& moment) { moment.*value = millimetres(after_mm); }}
                                << int(step) << known_ms;
        };
        const auto blade = &AirwayMoment::bladePastTeeth;
        row("blade, noise", blade, -30.0, 2.9, IntubationStep::BladeIn, -1);
        row("blade, near", blade, -30.0, 3.1, IntubationStep::BladeIn, 200);
        row("blade, farther", blade, -30.0, 14.9, IntubationStep::BladeIn, 200);
        row("blade, far", blade, -30.0, 15.1, IntubationStep::BladeIn, 20);
        row("blade out, far", blade, 30.0, -30.0, IntubationStep::BladeOut, 2000);
        const auto teeth = &AirwayMoment::pastTeeth;
        row("tube, noise", teeth, -30.0, 2.9, IntubationStep::TubePastTeeth, -1);
        row("tube, near", teeth, -30.0, 14.9, IntubationStep::TubePastTeeth, 200);
        row("tube, far", teeth, -30.0, 15.1, IntubationStep::TubePastTeeth, 20);
        row("tube out, near", teeth, 30.0, -14.9, IntubationStep::TubeOut, 400);
        row("tube out, far", teeth, 30.0, -15.1, IntubationStep::TubeOut, 20);
        const auto besides = &AirwayMoment::besides;
        row("shapes, noise", besides, 0.0, 5.4, IntubationStep::ShapesApart, -1);
        row("shapes, near", besides, 0.0, 5.6, IntubationStep::ShapesApart, 200);
        row("shapes, far", besides, 0.0, 50.0, IntubationStep::ShapesApart, 200);
        row("shapes, together", besides, 20.0, 0.0, IntubationStep::ShapesTogether, 500);
        const auto cords = &AirwayMoment::pastCords;
        row("cords, noise", cords, -60.0, 1.9, IntubationStep::ThroughCords, -1);
        row("cords, near", cords, -60.0, 7.9, IntubationStep::ThroughCords, 400);
        row("cords, far", cords, -60.0, 8.1, IntubationStep::ThroughCords, 20);
        row("above the cords, near", cords, 40.0, -7.9, IntubationStep::BackAboveCords, 400);
        row("above the cords, far", cords, 40.0, -8.1, IntubationStep::BackAboveCords, 20);
        const auto carina = [](const char* name, double past_mm, int known_ms) {
            const auto moved = [](AirwayMoment& moment, double past) {
                moment.pastCords = millimetres(100.0);
                moment.aboveCarina = millimetres(-past);
                moment.rightToLeft = millimetres(past > 0.0 ? 10.0 : 0.0);
                moment.towardsLeft = millimetres(past > 0.0 ? 5.0 : 0.0);
            };
            QTest::newRow(name) << Change{[=](AirwayMoment& moment) { moved(moment, -25.0); }}
                                << Change{[=](AirwayMoment& moment) { moved(moment, past_mm); }}
                                << int(IntubationStep::PastCarina) << known_ms;
        };
        carina("carina, noise", 1.9, -1);
        carina("carina, near", 5.9, 500);
        carina("carina, far", 6.1, 20);
    }
    void passageIsKnownInItsTime()
    {
        QFETCH(const std::function<void(AirwayMoment&)>, before);
        QFETCH(const std::function<void(AirwayMoment&)>, after);
        QFETCH(const int, step);
        QFETCH(const int, known_ms);
        AirwayMoment first = inMouth();
        before(first);
        AirwayMoment then = inMouth();
        after(then);
        const auto known = knownAfter(first, then, IntubationStep(step));
        QCOMPARE(known ? int(known->count()) : -1, known_ms);
    }

    /// A tip that lies as far towards the trachea at each depth. Its log odds by the formula of
    /// WayEvidence where all depths say the same: a b / (s^2 + (l a)^2 / n).
    void wayIsConcludedFromOddsOfTwentyToOneOrDeep()
    {
        int early = 0;
        for (double towards = 1.2e-3; towards < 4e-3; towards += 0.1e-3) {
            IntubationMonitor monitor;
            for (int i = 0; i < 80; ++i) {
                const double past = -0.02 + 0.8e-3 * i;
                AirwayMoment moment = inTrachea(past, 0.125 - past);
                moment.at = SessionTime{i * kStep};
                moment.towardsOesophagus = metres(-towards);
                static_cast<void>(monitor.take(moment));
                if (past < 0.010 || std::abs(past - 0.020) < 1e-5)
                    continue; // the passage itself is not known before
                const double depths = std::floor(past / WayEvidence::kEach.si) + 1.0;
                const double lumen = WayEvidence::kInLumen * 14e-3;
                const double odds = 14e-3 * towards / (kError * kError + lumen * lumen / depths);
                if (std::abs(odds - std::log(20.0)) < 0.01)
                    continue; // 3 for the logarithm of 20
                const bool isConvincing = odds > std::log(20.0);
                early += isConvincing && past < 0.020 ? 1 : 0;
                QCOMPARE(monitor.course().seat != TubeSeat::None, isConvincing || past > 0.020);
            }
        }
        QVERIFY(early > 20);
    }

    /// A tip near a border may be on the other side of it, by the error of the registration.
    void confidenceFallsTowardsTheBordersOfASeat_data()
    {
        QTest::addColumn<double>("pastCords");
        QTest::addColumn<double>("aboveCarina");
        QTest::addColumn<double>("margin");
        QTest::newRow("above the cords") << -1e-3 << 0.126 << 1e-3;
        QTest::newRow("below the cords") << 2e-3 << 0.123 << 2e-3;
        QTest::newRow("in the middle") << 0.060 << 0.060 << 0.060;
        QTest::newRow("above the carina") << 0.122 << 1.5e-3 << 1.5e-3;
    }
    void confidenceFallsTowardsTheBordersOfASeat()
    {
        QFETCH(const double, pastCords);
        QFETCH(const double, aboveCarina);
        QFETCH(const double, margin);
        IntubationMonitor monitor;
        SessionTime now{};
        if (pastCords > 0.0) // the way is known from all depths
            for (double past = 0.0; past < 0.120; past += 2e-3)
                stay(monitor, inTrachea(past, 0.125 - past), now);
        stay(monitor, inTrachea(pastCords, aboveCarina), now);
        QCOMPARE(monitor.course().seat, pastCords > 0.0 ? TubeSeat::Trachea : TubeSeat::None);
        QVERIFY(std::abs(monitor.course().confidence - below(margin / kError)) < 1e-3);
    }

    /// Of a tube whose curve at rest nobody touched.
    void asksWhereATipIsThatIsNotKnown()
    {
        const auto confidenceIn = [](bool isTipKnown) {
            IntubationMonitor monitor;
            SessionTime now{};
            for (double past = 0.0; past < 0.060; past += 2e-3) {
                AirwayMoment moment = inTrachea(past, 0.125 - past);
                moment.isTipKnown = isTipKnown;
                stay(monitor, moment, now);
            }
            return monitor.course().confidence;
        };
        QVERIFY(confidenceIn(true) > 0.95);
        QCOMPARE(confidenceIn(false), IntubationMonitor::kTipNotKnown * confidenceIn(true));
    }

    /// 95 % of errors in space are within 2.7955 standard deviations of one axis.
    void expectsTheLargerOfBothErrors()
    {
        QVERIFY(std::abs(PlacementError{}.atCords().si - kError) < 1e-12);
        QCOMPARE(PlacementError{.boundAtCords = millimetres(5.0)}.atCords(),
                 PlacementError{}.atCords());
        const Length worse = PlacementError{.boundAtCords = millimetres(10.0)}.atCords();
        QVERIFY(std::abs(inMillimetres(worse) - 10.0 / 2.7955) < 1e-3);
        IntubationMonitor monitor;
        monitor.expect({.boundAtCords = millimetres(10.0)});
        SessionTime now{};
        stay(monitor, inTrachea(-0.001, 0.126), now);
        QVERIFY(std::abs(monitor.course().confidence - below(1e-3 / worse.si)) < 1e-3);
    }

    /// What is noted already is not noted again.
    void goesOnFromWhatWasNoted()
    {
        for (const TubeSeat seat :
             {TubeSeat::Trachea, TubeSeat::Oesophagus, TubeSeat::RightMain, TubeSeat::LeftMain}) {
            IntubationMonitor monitor{
                {}, courseFrom({.isTubeIn = true, .seat = seat, .confidence = 0.99}, {})};
            AirwayMoment moment = inTrachea(0.060, 0.060);
            if (seat == TubeSeat::Oesophagus)
                moment.towardsOesophagus = millimetres(7.0);
            if (isInMainBronchus(seat)) {
                moment = inTrachea(0.140, -0.020);
                moment.rightToLeft = millimetres(20.0);
                moment.towardsLeft = millimetres(seat == TubeSeat::LeftMain ? 10.0 : -10.0);
            }
            SessionTime now{};
            for (int i = 0; i < 100; ++i) {
                moment.at = now += kStep;
                QVERIFY(monitor.take(moment).empty());
            }
            QCOMPARE(monitor.course().seat, seat);
        }
    }

    /// The depth is as it was told while no tube is seen.
    void tellsTheDepthThatWasNoted()
    {
        const TipReading tip{.depthAtTeeth = millimetres(210.0), .aboveCarina = millimetres(30.0)};
        const IntubationMonitor monitor{
            {}, courseFrom({.isTubeIn = true, .seat = TubeSeat::Trachea, .tip = tip}, {})};
        const IntubationEvent cuff = monitor.told(IntubationStep::CuffInflated, SessionTime{});
        QCOMPARE(cuff.depthAtTeeth, tip.depthAtTeeth);
        QCOMPARE(cuff.tipAboveCarina, tip.aboveCarina);
    }

    /// Nobody who watches now saw it pass: it is dated to when they took up the work.
    void turnsWhatWasNotedWhenItBegan()
    {
        const SessionTime begin{std::chrono::seconds{100}};
        IntubationMonitor monitor{
            {},
            courseFrom({.isTubeIn = true, .seat = TubeSeat::Trachea, .confidence = 0.6}, begin)};
        AirwayMoment moment = inTrachea(0.060, 0.060);
        moment.towardsOesophagus = millimetres(7.0);
        std::vector<IntubationEvent> events;
        for (SessionTime now = begin; events.empty() && now < begin + milliseconds{1000};) {
            moment.at = now += kStep;
            events = monitor.take(moment);
        }
        QCOMPARE(events.size(), std::size_t{2}); // out of the one way, and into the other
        for (const IntubationEvent& event : events) {
            QVERIFY(event.at == begin);
            QVERIFY(event.confidence > 0.5 && event.confidence <= 0.7);
        }
        QCOMPARE(events.back().seat, TubeSeat::Oesophagus);
    }

    /// What happened while nobody looked.
    void isLessSureOfWhatHappenedUnseen()
    {
        for (const bool looksAway : {false, true}) {
            IntubationMonitor monitor;
            SessionTime now{};
            AirwayMoment moment = inMouth();
            moment.pastTeeth = millimetres(-30.0);
            stay(monitor, moment, now);
            if (looksAway)
                monitor.lookAway();
            moment.pastTeeth = millimetres(30.0);
            std::vector<IntubationEvent> events;
            for (int i = 0; i < 10 && events.empty(); ++i) {
                moment.at = now += kStep;
                events = monitor.take(moment);
            }
            QCOMPARE(events.size(), std::size_t{1});
            QVERIFY(looksAway ? std::abs(events.front().confidence - 0.7) < 1e-3
                              : events.front().confidence > 0.99);
        }
    }

    /// A tube that is seen outside has left the place in which it was before the mouth.
    void notesThatATubeOfBeforeIsOut()
    {
        IntubationMonitor monitor{{},
                                  courseFrom({.isTubeIn = true, .seat = TubeSeat::LeftMain}, {})};
        AirwayMoment moment = inMouth();
        moment.pastTeeth = millimetres(-100.0);
        moment.pastCords = millimetres(-200.0);
        moment.measuredPastCords = moment.pastCords;
        SessionTime now{};
        std::vector<IntubationStep> steps;
        for (int i = 0; i < 100; ++i) {
            moment.at = now += kStep;
            for (const IntubationEvent& event : monitor.take(moment))
                steps.push_back(event.step);
        }
        const std::vector<IntubationStep> expected{IntubationStep::BackAboveCarina,
                                                   IntubationStep::BackAboveCords,
                                                   IntubationStep::TubeOut};
        QCOMPARE(steps, expected);
    }

    /// A blade that nobody sees any more, and one that is seen outside.
    void notesThatABladeOfBeforeIsOut()
    {
        for (const auto& [seen, after] : {std::pair{Validity::Lost, milliseconds{10000}},
                                          std::pair{Validity::Tracked, milliseconds{2020}}}) {
            IntubationMonitor monitor{{}, courseFrom({.isBladeIn = true}, {})};
            AirwayMoment moment = inMouth();
            moment.tube = Validity::Lost;
            moment.blade = seen;
            std::optional<SessionTime> out;
            for (SessionTime now{}; !out && now < SessionTime{milliseconds{20000}};) {
                moment.at = now += kStep;
                for (const IntubationEvent& event : monitor.take(moment))
                    if (event.step == IntubationStep::BladeOut)
                        out = now;
            }
            QVERIFY(out == SessionTime{after});
        }
    }

    /// A tip that is elsewhere, so long after it was seen last.
    void jumpIsForgivenAfterATime_data()
    {
        QTest::addColumn<int>("lost_ms");
        QTest::addColumn<double>("moved_mm");
        QTest::addColumn<bool>("isTaken");
        QTest::newRow("slower than 2 m/s") << 60 << 119.0 << true;
        QTest::newRow("faster") << 60 << 121.0 << false;
        QTest::newRow("faster, for longer") << 180 << 361.0 << false;
        QTest::newRow("long ago") << 200 << 500.0 << true;
    }
    void jumpIsForgivenAfterATime()
    {
        QFETCH(const int, lost_ms);
        QFETCH(const double, moved_mm);
        QFETCH(const bool, isTaken);
        IntubationMonitor monitor;
        SessionTime now{};
        stay(monitor, inMouth(), now);
        AirwayMoment moment = inMouth();
        moment.at = now + milliseconds{lost_ms};
        moment.p_A_tip.z() -= millimetres(moved_mm).si;
        moment.depthAtTeeth = millimetres(77.0);
        static_cast<void>(monitor.take(moment));
        QCOMPARE(monitor.course().tip.depthAtTeeth == moment.depthAtTeeth, isTaken);
    }
};

CARINA_TEST(TestMonitorLimits)

} // namespace carina::monitor_limits_test

#include "tst_monitor_limits.moc"
