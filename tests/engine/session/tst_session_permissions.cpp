#include "engine/session/participant_limits.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

namespace carina::test::session_permissions_test
{

/// Who may do what, and when.
class TestSessionPermissions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void permitsByRole_data();
    void permitsByRole();
    void permitsPhasesInTheirOrder_data();
    void permitsPhasesInTheirOrder();
    void takesOnlyPeopleAndObjectsAfterTheEnd_data();
    void takesOnlyPeopleAndObjectsAfterTheEnd();
    void createsFirstAndOnce();
    void refusesValuesThatNoPatientHas();
    void refusesANameThatLooksLikeAnothers();
    void limitsObjectsByRole();
    void takesAsManyAsItsRolesHave();
    void namesOfOneRoleKeepOutNoOther_data();
    void namesOfOneRoleKeepOutNoOther();
    void knowsTheStationItIsAbout_data();
    void knowsTheStationItIsAbout();
    void hearsOfAManikinFromThoseWhoAreAtIt();
    void hearsOfAnIntubationFromWhoIsAtWork();
    void letsNoTraineeSqueezeTheBagButWhoIsAtWork();
    void refusesACheckpointOfWhatIsToCome();
};

namespace
{

constexpr ParticipantId kStranger{42};

/// The sample session moved to a phase by the ways there are.
SessionAuthority authorityIn(SessionPhase phase)
{
    LogWriter writer = sampleSession();
    const auto enter = [&](SessionPhase next) {
        writer.add(atSeconds(double(writer.log().size())), fact::PhaseChanged{next});
    };
    if (phase != SessionPhase::Prepared)
        enter(SessionPhase::Running);
    if (phase == SessionPhase::Paused || phase == SessionPhase::Ended)
        enter(phase);
    return SessionAuthority{writer.log()};
}

fact::ParticipantJoined joinAs(const SessionState& state, ParticipantId id)
{
    const auto known = state.participants().find(id);
    if (known == state.participants().end())
        return {{}, Role::Trainee, "Newcomer"};
    return {{}, known->second.role, known->second.name};
}

fact::RespirationCheckpoint sampleCheckpoint()
{
    return {SessionTime{}, RespiratoryFold{RespiratorySettings{}}.state()};
}

fact::BodyCheckpoint sampleBody() { return {SessionTime{}, BodyFold{BodySettings{}}.state()}; }

fact::IntubationNoted notedNow(IntubationStep step)
{
    return {IntubationEvent{.step = step, .at = kNow}};
}

} // namespace

