#include "engine/session/participant_limits.h"
#include "engine/session/station_rules.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

namespace carina::test::stations_test
{

/// Several stations in a session: who opens and closes them, who is at them, what goes with whom.
class TestStations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areNumberedByTheHost();
    void areOneToEight();
    void areNotOpenedWithoutEnd();
    void areToldApartByTheirNames();
    void areClosedOnceNobodyIsThere();
    void takeNothingOnceTheyAreClosed_data();
    void takeNothingOnceTheyAreClosed();
    void areRunByInstructors_data();
    void areRunByInstructors();
    void areSpokenForByThoseWhoAreThere_data();
    void areSpokenForByThoseWhoAreThere();
    void giveTheirPatientToNobodyElsewhere();
    void welcomeWhoJoins();
    void areLeftWithOnesTools();
    void keepWhatCannotBeCarried();
    void followWhoComesBackElsewhere();
    void changeTogetherAtOneTime();
    void changeTogetherInThePatientOnly_data();
    void changeTogetherInThePatientOnly();
    void changeTogetherWithinTheBoundsOfEach();
    void areFoundByName();
};

namespace
{

constexpr StationId kSecond{1};
constexpr ObjectId kSecondPatient{2};

/// The sample session with an empty second station.
LogWriter twoStations()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::StationAdded{"Room 5"}, kSecond);
    return writer;
}

SessionAuthority authorityOf(const LogWriter& writer) { return SessionAuthority{writer.log()}; }

void moveAll(LogWriter& writer, StationId to)
{
    for (const ParticipantId id :
         {kSampleInstructor, kSampleTrainee, kSampleObserver, kSampleOtherTrainee})
        writer.add(kNow, fact::ParticipantMoved{id}, to);
}

} // namespace

void TestStations::areNumberedByTheHost()
{
    SessionAuthority authority = sampleAuthority();
    const auto add = [&](const char* name) {
        const Result<Fact> fact =
            judgeBy(authority, kSampleInstructor, fact::StationAdded{name}, kNoStation);
        authority.commit(*fact);
        return fact->station;
    };
    QCOMPARE(add("Two"), StationId{1});
    QCOMPARE(add("Three"), StationId{2});
    authority.commit(*judgeBy(authority, kSampleInstructor, fact::StationClosed{}, StationId{2}));
    QCOMPARE(add("Three"), StationId{3}); // a number is not used again
    for (const StationId own : {StationId{1}, StationId{9}, kAllStations})
        QCOMPARE(verdict(judgeBy(authority, kSampleHost, fact::StationAdded{"Own"}, own)),
                 QByteArray{"out of range"});
}

void TestStations::areOneToEight()
{
    LogWriter writer = sampleSession();
    for (std::uint16_t i = 1; i < kMostStations; ++i)
        writer.add(kNow, fact::StationAdded{"Room " + std::to_string(i)}, StationId{i});
    const fact::StationAdded another{"Hall"};
    QCOMPARE(verdict(judgeBy(authorityOf(writer), kSampleHost, another, kNoStation)),
             QByteArray{"station count"});
    writer.add(kNow, fact::StationClosed{}, StationId{3});
    QCOMPARE(verdict(judgeBy(authorityOf(writer), kSampleHost, another, kNoStation)),
             QByteArray{"fine"});
    for (std::uint16_t i = 1; i < kMostStations; ++i)
        writer.add(kNow, fact::StationClosed{}, StationId{i});
    for (const ParticipantId id :
         {kSampleInstructor, kSampleTrainee, kSampleObserver, kSampleOtherTrainee})
        writer.add(kNow, fact::ParticipantLeft{id});
    QCOMPARE(verdict(judgeBy(authorityOf(writer), kSampleHost, fact::StationClosed{})),
             QByteArray{"station count"}); // the last
}

void TestStations::areNotOpenedWithoutEnd()
{
    LogWriter writer = sampleSession();
    for (std::uint16_t i = 1; i < kMostStationsEver; ++i) {
        QCOMPARE(verdict(judgeBy(authorityOf(writer), kSampleHost, fact::StationAdded{"Hall"},
                                 kNoStation)),
                 QByteArray{"fine"});
        writer.add(kNow, fact::StationAdded{"Hall"}, StationId{i});
        writer.add(kNow, fact::StationClosed{}, StationId{i});
    }
    QCOMPARE(
        verdict(judgeBy(authorityOf(writer), kSampleHost, fact::StationAdded{"Hall"}, kNoStation)),
        QByteArray{"station count"});
}

