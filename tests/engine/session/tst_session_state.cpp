#include "engine/session/session_state.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

#include <sys/wait.h>
#include <unistd.h>

namespace carina::test::session_state_test
{

class TestSessionState : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isEmptyBeforeTheFirstFact();
    void knowsWhoAndWhatIsThere();
    void remembersWhoLeftAndTakesThemBack();
    void tellsWhoFellSilentFromWhoLeft_data();
    void tellsWhoFellSilentFromWhoLeft();
    void nobodyWhoWasRemovedFallsSilent();
    void countsTheObjectsOfThosePresent();
    void givesAnObjectToItsNewOwner();
    void keepsEachParticipantsRegistrationForItsStay();
    void movesThroughThePhasesAtTheirTimes();
    void countsOnlyRunningTime();
    void drivesEachStationByItsOwnFacts();
    void breathesOnlyWhileItRuns();
    void letsALateStationRunAtOnce();
    void namesAStationAnewWithoutForgettingIt();
    void ignoresWhatItDoesNotKnow_data();
    void ignoresWhatItDoesNotKnow();
    void isTheSameAtEveryNode();
    void stopsAtAGapInTheNumbers_data();
    void stopsAtAGapInTheNumbers();
};

namespace
{

/// Breaths that a clock would count which runs while the patient does.
double breathsAt(const SessionState& state, StationId station, double seconds)
{
    const RespirationTimeline& respiration = state.stations().at(station).respiration;
    double breaths = 0.0;
    for (double s = 0.005; s < seconds; s += 0.01)
        if (respiration.runsAt(atSeconds(s)))
            breaths += 0.01 * respiration.settingsAt(atSeconds(s)).pattern.rate.si;
    return breaths;
}

#define VERIFY_BREATHS(actual, expected) QVERIFY(std::abs((actual) - (expected)) < 1e-6)

} // namespace

void TestSessionState::isEmptyBeforeTheFirstFact()
{
    const SessionState state;
    QCOMPARE(state.lastApplied().value, std::uint64_t{0});
    QVERIFY(state.phaseAt(SessionTime::max()) == SessionPhase::Prepared);
    QVERIFY(state.runningTime(SessionTime::max()) == Duration{0});
    QVERIFY(state.participants().empty() && state.objects().empty() && state.stations().empty());
    QVERIFY(state.name().empty() && state.sessionId().empty());
}

void TestSessionState::knowsWhoAndWhatIsThere()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::AnatomyChosen{"5eed", "Adult"});
    const SessionState state = stateOf(writer);
    QCOMPARE(state.lastApplied().value, std::uint64_t{8});
    QCOMPARE(state.name(), std::string{"Routine intubation"});
    QCOMPARE(state.sessionId(), std::string{"00ff"});

    QCOMPARE(state.participants().size(), std::size_t{4});
    const Participant& trainee = state.participants().at(kSampleTrainee);
    QVERIFY(trainee.id == kSampleTrainee && trainee.role == Role::Trainee);
    QVERIFY(trainee.name == "Tom" && trainee.station == kSampleStation && trainee.present);

    QCOMPARE(state.objects().size(), std::size_t{1});
    const SharedObject& tube = state.objects().at(kSampleTube);
    QVERIFY(tube.id == kSampleTube && tube.owner == kSampleTrainee);
    QVERIFY(tube.kind == ObjectKind::Tube && tube.name == "tube");
    QVERIFY(tube.station == kSampleStation);

    QCOMPARE(state.stations().size(), std::size_t{1});
    const Station& station = state.stations().at(kSampleStation);
    QVERIFY(station.id == kSampleStation && station.name == "Station 1");
    QVERIFY(station.anatomyHash == "5eed" && station.anatomyName == "Adult");
}

void TestSessionState::remembersWhoLeftAndTakesThemBack()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::ParticipantLeft{kSampleTrainee});
    SessionState state = stateOf(writer);
    QVERIFY(!state.participants().at(kSampleTrainee).present);
    QVERIFY(state.participants().at(kSampleObserver).present);
    QCOMPARE(state.participants().at(kSampleTrainee).name, std::string{"Tom"});
    state.apply(writer.add(atSeconds(2.0),
                           fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"},
                           StationId{5}));
    QVERIFY(state.participants().at(kSampleTrainee).present);
    QVERIFY(state.participants().at(kSampleTrainee).station == StationId{5});
}