void TestSessionPermissions::permitsByRole_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<int>("author");
    QTest::addColumn<bool>("permitted");

    const SessionState state = sampleAuthority().state();
    const ParticipantId authors[] = {kSampleHost,     kSampleInstructor, kSampleTrainee,
                                     kSampleObserver, kStranger,         kNobody};
    const char* authorNames[] = {"host", "instructor", "trainee", "observer", "stranger", "nobody"};
    // One letter per author: y permitted, n not.
    const auto row = [&](const char* action, const char* who, auto bodyOf) {
        for (std::size_t i = 0; i < std::size(authors); ++i)
            QTest::addRow("%s %s", authorNames[i], action)
                << FactBody{bodyOf(authors[i])} << int(authors[i].value) << (who[i] == 'y');
    };
    row("starts", "yynnnn", [](auto) { return fact::PhaseChanged{SessionPhase::Running}; });
    row("sets the rate", "yynnnn", [](auto) { return fact::BreathingRateSet{perMinute(20.0)}; });
    row("sets the tidal volume", "yynnnn",
        [](auto) { return fact::TidalVolumeSet{millilitres(400.0)}; });
    row("sets the fraction", "yynnnn", [](auto) { return fact::InspiratoryFractionSet{0.3}; });
    row("sets the condition", "yynnnn", [](auto) { return fact::LungConditionsSet{}; });
    row("sets the ventilator", "yynnnn", [](auto) { return fact::VentilatorSet{}; });
    row("sets the patient", "yynnnn", [](auto) { return fact::PatientBuildSet{}; });
    row("chooses the strategy", "yynnnn", [](auto) { return fact::StrategyChosen{}; });
    row("turns the patient", "yynnnn", [](auto) { return fact::BodyPositionSet{}; });
    row("stops the breathing", "yynnnn", [](auto) { return fact::BreathingStopped{}; });
    row("makes the cords shut", "yynnnn", [](auto) {
        return fact::AirwayEventsSet{{{AirwayEventKind::Laryngospasm, 1.0}}, {}};
    });
    row("lays the head", "yynnnn", [](auto) { return fact::HeadPositionSet{kSniffing, {}}; });
    row("shows something", "yynnnn", [](auto) { return fact::LessonShown{}; });
    row("shares a view to show", "yynnnn", [](auto id) {
        return fact::ObjectShared{{}, id, ObjectKind::View, "view"};
    });
    row("shares a pointer", "yynnnn", [](auto id) {
        return fact::ObjectShared{{}, id, ObjectKind::Pointer, "pointer"};
    });
    row("places the tube", "yynnnn", [](auto) { return fact::TubePlaced{}; });
    row("sees the manikin breathe", "yyynnn", [](auto) { return fact::ManikinBreathed{kNow}; });
    row("states how its registration stands", "yyynnn",
        [](auto) { return fact::RegistrationStated{}; });
    row("leaves a checkpoint", "ynnnnn", [](auto) { return sampleCheckpoint(); });
    row("leaves one of the body", "ynnnnn", [](auto) { return sampleBody(); });
    row("leaves one of the capnograph", "ynnnnn",
        [](auto) { return fact::CapnographCheckpoint{}; });
    row("turns the oxygen up", "yynnnn", [](auto) {
        return fact::GasSupplySet{{1.0, true, true}};
    });
    row("gives a drug", "yynnnn", [](auto) {
        return fact::DrugGiven{{DrugKind::Propofol, 100.0}};
    });
    row("inflates the cuff", "yyynnn", [](auto) { return fact::CuffSet{true}; });
    row("draws the stylet", "yyynnn", [](auto) { return fact::StyletDrawn{}; });
    row("kinks the tube", "yynnnn", [](auto) { return fact::TubeObstructed{0.5}; });
    // Who is at work in this session is the trainee.
    row("squeezes a bag", "yyynnn", [](auto) { return fact::BagSqueezed{}; });
    row("ends a try", "yyynnn", [](auto) { return fact::TryEnded{}; });
    row("notes a step of the intubation", "ynynnn",
        [](auto) { return notedNow(IntubationStep::ThroughCords); });
    row("chooses the anatomy", "yynnnn", [](auto) { return fact::AnatomyChosen{"aa", "A"}; });
    row("comes back", "ynnnny", [&](auto id) { return joinAs(state, id); });
    row("comes back under its number", "nnnnnn", [&](ParticipantId id) {
        fact::ParticipantJoined joined = joinAs(state, id);
        joined.participant = id == kSampleHost ? kStranger : id;
        return joined;
    });
    row("brings a new trainee", "ynnnny", [](auto) {
        return fact::ParticipantJoined{{}, Role::Trainee, "New"};
    });
    row("makes Tom, who is here, an instructor", "nnnnnn", [](auto) {
        return fact::ParticipantJoined{{}, Role::Instructor, "Tom"};
    });
    row("sends the other trainee away", "ynnnnn",
        [](auto) { return fact::ParticipantLeft{kSampleOtherTrainee}; });
    row("says that the other trainee fell silent", "ynnnnn",
        [](auto) { return fact::ParticipantFellSilent{kSampleOtherTrainee}; });
    row("shares its own stylus", "yyynnn", [](auto id) {
        return fact::ObjectShared{{}, id, ObjectKind::Stylus, "stylus"};
    });
    row("shares a patient", "yynnnn", [](auto id) {
        return fact::ObjectShared{{}, id, ObjectKind::Patient, "patient"};
    });
    row("shares for the other trainee", "yynnnn", [](auto) {
        return fact::ObjectShared{{}, kSampleOtherTrainee, ObjectKind::Stylus, "stylus"};
    });
    row("shares its tube again", "nnynnn", [](auto id) {
        return fact::ObjectShared{kSampleTube, id, ObjectKind::Tube, "tube"};
    });
    // The host of this session has not come in, and nobody who has not can own anything.
    row("takes the tube", "nynnnn", [](auto id) {
        return fact::ObjectHandedOver{kSampleTube, id, 1};
    });
    row("gives the tube to the other trainee, who did not ask", "yynnnn", [](auto) {
        return fact::ObjectHandedOver{kSampleTube, kSampleOtherTrainee, 1};
    });
    row("gives the tube to the instructor", "yyynnn", [](auto) {
        return fact::ObjectHandedOver{kSampleTube, kSampleInstructor, 1};
    });
    row("gives the tube to an observer", "nnnnnn", [](auto) {
        return fact::ObjectHandedOver{kSampleTube, kSampleObserver, 1};
    });
    row("asks for the tube", "yyynnn", [](auto) { return fact::ObjectWanted{kSampleTube}; });
    row("asks for it no more, not having asked", "nnnnnn", [](auto) {
        return fact::ObjectWanted{kSampleTube, false};
    });
    // The one at work in this session is the trainee, who has its tube.
    row("takes the work, or keeps its own", "nyynnn", [](auto id) {
        return fact::WorkTaken{id, kSampleTrainee};
    });
    row("gives the work to the other trainee", "yyynnn", [](auto) {
        return fact::WorkTaken{kSampleOtherTrainee, kSampleTrainee};
    });
    row("gives the work to an observer", "nnnnnn", [](auto) {
        return fact::WorkTaken{kSampleObserver, kSampleTrainee};
    });
    row("gives the work to nobody", "nnnnnn", [](auto) {
        return fact::WorkTaken{kNobody, kSampleTrainee};
    });
    row("chooses its own place", "nyynnn", [](auto id) {
        return fact::PlaceChosen{id, degrees(90.0)};
    });
    row("chooses the place of the other trainee", "yynnnn", [](auto) {
        return fact::PlaceChosen{kSampleOtherTrainee, degrees(90.0)};
    });
    QTest::newRow("other trainee takes the work from who is at work")
        << FactBody{fact::WorkTaken{kSampleOtherTrainee, kSampleTrainee}}
        << int(kSampleOtherTrainee.value) << false;
    QTest::newRow("other trainee takes the tube")
        << FactBody{fact::ObjectHandedOver{kSampleTube, kSampleOtherTrainee, 1}}
        << int(kSampleOtherTrainee.value) << false;
    for (std::size_t i = 1; i < 4; ++i)
        QTest::addRow("%s leaves", authorNames[i])
            << FactBody{fact::ParticipantLeft{authors[i]}} << int(authors[i].value) << false;
}