void TestStations::areToldApartByTheirNames()
{
    LogWriter writer = twoStations();
    const auto adding = [&](const char* name) {
        return verdict(
            judgeBy(authorityOf(writer), kSampleInstructor, fact::StationAdded{name}, kNoStation));
    };
    const auto naming = [&](StationId station, const char* name) {
        return verdict(
            judgeBy(authorityOf(writer), kSampleInstructor, fact::StationRenamed{name}, station));
    };
    for (const char* name : {"ROOM 5", "Room5", "R\u043e\u043em 5", "", " Room 6", "Room\u200b6"}) {
        QCOMPARE(adding(name), QByteArray{"name unclear"});
        QCOMPARE(naming(kSampleStation, name), QByteArray{"name unclear"});
    }
    QCOMPARE(adding("Room 6"), QByteArray{"fine"});
    QCOMPARE(naming(kSecond, "ROOM 5"), QByteArray{"fine"}); // its own, written otherwise
    QCOMPARE(naming(kSampleStation, "Room 6"), QByteArray{"fine"});
    QCOMPARE(adding(std::string(65, 'x').c_str()), QByteArray{"out of range"});
    QCOMPARE(naming(kSecond, std::string(65, 'x').c_str()), QByteArray{"out of range"});
    writer.add(kNow, fact::StationRenamed{"Hall"}, kSecond);
    QCOMPARE(stateOf(writer).stations().at(kSecond).name, std::string{"Hall"});
    QCOMPARE(adding("Room 5"), QByteArray{"fine"});
    writer.add(kNow, fact::StationClosed{}, kSecond);
    QCOMPARE(adding("Hall"), QByteArray{"fine"});
}

void TestStations::areClosedOnceNobodyIsThere()
{
    LogWriter writer = twoStations();
    const auto closing = [&](StationId station) {
        return judgeBy(authorityOf(writer), kSampleInstructor, fact::StationClosed{}, station);
    };
    QCOMPARE(verdict(closing(kSecond)), QByteArray{"fine"});
    const Result<Fact> occupied = closing(kSampleStation);
    QCOMPARE(verdict(occupied), QByteArray{"station occupied"});
    QCOMPARE(occupied.error().detail, std::string{"Ina, Tom, Olga, Tess"});
    writer.add(kNow, fact::ParticipantLeft{kSampleTrainee}); // who is away is not there
    QCOMPARE(closing(kSampleStation).error().detail, std::string{"Ina, Olga, Tess"});
    moveAll(writer, kSecond);
    QCOMPARE(verdict(closing(kSampleStation)), QByteArray{"fine"});
    QCOMPARE(verdict(closing(kSecond)), QByteArray{"station occupied"});
}

void TestStations::takeNothingOnceTheyAreClosed_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::newRow("rate") << FactBody{fact::BreathingRateSet{perMinute(20.0)}};
    QTest::newRow("anatomy") << FactBody{fact::AnatomyChosen{"aa", "A"}};
    QTest::newRow("name") << FactBody{fact::StationRenamed{"Hall"}};
    QTest::newRow("closing") << FactBody{fact::StationClosed{}};
    QTest::newRow("move") << FactBody{fact::ParticipantMoved{kSampleTrainee}};
    QTest::newRow("join") << FactBody{fact::ParticipantJoined{{}, Role::Trainee, "New"}};
    QTest::newRow("object") << FactBody{
        fact::ObjectShared{{}, kSampleTrainee, ObjectKind::Head, "head"}};
}

void TestStations::takeNothingOnceTheyAreClosed()
{
    QFETCH(const FactBody, body);
    LogWriter writer = twoStations();
    QCOMPARE(verdict(judgeBy(authorityOf(writer), kSampleHost, body, kSecond)), QByteArray{"fine"});
    writer.add(kNow, fact::StationClosed{}, kSecond);
    const Result<Fact> refused = judgeBy(authorityOf(writer), kSampleHost, body, kSecond);
    QCOMPARE(verdict(refused), QByteArray{"station unknown"});
    QCOMPARE(refused.error().detail, std::string{"Room 5"});
    QCOMPARE(verdict(judgeBy(authorityOf(writer), kSampleHost, body, StationId{9})),
             QByteArray{"station unknown"});
}

void TestStations::areRunByInstructors_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<int>("station");
    const auto row = [](const char* name, const FactBody& body, StationId station) {
        QTest::newRow(name) << body << int(station.value);
    };
    row("add", fact::StationAdded{"Hall"}, kNoStation);
    row("name", fact::StationRenamed{"Hall"}, kSampleStation);
    row("close", fact::StationClosed{}, kSecond);
    row("move to another", fact::ParticipantMoved{kSampleTrainee}, kSecond);
    row("move to the same", fact::ParticipantMoved{kSampleTrainee}, kSampleStation);
    row("all", fact::BreathingRateSet{perMinute(20.0)}, kAllStations);
}

