#include "engine/session/airway/airway_rules.h"
#include "engine/session/facts/fact_rules.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::head_position_facts_test
{

using namespace test;

/// What is decided about how head and neck of a patient lie, and how they do at a time.
class TestHeadPositionFacts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areNeutralAtFirst();
    void moveEvenlyOverTheTime();
    void goOnFromWhereTheyHaveCome();
    void areTheSameInAnyOrderOfArrival();
    void stayAsTheyAreWhenThePastIsForgotten();
    void areTheSameForALateJoiner();
    void changeAtAllStationsAtOneTime();
    void areCheckedByTheHost_data();
    void areCheckedByTheHost();
    void areRefusedFromATrainee();
};

namespace
{

constexpr double kRounding_deg = 1e-9;

bool isNear(const HeadPosition& position, double flexion_deg, double extension_deg)
{
    return std::abs(inDegrees(position.flexion) - flexion_deg) < kRounding_deg
           && std::abs(inDegrees(position.extension) - extension_deg) < kRounding_deg;
}

HeadPosition lying(double flexion_deg, double extension_deg)
{
    return {degrees(flexion_deg), degrees(extension_deg)};
}

const HeadPositionTimeline& headOf(const SessionState& state, StationId station = kSampleStation)
{
    return state.stations().at(station).headPosition;
}

} // namespace

void TestHeadPositionFacts::areNeutralAtFirst()
{
    const HeadPositionTimeline timeline;
    QVERIFY(timeline.at(atSeconds(0.0)) == HeadPosition{});
    QVERIFY(timeline.decidedAt(SessionTime::max()) == HeadPosition{});
    QVERIFY(headOf(stateOf(sampleSession())).at(kNow) == HeadPosition{}); // an old log
}

void TestHeadPositionFacts::moveEvenlyOverTheTime()
{
    HeadPositionTimeline timeline;
    timeline.set(atSeconds(10.0), lying(30.0, 20.0), fromSeconds(10.0));
    QVERIFY(timeline.at(atSeconds(10.0)) == HeadPosition{});
    QVERIFY(isNear(timeline.at(atSeconds(12.5)), 7.5, 5.0));
    QVERIFY(timeline.decidedAt(atSeconds(12.5)) == lying(30.0, 20.0));
    QVERIFY(timeline.at(atSeconds(20.0)) == lying(30.0, 20.0));
    timeline.set(atSeconds(30.0), lying(-10.0, 0.0), {});
    QVERIFY(timeline.at(atSeconds(29.999)) == lying(30.0, 20.0));
    QVERIFY(timeline.at(atSeconds(30.0)) == lying(-10.0, 0.0));
}

/// Half of the way to 30 and 20 degrees, and from there back in 5 s.
void TestHeadPositionFacts::goOnFromWhereTheyHaveCome()
{
    HeadPositionTimeline timeline;
    timeline.set(atSeconds(10.0), lying(30.0, 20.0), fromSeconds(10.0));
    timeline.set(atSeconds(15.0), {}, fromSeconds(5.0));
    QVERIFY(isNear(timeline.at(atSeconds(15.0)), 15.0, 10.0));
    QVERIFY(isNear(timeline.at(atSeconds(16.0)), 12.0, 8.0));
    QVERIFY(timeline.at(atSeconds(20.0)) == HeadPosition{});
}

void TestHeadPositionFacts::areTheSameInAnyOrderOfArrival()
{
    HeadPositionTimeline forth;
    forth.set(atSeconds(10.0), kSniffing, fromSeconds(10.0));
    forth.set(atSeconds(15.0), kHeadExtended, fromSeconds(20.0));
    HeadPositionTimeline back;
    back.set(atSeconds(15.0), kHeadExtended, fromSeconds(20.0));
    back.set(atSeconds(10.0), kSniffing, fromSeconds(10.0));
    for (double t = 5.0; t < 40.0; t += 0.7)
        QVERIFY(forth.at(atSeconds(t)) == back.at(atSeconds(t)));
}