void TestSessionPermissions::permitsByRole()
{
    QFETCH(const FactBody, body);
    QFETCH(const int, author);
    QFETCH(const bool, permitted);
    const Result<Fact> fact =
        judgeBy(sampleAuthority(), ParticipantId{std::uint16_t(author)}, body);
    QCOMPARE(fact.has_value(), permitted);
}

void TestSessionPermissions::permitsPhasesInTheirOrder_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::addColumn<QByteArray>("expected");
    const char* names[] = {"prepared", "running", "paused", "ended"};
    const char* expected[] = {"nyny", "nnyy", "nyny", "eeee"}; // e: session ended
    for (int from = 0; from < 4; ++from)
        for (int to = 0; to < 4; ++to)
            QTest::addRow("%s to %s", names[from], names[to])
                << from << to
                << QByteArray{expected[from][to] == 'y'   ? "fine"
                              : expected[from][to] == 'n' ? "out of range"
                                                          : "session ended"};
}

void TestSessionPermissions::permitsPhasesInTheirOrder()
{
    QFETCH(const int, from);
    QFETCH(const int, to);
    QFETCH(const QByteArray, expected);
    const SessionAuthority authority = authorityIn(SessionPhase(from));
    QCOMPARE(verdict(judgeBy(authority, kSampleInstructor, fact::PhaseChanged{SessionPhase(to)})),
             expected);
}

