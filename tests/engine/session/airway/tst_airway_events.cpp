#include "engine/session/airway/airway_rules.h"
#include "engine/session/facts/fact_rules.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace carina::airway_events_test
{

using namespace test;

/// What is decided about the airway of a patient, and what is to be seen of it at a time.
class TestAirwayEvents : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areNoneAtFirst();
    void comeOnEvenlyOverTheTime();
    void takeTheirPlaceAtOnceWhereNoTimeIsGiven();
    void goOnFromTheSeverityThatTheyHaveReached();
    void areTheSameInAnyOrderOfArrival();
    void holdTheLastOfTwoAtOneTime();
    void tellWhereTheChangeLeads();
    void stayAsTheyAreWhenThePastIsForgotten();
    void areTheSameForALateJoiner();
    void changeAtAllStationsAtOneTime();
    void areCheckedByTheHost_data();
    void areCheckedByTheHost();
    void areRefusedFromATrainee();
};

namespace
{

using enum AirwayEventKind;

constexpr double kRounding = 1e-12; ///< of a severity

struct Decided {
    double from_s;
    AirwayEvents events;
    double over_s;
};

/// Each begins in the midst of the one before.
std::vector<Decided> fourChanges()
{
    return {{10.0, {{TongueOedema, 0.8}, {Laryngospasm, 1.0}}, 20.0},
            {15.0, {{TongueOedema, 0.2}, {Epiglottitis, 0.6}}, 10.0},
            {22.0, {{LaryngealOedema, 1.0}}, 0.0},
            {24.0, {{Epiglottitis, 1.0}}, 100.0}};
}

void decide(AirwayEventTimeline& timeline, const Decided& change)
{
    timeline.set(atSeconds(change.from_s), change.events, fromSeconds(change.over_s));
}

double severityAmong(const AirwayEvents& events, AirwayEventKind kind)
{
    const auto found = std::ranges::find(events, kind, &AirwayEvent::kind);
    return found == events.end() ? 0.0 : found->severity;
}

bool isNear(double a, double b) { return std::abs(a - b) < kRounding; }

const AirwayEventTimeline& eventsOf(const SessionState& state, StationId station = kSampleStation)
{
    return state.stations().at(station).airwayEvents;
}

/// The oedema of a tongue that comes and goes for five minutes, with the checkpoints that a host
/// adds meanwhile.
LogWriter longSession()
{
    const RespiratoryState rest = RespiratoryFold{RespiratorySettings{}}.state();
    LogWriter writer = sampleSession();
    for (int i = 0; i < 30; ++i) {
        const double t = 10.0 * i;
        writer.add(atSeconds(t), fact::RespirationCheckpoint{atSeconds(t), rest});
        writer.add(atSeconds(t), fact::CapnographCheckpoint{atSeconds(t), {}});
        writer.add(atSeconds(t), fact::BodyCheckpoint{atSeconds(t), {}});
        writer.add(atSeconds(t + 1.0),
                   fact::AirwayEventsSet{{{TongueOedema, i % 2 == 0 ? 1.0 : 0.0}},
                                         std::chrono::seconds{40}});
    }
    return writer;
}

} // namespace

void TestAirwayEvents::areNoneAtFirst()
{
    const AirwayEventTimeline timeline;
    QVERIFY(timeline.at(atSeconds(0.0)).empty());
    QVERIFY(timeline.at(SessionTime::max()).empty());
    QVERIFY(timeline.decidedAt(SessionTime::max()).empty());
}

void TestAirwayEvents::comeOnEvenlyOverTheTime()
{
    AirwayEventTimeline timeline;
    decide(timeline, {10.0, {{TongueOedema, 0.8}, {Epiglottitis, 0.0}}, 20.0});
    QVERIFY(timeline.at(atSeconds(9.999)).empty());
    QVERIFY(timeline.at(atSeconds(10.0)).empty()); // nothing is to be seen yet
    for (const auto& [t, severity] :
         {std::pair{15.0, 0.2}, {20.0, 0.4}, {29.0, 0.76}, {30.0, 0.8}, {1000.0, 0.8}}) {
        const AirwayEvents events = timeline.at(atSeconds(t));
        QVERIFY(areProper(events) && events.size() == 1);
        QVERIFY(isNear(severityAmong(events, TongueOedema), severity));
    }
    QCOMPARE(severityAmong(timeline.at(atSeconds(30.0)), TongueOedema), 0.8);
}