void TestHeadPositionFacts::stayAsTheyAreWhenThePastIsForgotten()
{
    HeadPositionTimeline whole;
    whole.set(atSeconds(10.0), kSniffing, fromSeconds(10.0));
    whole.set(atSeconds(15.0), kHeadExtended, fromSeconds(20.0));
    HeadPositionTimeline kept = whole;
    kept.forgetBefore(atSeconds(16.0));
    for (double t = 16.0; t < 40.0; t += 0.7)
        QVERIFY(kept.at(atSeconds(t)) == whole.at(atSeconds(t)));
}

/// With the checkpoints that a host adds meanwhile.
void TestHeadPositionFacts::areTheSameForALateJoiner()
{
    const RespiratoryState rest = RespiratoryFold{RespiratorySettings{}}.state();
    LogWriter writer = sampleSession();
    HeadPositionTimeline whole;
    for (int i = 0; i < 30; ++i) {
        const double t = 10.0 * i;
        const HeadPosition aim = i % 2 == 0 ? kSniffing : HeadPosition{};
        writer.add(atSeconds(t), fact::RespirationCheckpoint{atSeconds(t), rest});
        writer.add(atSeconds(t), fact::CapnographCheckpoint{atSeconds(t), {}});
        writer.add(atSeconds(t), fact::BodyCheckpoint{atSeconds(t), {}});
        writer.add(atSeconds(t + 1.0), fact::HeadPositionSet{aim, fromSeconds(40.0)});
        whole.set(atSeconds(t + 1.0), aim, fromSeconds(40.0));
    }
    const SessionState late = stateOf(writer);
    for (double t = 230.0; t < 400.0; t += 3.3)
        QVERIFY(headOf(late).at(atSeconds(t)) == whole.at(atSeconds(t)));
}

void TestHeadPositionFacts::changeAtAllStationsAtOneTime()
{
    constexpr StationId kOther{1};
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::StationAdded{"Room 5"}, kOther);
    const SessionTime from = kNow + std::chrono::seconds{1};
    writer.add(from, fact::HeadPositionSet{kSniffing, {}}, kAllStations);
    const SessionState state = stateOf(writer);
    for (const StationId station : {kSampleStation, kOther}) {
        QVERIFY(headOf(state, station).at(from - Duration{1}) == HeadPosition{});
        QVERIFY(headOf(state, station).at(from) == kSniffing);
    }
}

void TestHeadPositionFacts::areCheckedByTheHost_data()
{
    using std::chrono::minutes;
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const HeadPosition& position, Duration over,
                        const char* expected) {
        QTest::newRow(name) << FactBody{fact::HeadPositionSet{position, over}}
                            << QByteArray{expected};
    };
    const Angle none = radians(std::numeric_limits<double>::quiet_NaN());
    row("neutral", {}, {}, "fine");
    row("sniffing, as slowly as may be", kSniffing, minutes{10}, "fine");
    row("flexed and extended to the end", {kMostFlexion, kMostExtension}, {}, "fine");
    row("to the other end", {kLeastFlexion, kLeastExtension}, {}, "fine");
    row("flexed too far", lying(35.01, 0.0), {}, "out of range");
    row("flexed back too far", lying(-25.01, 0.0), {}, "out of range");
    row("extended too far", lying(0.0, 30.01), {}, "out of range");
    row("bent forward too far", lying(0.0, -10.01), {}, "out of range");
    row("flexed by no number", {none, {}}, {}, "not finite");
    row("extended by no number", {{}, none}, {}, "not finite");
    row("too slowly", {}, minutes{10} + Duration{1000}, "out of range");
    row("back in time", {}, Duration{-1000}, "out of range");
}

void TestHeadPositionFacts::areCheckedByTheHost()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, expected);
    const Result<Fact> fact = judgeBy(sampleAuthority(), kSampleInstructor, body);
    QCOMPARE(verdict(fact), expected);
    if (fact)
        QVERIFY(fact->effect == kNow + kShortestLead);
}

void TestHeadPositionFacts::areRefusedFromATrainee()
{
    const fact::HeadPositionSet sniffing{kSniffing, {}};
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleTrainee, sniffing)),
             QByteArray{"not permitted"});
}

CARINA_TEST(TestHeadPositionFacts)

} // namespace carina::head_position_facts_test

#include "tst_head_position_facts.moc"