void TestSessionPermissions::takesOnlyPeopleAndObjectsAfterTheEnd_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const FactBody& body, const char* expected) {
        QTest::newRow(name) << body << QByteArray{expected};
    };
    row("join", fact::ParticipantJoined{{}, Role::Observer, "Late"}, "fine");
    row("leave", fact::ParticipantLeft{kSampleTrainee}, "fine");
    row("fall silent", fact::ParticipantFellSilent{kSampleTrainee}, "fine");
    row("share", fact::ObjectShared{{}, kSampleTrainee, ObjectKind::Head, "head"}, "fine");
    row("hand over", fact::ObjectHandedOver{kSampleTube, kSampleInstructor, 1}, "fine");
    row("ask", fact::ObjectWanted{kSampleTube}, "fine");
    row("state a registration", fact::RegistrationStated{}, "fine");
    row("show something", fact::LessonShown{}, "fine");
    row("station's name", fact::StationRenamed{"S"}, "session ended");
    row("closing", fact::StationClosed{}, "session ended");
    row("move", fact::ParticipantMoved{kSampleTrainee}, "session ended");
    row("anatomy", fact::AnatomyChosen{"aa", "A"}, "session ended");
    row("work", fact::WorkTaken{kSampleOtherTrainee, kSampleTrainee}, "session ended");
    row("place", fact::PlaceChosen{kSampleTrainee, {}}, "session ended");
    row("rate", fact::BreathingRateSet{perMinute(20.0)}, "session ended");
    row("tidal volume", fact::TidalVolumeSet{millilitres(300.0)}, "session ended");
    row("fraction", fact::InspiratoryFractionSet{0.4}, "session ended");
    row("condition", fact::LungConditionsSet{}, "session ended");
    row("breath", fact::ManikinBreathed{}, "session ended");
    row("gas", fact::GasSupplySet{}, "session ended");
    row("drug", fact::DrugGiven{{DrugKind::Propofol, 100.0}}, "session ended");
    row("cuff", fact::CuffSet{true}, "session ended");
    row("stylet", fact::StyletDrawn{}, "session ended");
    row("end of a try", fact::TryEnded{}, "session ended");
    row("kink", fact::TubeObstructed{0.5}, "session ended");
    row("step of an intubation", notedNow(IntubationStep::BladeIn), "session ended");
}

void TestSessionPermissions::takesOnlyPeopleAndObjectsAfterTheEnd()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, expected);
    QCOMPARE(verdict(judgeBy(authorityIn(SessionPhase::Ended), kSampleHost, body)), expected);
}

void TestSessionPermissions::createsFirstAndOnce()
{
    const FactBody creation = fact::SessionCreated{"New", "ab"};
    const SessionAuthority empty{{}};
    QCOMPARE(verdict(judgeBy(empty, kSampleHost, creation)), QByteArray{"fine"});
    QCOMPARE(verdict(judgeBy(empty, kSampleHost, fact::StationAdded{"S"}, kNoStation)),
             QByteArray{"not permitted"});
    QCOMPARE(verdict(judgeBy(empty, kNobody, creation)), QByteArray{"not permitted"});
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, creation)),
             QByteArray{"not permitted"});

    // Not even an instructor who would be in an empty log's place.
    const Result<Fact> byInstructor = judgeBy(sampleAuthority(), kSampleInstructor, creation);
    QCOMPARE(byInstructor.error().detail, std::string{"Ina"});
}

void TestSessionPermissions::refusesValuesThatNoPatientHas()
{
    const SessionAuthority authority = sampleAuthority();
    QCOMPARE(
        verdict(judgeBy(authority, kSampleInstructor, fact::BreathingRateSet{perMinute(61.0)})),
        QByteArray{"out of range"});
    QCOMPARE(verdict(judgeBy(authority, kNobody,
                             fact::ParticipantJoined{{}, Role::Trainee, std::string(65, 'x')})),
             QByteArray{"out of range"});
}