void TestSessionState::tellsWhoFellSilentFromWhoLeft_data()
{
    QTest::addColumn<QList<FactBody>>("after"); // Tom fell silent
    QTest::addColumn<bool>("isAway");
    const FactBody left = fact::ParticipantLeft{kSampleTrainee};
    const FactBody silent = fact::ParticipantFellSilent{kSampleTrainee};
    const FactBody back = fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"};
    QTest::newRow("nothing") << QList<FactBody>{} << true;
    QTest::newRow("another leaves")
        << QList<FactBody>{fact::ParticipantLeft{kSampleOtherTrainee}} << true;
    QTest::newRow("they come back") << QList<FactBody>{back} << false;
    QTest::newRow("and leave") << QList<FactBody>{back, left} << false;
    QTest::newRow("and fall silent again") << QList<FactBody>{back, silent} << true;
    QTest::newRow("they are removed")
        << QList<FactBody>{fact::ParticipantRemoved{kSampleTrainee, false, {}}} << false;
    QTest::newRow("they are banned")
        << QList<FactBody>{fact::ParticipantRemoved{kSampleTrainee, true, {}}} << false;
    QTest::newRow("the host is started anew")
        << QList<FactBody>{fact::ParticipantJoined{kSampleHost, Role::Instructor, "Host"}} << false;
}

void TestSessionState::tellsWhoFellSilentFromWhoLeft()
{
    QFETCH(const QList<FactBody>, after);
    QFETCH(const bool, isAway);
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::ParticipantFellSilent{kSampleTrainee});
    const SessionState silent = stateOf(writer);
    QVERIFY(!silent.isPresent(kSampleTrainee));
    QVERIFY(silent.participants().at(kSampleTrainee).left == atSeconds(1.0));
    for (const FactBody& body : after)
        writer.add(atSeconds(2.0), body);
    QCOMPARE(stateOf(writer).participants().at(kSampleTrainee).fellSilent, isAway);
}

/// Their program is told to be silent, and the host notices that it is.
void TestSessionState::nobodyWhoWasRemovedFallsSilent()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::ParticipantRemoved{kSampleTrainee, false, {}});
    writer.add(atSeconds(2.0), fact::ParticipantFellSilent{kSampleTrainee});
    writer.add(atSeconds(2.0), fact::ParticipantFellSilent{ParticipantId{77}});
    const SessionState state = stateOf(writer);
    QVERIFY(!state.participants().at(kSampleTrainee).fellSilent);
    QVERIFY(!state.participants().contains(ParticipantId{77}));
}

void TestSessionState::countsTheObjectsOfThosePresent()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0),
               fact::ObjectShared{ObjectId{7}, kSampleInstructor, ObjectKind::Patient, "patient"});
    SessionState state = stateOf(writer);
    QCOMPARE(state.sharedObjects(), std::size_t{2});
    state.apply(writer.add(atSeconds(2.0), fact::ParticipantLeft{kSampleTrainee}));
    QCOMPARE(state.sharedObjects(), std::size_t{1});
    state.apply(writer.add(atSeconds(3.0),
                           fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"},
                           kSampleStation));
    QCOMPARE(state.sharedObjects(), std::size_t{2});
}

void TestSessionState::givesAnObjectToItsNewOwner()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::ObjectHandedOver{kSampleTube, kSampleInstructor, 1});
    SharedObject tube = stateOf(writer).objects().at(kSampleTube);
    QVERIFY(tube.owner == kSampleInstructor);
    QCOMPARE(tube.epoch, std::uint16_t{2});
    QCOMPARE(tube.name, std::string{"tube"});
    // Not another owner, so the same ownership; and then another.
    writer.add(atSeconds(2.0), fact::ObjectHandedOver{kSampleTube, kSampleInstructor, 2});
    writer.add(atSeconds(2.0), fact::ObjectHandedOver{ObjectId{9}, kSampleInstructor, 2});
    QCOMPARE(stateOf(writer).objects().at(kSampleTube).epoch, std::uint16_t{2});
    QCOMPARE(stateOf(writer).objects().size(), std::size_t{1});
    writer.add(atSeconds(3.0),
               fact::ObjectShared{kSampleTube, kSampleTrainee, ObjectKind::Stylus, "probe"});
    tube = stateOf(writer).objects().at(kSampleTube);
    QVERIFY(tube.owner == kSampleTrainee);
    QCOMPARE(tube.epoch, std::uint16_t{3});
    QCOMPARE(tube.kind, ObjectKind::Stylus);
    QCOMPARE(tube.name, std::string{"probe"});
}