void TestStations::areRunByInstructors()
{
    QFETCH(const FactBody, body);
    QFETCH(const int, station);
    const SessionAuthority authority = authorityOf(twoStations());
    const auto by = [&](ParticipantId author) {
        return verdict(judgeBy(authority, author, body, StationId{std::uint16_t(station)}));
    };
    QCOMPARE(by(kSampleHost), QByteArray{"fine"});
    QCOMPARE(by(kSampleInstructor), QByteArray{"fine"});
    for (const ParticipantId other :
         {kSampleTrainee, kSampleObserver, kSampleOtherTrainee, kNobody, ParticipantId{42}})
        QCOMPARE(by(other), QByteArray{"not permitted"});
}

void TestStations::areSpokenForByThoseWhoAreThere_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::newRow("share") << FactBody{
        fact::ObjectShared{{}, kSampleTrainee, ObjectKind::Head, "head"}};
    QTest::newRow("share again") << FactBody{
        fact::ObjectShared{kSampleTube, kSampleTrainee, ObjectKind::Tube, "tube"}};
    QTest::newRow("hand over") << FactBody{
        fact::ObjectHandedOver{kSampleTube, kSampleInstructor, 1}};
    QTest::newRow("breath") << FactBody{fact::ManikinBreathed{kNow}};
    QTest::newRow("cuff") << FactBody{fact::CuffSet{true}};
    QTest::newRow("stylet") << FactBody{fact::StyletDrawn{}};
    QTest::newRow("end of a try") << FactBody{fact::TryEnded{}};
}

void TestStations::areSpokenForByThoseWhoAreThere()
{
    QFETCH(const FactBody, body);
    LogWriter writer = twoStations();
    const auto of = [&](StationId station) {
        return verdict(judgeBy(authorityOf(writer), kSampleTrainee, body, station));
    };
    QCOMPARE(of(kSampleStation), QByteArray{"fine"});
    for (const StationId other : {kSecond, kAllStations, kNoStation})
        QCOMPARE(of(other), QByteArray{"not permitted"});
    writer.add(kNow, fact::ParticipantMoved{kSampleTrainee}, kSecond);
    QCOMPARE(of(kSecond), QByteArray{"fine"});
    QCOMPARE(of(kSampleStation), QByteArray{"not permitted"});
}

void TestStations::giveTheirPatientToNobodyElsewhere()
{
    LogWriter writer = twoStations();
    writer.add(kNow, fact::ObjectShared{kSecondPatient, kSampleHost, ObjectKind::Patient, "Adult"},
               kSecond);
    const auto asking = [&](ParticipantId who, StationId from) {
        return verdict(judgeBy(authorityOf(writer), who, fact::ObjectWanted{kSecondPatient}, from));
    };
    const auto giving = [&](ParticipantId to) {
        return verdict(judgeBy(authorityOf(writer), kSampleInstructor,
                               fact::ObjectHandedOver{kSecondPatient, to, 1}, kSecond));
    };
    QCOMPARE(asking(kSampleTrainee, kSampleStation), QByteArray{"not permitted"});
    QCOMPARE(asking(kSampleTrainee, kSecond), QByteArray{"not permitted"});
    QCOMPARE(asking(kSampleInstructor, kSecond), QByteArray{"fine"});
    QCOMPARE(giving(kSampleTrainee), QByteArray{"not permitted"});
    QCOMPARE(giving(kSampleInstructor), QByteArray{"fine"}); // who acts at every station
    writer.add(kNow, fact::ParticipantMoved{kSampleTrainee}, kSecond);
    QCOMPARE(asking(kSampleTrainee, kSecond), QByteArray{"fine"});
    QCOMPARE(giving(kSampleTrainee), QByteArray{"fine"});
}

void TestStations::welcomeWhoJoins()
{
    LogWriter writer = twoStations();
    const auto comesTo = [&](const char* name, StationId asked) {
        return judgeBy(authorityOf(writer), kNobody,
                       fact::ParticipantJoined{{}, Role::Trainee, name}, asked)
            ->station;
    };
    QCOMPARE(comesTo("New", kNoStation), kSampleStation);
    QCOMPARE(comesTo("New", kSecond), kSecond);
    writer.add(kNow, fact::ParticipantMoved{kSampleTrainee}, kSecond);
    QCOMPARE(comesTo("Tom", kNoStation), kSecond); // where he was
    QCOMPARE(comesTo("Tom", kSampleStation), kSampleStation);
    writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
    writer.add(kNow, fact::StationClosed{}, kSecond);
    QCOMPARE(comesTo("Tom", kNoStation), kSampleStation);
    writer.add(kNow, fact::StationAdded{"Hall"}, StationId{2});
    moveAll(writer, StationId{2});
    writer.add(kNow, fact::StationClosed{}, kSampleStation);
    QCOMPARE(comesTo("New", kNoStation), StationId{2});

    LogWriter none;
    none.add(kNow, fact::SessionCreated{"S", "1"});
    QCOMPARE(verdict(judgeBy(authorityOf(none), kNobody,
                             fact::ParticipantJoined{{}, Role::Trainee, "New"}, kNoStation)),
             QByteArray{"station unknown"});
}