/// Of a participant who is present or away, and of the host.
void TestSessionPermissions::refusesANameThatLooksLikeAnothers()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::ParticipantJoined{kSampleHost, Role::Instructor, "Dr. Hall"});
    writer.add(kNow, fact::ParticipantLeft{kSampleOtherTrainee});
    const SessionAuthority authority{writer.log()};
    const auto joining = [&](Role role, const char* name) {
        return verdict(judgeBy(authority, kNobody, fact::ParticipantJoined{{}, role, name}));
    };
    for (const char* name : {"TOM", "T\u043em", "To m", "dr. hall", "Tom\u200b"})
        QCOMPARE(joining(Role::Observer, name), QByteArray{"name unclear"});
    QCOMPARE(joining(Role::Trainee, "Tom"), QByteArray{"fine"}); // comes back
    QCOMPARE(joining(Role::Observer, "tess"), QByteArray{"name unclear"});
    QCOMPARE(joining(Role::Trainee, "Tess"), QByteArray{"fine"}); // comes back, too
    QCOMPARE(joining(Role::Trainee, " Tim"), QByteArray{"name unclear"});
    QCOMPARE(joining(Role::Trainee, "Tim"), QByteArray{"fine"});
}

/// A trainee has two objects of each kind and an observer none; the host as many as it likes.
void TestSessionPermissions::limitsObjectsByRole()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::ObjectShared{ObjectId{2}, kSampleTrainee, ObjectKind::Tube, "spare"});
    const SessionAuthority authority{writer.log()};
    const auto sharing = [](const SessionAuthority& judge, ParticipantId who, ObjectKind kind,
                            const char* name) {
        return verdict(judgeBy(judge, who, fact::ObjectShared{{}, who, kind, name}));
    };
    QCOMPARE(sharing(authority, kSampleTrainee, ObjectKind::Tube, "third tube"),
             QByteArray{"not permitted"});
    QCOMPARE(sharing(authority, kSampleTrainee, ObjectKind::Tube, "tube"), QByteArray{"fine"});
    QCOMPARE(sharing(authority, kSampleTrainee, ObjectKind::Stylus, "stylus"), QByteArray{"fine"});
    for (std::size_t i = 0; i < mostObjectsOf(Role::Instructor); ++i) {
        const std::string name = "object " + std::to_string(i);
        writer.add(kNow, fact::ObjectShared{ObjectId{std::uint16_t(10 + i)}, kSampleInstructor,
                                            ObjectKind::Tube, name});
        writer.add(kNow, fact::ObjectShared{ObjectId{std::uint16_t(200 + i)}, kSampleHost,
                                            ObjectKind::Tube, name});
    }
    const SessionAuthority full{writer.log()};
    QCOMPARE(sharing(full, kSampleInstructor, ObjectKind::Tube, "one more"),
             QByteArray{"not permitted"});
    QCOMPARE(sharing(full, kSampleInstructor, ObjectKind::Tube, "object 0"), QByteArray{"fine"});
    QCOMPARE(sharing(full, kSampleHost, ObjectKind::Tube, "one more"), QByteArray{"fine"});
}

void TestSessionPermissions::takesAsManyAsItsRolesHave()
{
    LogWriter writer = sampleSession();
    for (std::size_t i = 1; i < mostPresentOf(Role::Observer); ++i)
        writer.add(kNow, fact::ParticipantJoined{ParticipantId{std::uint16_t(100 + i)},
                                                 Role::Observer, "observer " + std::to_string(i)});
    const auto joining = [](const LogWriter& log, Role role) {
        return verdict(judgeBy(SessionAuthority{log.log()}, kNobody,
                               fact::ParticipantJoined{{}, role, "One more"}));
    };
    QCOMPARE(joining(writer, Role::Observer), QByteArray{"session full"});
    QCOMPARE(joining(writer, Role::Trainee), QByteArray{"fine"});
    writer.add(kNow, fact::ParticipantLeft{ParticipantId{101}});
    QCOMPARE(joining(writer, Role::Observer), QByteArray{"fine"});
}

/// Who has an observer's code could shut the session to every newcomer, by 1024 names.
void TestSessionPermissions::namesOfOneRoleKeepOutNoOther_data()
{
    QTest::addColumn<Role>("role");
    QTest::newRow("observers") << Role::Observer;
    QTest::newRow("trainees") << Role::Trainee;
    QTest::newRow("instructors") << Role::Instructor;
}