void TestSessionState::keepsEachParticipantsRegistrationForItsStay()
{
    LogWriter writer = sampleSession();
    const RegistrationStanding notGood{RegistrationState::NotGood, StaleReason::None,
                                       millimetres(4.2)};
    writer.add(atSeconds(1.0), fact::RegistrationStated{notGood}, kSampleStation, kSampleTrainee);
    SessionState state = stateOf(writer);
    QVERIFY(state.participants().at(kSampleTrainee).registration == notGood);
    QVERIFY(!state.participants().at(kSampleOtherTrainee).registration);
    writer.add(atSeconds(2.0), fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"});
    state = stateOf(writer);
    QVERIFY(!state.participants().at(kSampleTrainee).registration); // another place, perhaps
}

void TestSessionState::movesThroughThePhasesAtTheirTimes()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(10.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(20.0), fact::PhaseChanged{SessionPhase::Paused});
    writer.add(atSeconds(30.0), fact::PhaseChanged{SessionPhase::Ended});
    const SessionState state = stateOf(writer);
    QVERIFY(state.phaseAt(atSeconds(10.0) - Duration{1}) == SessionPhase::Prepared);
    QVERIFY(state.phaseAt(atSeconds(10.0)) == SessionPhase::Running);
    QVERIFY(state.phaseAt(atSeconds(20.0)) == SessionPhase::Paused);
    QVERIFY(state.phaseAt(atSeconds(30.0)) == SessionPhase::Ended);
}

void TestSessionState::countsOnlyRunningTime()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(10.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(20.0), fact::PhaseChanged{SessionPhase::Paused});
    writer.add(atSeconds(50.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(60.0), fact::PhaseChanged{SessionPhase::Ended});
    const SessionState state = stateOf(writer);
    using std::chrono::seconds;
    QVERIFY(state.runningTime(atSeconds(9.0)) == seconds{0});
    QVERIFY(state.runningTime(atSeconds(13.0)) == seconds{3});
    QVERIFY(state.runningTime(atSeconds(40.0)) == seconds{10});
    QVERIFY(state.runningTime(atSeconds(51.0)) == seconds{11});
    QVERIFY(state.runningTime(atSeconds(900.0)) == seconds{20});
    for (const double ran : {0.5, 3.0, 9.5, 10.5, 19.5}) {
        const SessionTime when = state.whenRan(fromSeconds(ran));
        QVERIFY(state.runningTime(when) == fromSeconds(ran));
    }
    QVERIFY(state.whenRan(seconds{10}) < atSeconds(40.0)); // at the end of the first part
}

void TestSessionState::drivesEachStationByItsOwnFacts()
{
    LogWriter writer = sampleSession();
    const StationId second{7};
    writer.add(atSeconds(0.0), fact::StationAdded{"Station 2"}, second);
    writer.add(atSeconds(1.0), fact::BreathingRateSet{perMinute(33.0)}, second);
    writer.add(atSeconds(2.0), fact::TidalVolumeSet{millilitres(510.0)}, second);
    writer.add(atSeconds(3.0), fact::InspiratoryFractionSet{0.5}, second);
    writer.add(atSeconds(4.0), fact::AnatomyChosen{"77", "Child"}, second);
    const SessionState state = stateOf(writer);
    const auto at = [&](StationId id, double seconds) {
        return state.stations().at(id).respiration.settingsAt(atSeconds(seconds)).pattern;
    };
    QCOMPARE(at(second, 0.9).rate, BreathingPattern{}.rate);
    QCOMPARE(at(second, 1.0).rate, perMinute(33.0));
    QCOMPARE(at(second, 1.9).tidalVolume, BreathingPattern{}.tidalVolume);
    QCOMPARE(at(second, 2.0).tidalVolume, millilitres(510.0));
    QCOMPARE(at(second, 2.9).inspiratoryFraction, BreathingPattern{}.inspiratoryFraction);
    QCOMPARE(at(second, 3.0).inspiratoryFraction, 0.5);
    QCOMPARE(state.stations().at(second).anatomyName, std::string{"Child"});
    QCOMPARE(at(kSampleStation, 9.0).rate, BreathingPattern{}.rate);
    QCOMPARE(at(kSampleStation, 9.0).tidalVolume, BreathingPattern{}.tidalVolume);
    QCOMPARE(at(kSampleStation, 9.0).inspiratoryFraction, BreathingPattern{}.inspiratoryFraction);
    QVERIFY(state.stations().at(kSampleStation).anatomyName.empty());
}