void TestAirwayEvents::takeTheirPlaceAtOnceWhereNoTimeIsGiven()
{
    AirwayEventTimeline timeline;
    decide(timeline, {10.0, {{Laryngospasm, 1.0}}, 0.0});
    QVERIFY(timeline.at(atSeconds(9.999)).empty());
    QVERIFY(timeline.at(atSeconds(10.0)) == (AirwayEvents{{Laryngospasm, 1.0}}));
    decide(timeline, {11.0, {}, 0.0});
    QVERIFY(timeline.at(atSeconds(10.999)) == (AirwayEvents{{Laryngospasm, 1.0}}));
    QVERIFY(timeline.at(atSeconds(11.0)).empty());
}

/// 0.8 in 20 s has come to 0.2 after 5 s; that of the cords to 0.25, and goes to nothing from
/// there.
void TestAirwayEvents::goOnFromTheSeverityThatTheyHaveReached()
{
    AirwayEventTimeline timeline;
    decide(timeline, {10.0, {{TongueOedema, 0.8}, {Laryngospasm, 1.0}}, 20.0});
    decide(timeline, {15.0, {{TongueOedema, 0.7}}, 10.0});
    const AirwayEvents begin = timeline.at(atSeconds(15.0));
    QVERIFY(isNear(severityAmong(begin, TongueOedema), 0.2));
    QVERIFY(isNear(severityAmong(begin, Laryngospasm), 0.25));
    const AirwayEvents later = timeline.at(atSeconds(19.0));
    QVERIFY(isNear(severityAmong(later, TongueOedema), 0.4));
    QVERIFY(isNear(severityAmong(later, Laryngospasm), 0.15));
    QVERIFY(timeline.at(atSeconds(25.0)) == (AirwayEvents{{TongueOedema, 0.7}}));
}

void TestAirwayEvents::areTheSameInAnyOrderOfArrival()
{
    const std::vector<Decided> changes = fourChanges();
    AirwayEventTimeline inOrder;
    for (const Decided& change : changes)
        decide(inOrder, change);
    std::array<std::size_t, 4> order{};
    std::iota(order.begin(), order.end(), 0U);
    int orders = 0;
    do {
        AirwayEventTimeline timeline;
        for (const std::size_t i : order)
            decide(timeline, changes[i]);
        for (double t = 5.0; t < 130.0; t += 0.7)
            QVERIFY(timeline.at(atSeconds(t)) == inOrder.at(atSeconds(t)));
        ++orders;
    } while (std::ranges::next_permutation(order).found);
    QCOMPARE(orders, 24);
}

void TestAirwayEvents::holdTheLastOfTwoAtOneTime()
{
    AirwayEventTimeline timeline;
    decide(timeline, {5.0, {{TongueOedema, 0.5}}, 0.0});
    decide(timeline, {10.0, {{TongueOedema, 1.0}}, 0.0});
    decide(timeline, {10.0, {{Epiglottitis, 1.0}}, 10.0});
    const AirwayEvents half = timeline.at(atSeconds(15.0));
    QVERIFY(isNear(severityAmong(half, TongueOedema), 0.25)); // of the half before both
    QVERIFY(isNear(severityAmong(half, Epiglottitis), 0.5));
}

void TestAirwayEvents::tellWhereTheChangeLeads()
{
    AirwayEventTimeline timeline;
    decide(timeline, {10.0, {{TongueOedema, 0.8}, {Epiglottitis, 0.0}}, 20.0});
    QVERIFY(timeline.decidedAt(atSeconds(9.0)).empty());
    QVERIFY(timeline.decidedAt(atSeconds(10.0)) == (AirwayEvents{{TongueOedema, 0.8}}));
    QCOMPARE(timeline.overAt(atSeconds(9.0)), Duration{});
    QCOMPARE(timeline.overAt(atSeconds(10.0)), Duration{std::chrono::seconds{20}});
    decide(timeline, {15.0, {}, 25.0});
    QCOMPARE(timeline.overAt(atSeconds(15.0)), Duration{std::chrono::seconds{25}});
    QVERIFY(timeline.decidedAt(atSeconds(15.0)).empty());
    QVERIFY(!timeline.at(atSeconds(15.0)).empty());
}

void TestAirwayEvents::stayAsTheyAreWhenThePastIsForgotten()
{
    AirwayEventTimeline whole;
    for (const Decided& change : fourChanges())
        decide(whole, change);
    AirwayEventTimeline kept = whole;
    kept.forgetBefore(atSeconds(16.0));
    QVERIFY(kept.at(atSeconds(14.0)).empty());
    for (double t = 16.0; t < 130.0; t += 0.7)
        QVERIFY(kept.at(atSeconds(t)) == whole.at(atSeconds(t)));
}