void TestSessionPermissions::namesOfOneRoleKeepOutNoOther()
{
    QFETCH(const Role, role);
    LogWriter writer = sampleSession();
    const auto names = [&] {
        const SessionState state = stateOf(writer);
        return std::size_t(std::ranges::count_if(
            state.participants(), [&](const auto& entry) { return entry.second.role == role; }));
    };
    for (std::size_t i = names(); i < mostNamesOf(role); ++i) {
        const ParticipantId id{std::uint16_t(1000 + i)};
        writer.add(kNow, fact::ParticipantJoined{id, role, "n" + std::to_string(i)});
        writer.add(kNow, fact::ParticipantLeft{id});
    }
    QCOMPARE(names(), mostNamesOf(role));
    const SessionAuthority authority{writer.log()};
    const auto joining = [&](Role as, const char* name) {
        return verdict(judgeBy(authority, kNobody, fact::ParticipantJoined{{}, as, name}));
    };
    for (const Role as : {Role::Instructor, Role::Trainee, Role::Observer})
        QCOMPARE(joining(as, "One more"), QByteArray{as == role ? "session full" : "fine"});
    QCOMPARE(joining(Role::Trainee, "Tom"), QByteArray{"fine"}); // comes back
}

void TestSessionPermissions::knowsTheStationItIsAbout_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("known");
    QTest::addColumn<QByteArray>("unknown");
    const auto row = [](const char* name, const FactBody& body, const char* known,
                        const char* unknown) {
        QTest::newRow(name) << body << QByteArray{known} << QByteArray{unknown};
    };
    row("join", fact::ParticipantJoined{{}, Role::Observer, "New"}, "fine", "station unknown");
    row("leave", fact::ParticipantLeft{kSampleTrainee}, "fine", "fine");
    row("fall silent", fact::ParticipantFellSilent{kSampleTrainee}, "fine", "fine");
    row("share", fact::ObjectShared{{}, kSampleTrainee, ObjectKind::Head, "head"}, "fine",
        "station unknown");
    row("anatomy", fact::AnatomyChosen{"aa", "A"}, "fine", "station unknown");
    row("work", fact::WorkTaken{kSampleOtherTrainee, kSampleTrainee}, "fine", "out of range");
    row("place", fact::PlaceChosen{kSampleTrainee, degrees(90.0)}, "fine", "station unknown");
    row("lesson", fact::LessonShown{}, "fine", "station unknown");
    row("end of a lesson", fact::LessonEnded{}, "out of range", "station unknown");
    row("rate", fact::BreathingRateSet{perMinute(20.0)}, "fine", "station unknown");
    row("tidal volume", fact::TidalVolumeSet{millilitres(300.0)}, "fine", "station unknown");
    row("fraction", fact::InspiratoryFractionSet{0.4}, "fine", "station unknown");
    row("condition", fact::LungConditionsSet{}, "fine", "station unknown");
    row("phase", fact::PhaseChanged{SessionPhase::Running}, "fine", "fine");
    row("registration", fact::RegistrationStated{}, "fine", "fine");
}

void TestSessionPermissions::knowsTheStationItIsAbout()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, known);
    QFETCH(const QByteArray, unknown);
    const SessionAuthority authority = sampleAuthority();
    QCOMPARE(verdict(judgeBy(authority, kSampleHost, body)), known);
    QCOMPARE(verdict(judgeBy(authority, kSampleHost, body, StationId{1})), unknown);
}

void TestSessionPermissions::hearsOfAManikinFromThoseWhoAreAtIt()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::StationAdded{"Station 2"}, StationId{1});
    const SessionAuthority authority{writer.log()};
    const auto heard = [&](ParticipantId author, StationId station) {
        return verdict(judgeBy(authority, author, fact::ManikinBreathed{kNow}, station));
    };
    QCOMPARE(heard(kSampleTrainee, kSampleStation), QByteArray{"fine"});
    QCOMPARE(heard(kSampleTrainee, StationId{1}), QByteArray{"not permitted"});
    QCOMPARE(heard(kSampleInstructor, StationId{1}), QByteArray{"fine"});
    QCOMPARE(heard(kSampleObserver, kSampleStation), QByteArray{"not permitted"});
}