void TestStations::areLeftWithOnesTools()
{
    LogWriter writer = twoStations();
    writer.add(kNow, fact::ObjectShared{ObjectId{2}, kSampleOtherTrainee, ObjectKind::Tube, "b"});
    writer.add(kNow, fact::ParticipantMoved{kSampleTrainee}, kSecond);
    const SessionState state = stateOf(writer);
    QCOMPARE(state.stationOf(kSampleTrainee), kSecond);
    QVERIFY(state.participants().at(kSampleTrainee).moved == kNow);
    QCOMPARE(state.objects().at(kSampleTube).station, kSecond);
    QCOMPARE(state.objects().at(kSampleTube).owner, kSampleTrainee);
    QCOMPARE(state.objects().at(kSampleTube).epoch, std::uint16_t{1});
    QCOMPARE(state.stationOf(kSampleOtherTrainee), kSampleStation);
    QCOMPARE(state.objects().at(ObjectId{2}).station, kSampleStation);
    QCOMPARE(verdict(judgeBy(authorityOf(writer), kSampleInstructor,
                             fact::ParticipantMoved{ParticipantId{42}}, kSecond)),
             QByteArray{"out of range"});
}

/// A trainee loses the patient to the host, and what they asked for; an instructor keeps both.
void TestStations::keepWhatCannotBeCarried()
{
    for (const ParticipantId who : {kSampleTrainee, kSampleInstructor}) {
        LogWriter writer = twoStations();
        writer.add(kNow, fact::ObjectShared{ObjectId{2}, who, ObjectKind::Patient, "Adult"});
        writer.add(kNow,
                   fact::ObjectShared{ObjectId{3}, kSampleHost, ObjectKind::Patient, "Child"});
        writer.add(kNow, fact::ObjectWanted{ObjectId{3}}, kSampleStation, who);
        writer.add(kNow, fact::ParticipantMoved{who}, kSecond);
        const SessionState state = stateOf(writer);
        const bool keeps = who == kSampleInstructor;
        const SharedObject& patient = state.objects().at(ObjectId{2});
        QCOMPARE(patient.station, kSampleStation);
        QCOMPARE(patient.owner, keeps ? who : kSampleHost);
        QCOMPARE(patient.epoch, std::uint16_t(keeps ? 1 : 2));
        QCOMPARE(state.objects().at(ObjectId{3}).wantedBy.size(), std::size_t(keeps ? 1 : 0));
    }
}