/// Who was there from the beginning asks as time goes on, who joins late for the end alone. The
/// tongue swells by 1/40 a second for ten seconds, and so on.
void TestAirwayEvents::areTheSameForALateJoiner()
{
    const LogWriter writer = longSession();
    const SessionState late = stateOf(writer);
    AirwayEventTimeline whole;
    SessionState present;
    for (const Fact& fact : writer.log()) {
        present.apply(fact);
        if (const auto* set = std::get_if<fact::AirwayEventsSet>(&fact.body)) {
            whole.set(fact.effect, set->events, set->over);
            QVERIFY(eventsOf(present).at(fact.effect + std::chrono::seconds{7})
                    == whole.at(fact.effect + std::chrono::seconds{7}));
        }
    }
    for (double t = 230.0; t < 400.0; t += 3.3) {
        QVERIFY(eventsOf(late).at(atSeconds(t)) == whole.at(atSeconds(t)));
        QVERIFY(eventsOf(present).at(atSeconds(t)) == whole.at(atSeconds(t)));
    }
    QVERIFY(eventsOf(late).at(atSeconds(100.0)).empty()); // nobody looks back so far
}

void TestAirwayEvents::changeAtAllStationsAtOneTime()
{
    constexpr StationId kOther{1};
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::StationAdded{"Room 5"}, kOther);
    const SessionTime from = kNow + std::chrono::seconds{1};
    writer.add(from, fact::AirwayEventsSet{{{Laryngospasm, 1.0}}, {}}, kAllStations);
    const SessionState state = stateOf(writer);
    for (const StationId station : {kSampleStation, kOther}) {
        QVERIFY(eventsOf(state, station).at(from - Duration{1}).empty());
        QVERIFY(eventsOf(state, station).at(from) == (AirwayEvents{{Laryngospasm, 1.0}}));
    }
}

void TestAirwayEvents::areCheckedByTheHost_data()
{
    using std::chrono::minutes;
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const AirwayEvents& events, Duration over,
                        const char* expected) {
        QTest::newRow(name) << FactBody{fact::AirwayEventsSet{events, over}}
                            << QByteArray{expected};
    };
    row("clear", {}, {}, "fine");
    row("none of a kind", {{TongueOedema, 0.0}}, {}, "fine");
    row("all at the worst, as slowly as may be",
        {{TongueOedema, 1.0},
         {PharyngealSwelling, 1.0},
         {Epiglottitis, 1.0},
         {LaryngealOedema, 1.0},
         {Laryngospasm, 1.0},
         {FloppyEpiglottis, 1.0},
         {AnteriorLarynx, 1.0},
         {AngioOedema, 1.0},
         {LaryngealWeb, 1.0},
         {ExternalPressure, 1.0},
         {TrachealStenosis, 1.0},
         {TrachealDeviation, 1.0},
         {Goitre, 1.0},
         {NeckObesity, 1.0},
         {ProminentIncisors, 1.0},
         {Trismus, 1.0},
         {StiffNeck, 1.0},
         {Burn, 1.0},
         {Secretions, 1.0},
         {Blood, 1.0},
         {Vomit, 1.0},
         {ForeignBody, 1.0},
         {FragileTeeth, 1.0},
         {Swallowing, 1.0}},
        minutes{10}, "fine");
    row("worse than the worst", {{TongueOedema, 1.0 + 1e-9}}, {}, "out of range");
    row("negative", {{TongueOedema, -1e-9}}, {}, "out of range");
    row("not a number", {{TongueOedema, std::numeric_limits<double>::quiet_NaN()}}, {},
        "not finite");
    row("twice", {{Epiglottitis, 0.5}, {Epiglottitis, 0.6}}, {}, "out of range");
    row("out of order", {{Laryngospasm, 0.5}, {TongueOedema, 0.6}}, {}, "out of range");
    row("a kind that there is not", {{static_cast<AirwayEventKind>(kAirwayEventKinds), 0.5}}, {},
        "out of range");
    row("too slowly", {}, minutes{10} + Duration{1000}, "out of range");
    row("back in time", {}, Duration{-1000}, "out of range");
}

void TestAirwayEvents::areCheckedByTheHost()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, expected);
    const Result<Fact> fact = judgeBy(sampleAuthority(), kSampleInstructor, body);
    QCOMPARE(verdict(fact), expected);
    if (fact)
        QVERIFY(fact->effect == kNow + kShortestLead);
}

void TestAirwayEvents::areRefusedFromATrainee()
{
    const fact::AirwayEventsSet spasm{{{Laryngospasm, 1.0}}, {}};
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleTrainee, spasm)),
             QByteArray{"not permitted"});
}

CARINA_TEST(TestAirwayEvents)

} // namespace carina::airway_events_test

#include "tst_airway_events.moc"