void TestSessionPermissions::hearsOfAnIntubationFromWhoIsAtWork()
{
    LogWriter writer = sampleSession();
    const fact::IntubationNoted noted = notedNow(IntubationStep::BladeIn);
    const auto isHeard = [&](ParticipantId author) {
        return judgeBy(SessionAuthority{writer.log()}, author, noted).has_value();
    };
    QVERIFY(isHeard(kSampleTrainee));
    QVERIFY(!isHeard(kSampleOtherTrainee));
    writer.add(kNow, fact::WorkTaken{kSampleOtherTrainee, kSampleTrainee});
    QVERIFY(!isHeard(kSampleTrainee));
    QVERIFY(isHeard(kSampleOtherTrainee));
    QVERIFY(!isHeard(kSampleInstructor));
    writer.add(kNow, fact::WorkTaken{kSampleInstructor, kSampleOtherTrainee});
    QVERIFY(isHeard(kSampleInstructor));
    writer.add(kNow, fact::ParticipantMuted{kSampleInstructor, true});
    QVERIFY(!isHeard(kSampleInstructor));
    QVERIFY(isHeard(kSampleHost));
}

void TestSessionPermissions::letsNoTraineeSqueezeTheBagButWhoIsAtWork()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::StationAdded{"Station 2"}, StationId{1});
    const fact::BagSqueezed squeezed{{perMinute(12.0), millilitres(300.0)}};
    const auto squeezes = [&](ParticipantId author, StationId station = kSampleStation) {
        return verdict(judgeBy(SessionAuthority{writer.log()}, author, squeezed, station));
    };
    QCOMPARE(squeezes(kSampleTrainee), QByteArray{"fine"});
    QCOMPARE(squeezes(kSampleTrainee, StationId{1}), QByteArray{"not permitted"});
    QCOMPARE(squeezes(kSampleTrainee, kAllStations), QByteArray{"not permitted"});
    QCOMPARE(squeezes(kSampleOtherTrainee), QByteArray{"not permitted"});
    writer.add(kNow, fact::WorkTaken{kSampleOtherTrainee, kSampleTrainee});
    QCOMPARE(squeezes(kSampleTrainee), QByteArray{"not permitted"});
    QCOMPARE(squeezes(kSampleOtherTrainee), QByteArray{"fine"});
    writer.add(kNow, fact::WorkTaken{kSampleInstructor, kSampleOtherTrainee});
    QCOMPARE(squeezes(kSampleOtherTrainee), QByteArray{"not permitted"});
    QCOMPARE(squeezes(kSampleInstructor), QByteArray{"fine"});
    writer.add(kNow, fact::WorkTaken{kSampleTrainee, kSampleInstructor});
    writer.add(kNow, fact::ParticipantMuted{kSampleTrainee, true});
    QCOMPARE(squeezes(kSampleTrainee), QByteArray{"muted"});
}

void TestSessionPermissions::refusesACheckpointOfWhatIsToCome()
{
    fact::BodyCheckpoint body = sampleBody();
    body.at = kNow;
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, body)), QByteArray{"fine"});
    body.at = kNow + Duration{1};
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, body)), QByteArray{"out of range"});
    fact::CapnographCheckpoint capnograph{kNow, {}};
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, capnograph)), QByteArray{"fine"});
    capnograph.at = kNow + Duration{1};
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, capnograph)),
             QByteArray{"out of range"});
    fact::RespirationCheckpoint checkpoint = sampleCheckpoint();
    checkpoint.at = kNow;
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, checkpoint)), QByteArray{"fine"});
    checkpoint.at = kNow + Duration{1};
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, checkpoint)),
             QByteArray{"out of range"});
}

CARINA_TEST(TestSessionPermissions)

} // namespace carina::test::session_permissions_test

#include "tst_session_permissions.moc"