void TestSessionState::breathesOnlyWhileItRuns()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(0.0), fact::BreathingRateSet{perMinute(30.0)});
    writer.add(atSeconds(10.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(20.0), fact::PhaseChanged{SessionPhase::Paused});
    const SessionState state = stateOf(writer);
    QCOMPARE(breathsAt(state, kSampleStation, 10.0), 0.0);
    VERIFY_BREATHS(breathsAt(state, kSampleStation, 16.0), 3.0);
    VERIFY_BREATHS(breathsAt(state, kSampleStation, 99.0), 5.0);
}

void TestSessionState::letsALateStationRunAtOnce()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(10.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(12.0), fact::StationAdded{"late"}, StationId{1});
    writer.add(atSeconds(20.0), fact::PhaseChanged{SessionPhase::Paused});
    const SessionState state = stateOf(writer);
    for (const double seconds : {11.0, 15.0, 30.0})
        QCOMPARE(breathsAt(state, StationId{1}, seconds),
                 breathsAt(state, kSampleStation, seconds));
}

void TestSessionState::namesAStationAnewWithoutForgettingIt()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::BreathingRateSet{perMinute(30.0)});
    writer.add(atSeconds(2.0), fact::StationAdded{"Room 5"});
    const SessionState state = stateOf(writer);
    const Station& station = state.stations().at(kSampleStation);
    QCOMPARE(station.name, std::string{"Room 5"});
    QCOMPARE(station.respiration.settingsAt(atSeconds(3.0)).pattern.rate, perMinute(30.0));
}

void TestSessionState::ignoresWhatItDoesNotKnow_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::newRow("rate") << FactBody{fact::BreathingRateSet{perMinute(30.0)}};
    QTest::newRow("tidal volume") << FactBody{fact::TidalVolumeSet{millilitres(300.0)}};
    QTest::newRow("inspiratory fraction") << FactBody{fact::InspiratoryFractionSet{0.3}};
    QTest::newRow("anatomy") << FactBody{fact::AnatomyChosen{"aa", "A"}};
    QTest::newRow("participant") << FactBody{fact::ParticipantLeft{ParticipantId{77}}};
}

void TestSessionState::ignoresWhatItDoesNotKnow()
{
    QFETCH(const FactBody, body);
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), body, StationId{99});
    const SessionState state = stateOf(writer);
    QCOMPARE(state.lastApplied().value, writer.log().size());
    QCOMPARE(state.stations().size(), std::size_t{1});
    QCOMPARE(state.participants().size(), std::size_t{4});
}

void TestSessionState::isTheSameAtEveryNode()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::PhaseChanged{SessionPhase::Running});
    for (int i = 0; i < 50; ++i) {
        writer.add(atSeconds(2.0 + i), fact::BreathingRateSet{perMinute(10.0 + i)});
        writer.add(atSeconds(3.0 + i), fact::TidalVolumeSet{millilitres(200.0 + i)});
    }
    const SessionState here = stateOf(writer);
    SessionState early; // copied half-way, as a snapshot is
    for (std::size_t i = 0; i < 40; ++i)
        early.apply(writer.log()[i]);
    SessionState there = early;
    for (std::size_t i = 40; i < writer.log().size(); ++i)
        there.apply(writer.log()[i]);
    for (double seconds = 0.0; seconds < 70.0; seconds += 0.37) {
        const SessionTime t = atSeconds(seconds);
        const auto settings = [t](const SessionState& state) {
            return state.stations().at(kSampleStation).respiration.settingsAt(t);
        };
        QVERIFY(settings(here) == settings(there)); // to the last bit
        QVERIFY(here.runningTime(t) == there.runningTime(t));
    }
    QCOMPARE(early.lastApplied().value, std::uint64_t{40});
}

void TestSessionState::stopsAtAGapInTheNumbers_data()
{
    QTest::addColumn<int>("number");
    QTest::newRow("the same again") << 7;
    QTest::newRow("one left out") << 9;
    QTest::newRow("none") << 0;
}

/// A broken contract aborts: seen from outside, in a child.
void TestSessionState::stopsAtAGapInTheNumbers()
{
    QFETCH(const int, number);
    SessionState state = stateOf(sampleSession());
    Fact fact;
    fact.number = FactNumber{std::uint64_t(number)};
    const pid_t child = fork();
    if (child == 0) {
        close(STDERR_FILENO);
        signal(SIGABRT, SIG_DFL);
        state.apply(fact);
        _exit(0);
    }
    int status = 0;
    QCOMPARE(waitpid(child, &status, 0), child);
    QVERIFY(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
}

CARINA_TEST(TestSessionState)

} // namespace carina::test::session_state_test

#include "tst_session_state.moc"