void TestStations::followWhoComesBackElsewhere()
{
    LogWriter writer = twoStations();
    writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
    writer.add(kNow, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"}, kSecond);
    const SessionState state = stateOf(writer);
    QCOMPARE(state.stationOf(kSampleTrainee), kSecond);
    QVERIFY(!state.participants().at(kSampleTrainee).moved); // by their own choice
    QCOMPARE(state.objects().at(kSampleTube).station, kSecond);
}

/// One fact, so that no station can have another effect time than the others.
void TestStations::changeTogetherAtOneTime()
{
    LogWriter writer = twoStations();
    writer.add(kNow, fact::StationAdded{"Hall"}, StationId{2});
    writer.add(kNow, fact::StationClosed{}, StationId{2});
    SessionAuthority authority = authorityOf(writer);
    const Result<Fact> fact = authority.judge(
        {ProposalId{5}, kSampleInstructor, kAllStations, fact::BreathingRateSet{perMinute(31.0)}},
        kNow, std::chrono::milliseconds{250});
    QVERIFY(fact);
    QCOMPARE(fact->station, kAllStations);
    QVERIFY(fact->effect == kNow + std::chrono::milliseconds{250});
    authority.commit(*fact);
    authority.commit(
        *judgeBy(authority, kSampleHost, fact::StationAdded{"added later"}, kNoStation));
    const auto rateOf = [&](StationId station, SessionTime t) {
        return authority.state().stations().at(station).respiration.settingsAt(t).pattern.rate;
    };
    for (const StationId open : {kSampleStation, kSecond}) {
        QCOMPARE(rateOf(open, fact->effect - Duration{1}), BreathingPattern{}.rate);
        QCOMPARE(rateOf(open, fact->effect), perMinute(31.0));
    }
    for (const StationId other : {StationId{2}, StationId{3}}) // closed; not there yet
        QCOMPARE(rateOf(other, fact->effect), BreathingPattern{}.rate);
}

void TestStations::changeTogetherInThePatientOnly_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const FactBody& body, const char* expected) {
        QTest::newRow(name) << body << QByteArray{expected};
    };
    row("rate", fact::BreathingRateSet{perMinute(20.0)}, "fine");
    row("tidal volume", fact::TidalVolumeSet{millilitres(300.0)}, "fine");
    row("fraction", fact::InspiratoryFractionSet{0.4}, "fine");
    row("build", fact::PatientBuildSet{}, "fine");
    row("conditions", fact::LungConditionsSet{}, "fine");
    row("ventilator", fact::VentilatorSet{}, "fine");
    row("tube", fact::TubePlaced{}, "fine");
    row("position", fact::BodyPositionSet{BodyPosition::Prone}, "fine");
    row("apnoea", fact::BreathingStopped{}, "fine");
    row("bag", fact::BagSqueezed{}, "fine");
    row("airway", fact::AirwayEventsSet{}, "fine");
    row("head", fact::HeadPositionSet{}, "fine");
    row("gas", fact::GasSupplySet{}, "fine");
    row("drug", fact::DrugGiven{{DrugKind::Propofol, 100.0}}, "fine");
    row("cuff", fact::CuffSet{}, "fine");
    row("kink", fact::TubeObstructed{0.5}, "fine");
    row("stylet", fact::StyletDrawn{}, "station unknown");
    row("end of a try", fact::TryEnded{}, "station unknown");
    row("intubation", fact::IntubationNoted{{IntubationStep::BladeIn, kNow}}, "station unknown");
    row("anatomy", fact::AnatomyChosen{"aa", "A"}, "fine");
    row("phase", fact::PhaseChanged{SessionPhase::Running}, "fine"); // of no station
    row("breath", fact::ManikinBreathed{kNow}, "station unknown");
    row("object", fact::ObjectShared{{}, kSampleHost, ObjectKind::Head, "head"}, "station unknown");
    row("name", fact::StationRenamed{"Hall"}, "station unknown");
    row("closing", fact::StationClosed{}, "station unknown");
    row("move", fact::ParticipantMoved{kSampleTrainee}, "station unknown");
    row("join", fact::ParticipantJoined{{}, Role::Trainee, "New"}, "station unknown");
}

void TestStations::changeTogetherInThePatientOnly()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, expected);
    QCOMPARE(verdict(judgeBy(authorityOf(twoStations()), kSampleHost, body, kAllStations)),
             expected);
}

/// The deep breath of an adult is too much for the child of 40 kg at the first station.
void TestStations::changeTogetherWithinTheBoundsOfEach()
{
    const fact::TidalVolumeSet deep{millilitres(1500.0)};
    const fact::PatientBuildSet adult{{metres(1.75), 77.0, 40.0, Sex::Male}};
    LogWriter writer = twoStations();
    writer.add(kNow, adult, kSecond);
    const auto to = [&](StationId station) {
        return verdict(judgeBy(authorityOf(writer), kSampleInstructor, deep, station));
    };
    QCOMPARE(to(kSecond), QByteArray{"fine"});
    QCOMPARE(to(kAllStations), QByteArray{"out of range"});
    writer.add(kNow, adult, kSampleStation);
    QCOMPARE(to(kAllStations), QByteArray{"fine"});
}

void TestStations::areFoundByName()
{
    LogWriter writer = twoStations();
    const SessionState state = stateOf(writer);
    QVERIFY(openStationNamed(state, "Room 5") == kSecond);
    QVERIFY(openStationNamed(state, "room 5") == kSecond);
    QVERIFY(!openStationNamed(state, "Room 6"));
    QVERIFY(!openStationNamed(state, ""));
    QCOMPARE(openStationNames(state), std::string{"Station 1, Room 5"});
    writer.add(kNow, fact::StationClosed{}, kSecond);
    QVERIFY(!openStationNamed(stateOf(writer), "Room 5"));
    QCOMPARE(openStationNames(stateOf(writer)), std::string{"Station 1"});
    QCOMPARE(SessionState{}.stationOf(kSampleTrainee), kNoStation);
}

CARINA_TEST(TestStations)

} // namespace carina::test::stations_test

#include "tst_stations.moc"
