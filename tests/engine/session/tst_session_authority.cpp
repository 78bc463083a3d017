#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

namespace carina::test::session_authority_test
{

/// Numbers, ids and effect times of what is permitted.
class TestSessionAuthority : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersAndDatesAFact();
    void takesEffectWhenTheSlowestHasIt_data();
    void takesEffectWhenTheSlowestHasIt();
    void neverLetsAnEarlierDecisionWin();
    void givesParticipantIds_data();
    void givesParticipantIds();
    void givesObjectIds_data();
    void givesObjectIds();
    void letsTheFirstOfTwoTakeOver();
    void handsOverOnlyWhatAndToWhomIsKnown();
    void runsOutOfIdsWithAnError();
    void settlesARepeatedProposal();
    void resumesFromItsLog();
    void changesNothingByJudging();
    void boundsABreathByThePatientOfTheStation();
};

/// The one that was decided last, even where it has not taken effect; a child of 40 kg before.
void TestSessionAuthority::boundsABreathByThePatientOfTheStation()
{
    const fact::TidalVolumeSet deep{millilitres(1500.0)};
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleInstructor, deep)),
             QByteArray{"out of range"});
    LogWriter writer = sampleSession();
    writer.add(kNow + std::chrono::seconds{1},
               fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    QCOMPARE(verdict(judgeBy(SessionAuthority{writer.log()}, kSampleInstructor, deep)),
             QByteArray{"fine"});
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleInstructor, deep, StationId{9})),
             QByteArray{"station unknown"});
}

void TestSessionAuthority::numbersAndDatesAFact()
{
    const Proposal proposal{ProposalId{99}, kSampleInstructor, kSampleStation,
                            fact::BreathingRateSet{perMinute(25.0)}};
    const Result<Fact> fact = sampleAuthority().judge(proposal, kNow, kNear);
    QVERIFY(fact
            == (Fact{FactNumber{8}, ProposalId{99}, kSampleInstructor, kSampleStation, kNow,
                     kNow + std::chrono::milliseconds{100}, proposal.body}));
}

void TestSessionAuthority::takesEffectWhenTheSlowestHasIt_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<int>("pathMs");
    QTest::addColumn<int>("leadMs");
    const FactBody rate = fact::BreathingRateSet{perMinute(25.0)};
    const auto row = [](const char* name, const FactBody& body, int pathMs, int leadMs) {
        QTest::newRow(name) << body << pathMs << leadMs;
    };
    row("nobody else", rate, 0, 100);
    row("just near", rate, 99, 100);
    row("just far", rate, 101, 101);
    row("far", rate, 400, 400);
    row("a clock fault", rate, -50, 100);
    row("tidal volume", fact::TidalVolumeSet{millilitres(300.0)}, 400, 400);
    row("fraction", fact::InspiratoryFractionSet{0.3}, 400, 400);
    row("anatomy", fact::AnatomyChosen{"aa", "A"}, 400, 400);
    row("phase", fact::PhaseChanged{SessionPhase::Running}, 400, 400);
    row("end of a try", fact::TryEnded{}, 400, 400);
    row("join", fact::ParticipantJoined{{}, Role::Observer, "New"}, 400, 0);
    row("leave", fact::ParticipantLeft{kSampleTrainee}, 400, 0);
    row("share", fact::ObjectShared{{}, kSampleTrainee, ObjectKind::Head, "head"}, 400, 0);
}

void TestSessionAuthority::takesEffectWhenTheSlowestHasIt()
{
    QFETCH(const FactBody, body);
    QFETCH(const int, pathMs);
    QFETCH(const int, leadMs);
    const Result<Fact> fact =
        sampleAuthority().judge({ProposalId{1}, kSampleHost, kSampleStation, body}, kNow,
                                std::chrono::milliseconds{pathMs});
    QVERIFY(fact->committed == kNow);
    QVERIFY(fact->effect == kNow + std::chrono::milliseconds{leadMs});
}

/// The slowest participant leaves between two changes: the second may not overtake the first.
void TestSessionAuthority::neverLetsAnEarlierDecisionWin()
{
    SessionAuthority authority = sampleAuthority();
    const auto propose = [&](double perMin, SessionTime now, Duration path) {
        const Result<Fact> fact =
            authority.judge({ProposalId{std::uint64_t(perMin)}, kSampleHost, kSampleStation,
                             fact::BreathingRateSet{perMinute(perMin)}},
                            now, path);
        authority.commit(*fact);
        return fact->effect;
    };
    const SessionTime first = propose(20.0, kNow, std::chrono::seconds{2});
    const SessionTime second = propose(30.0, kNow + std::chrono::seconds{1}, kNear);
    QVERIFY(first == kNow + std::chrono::seconds{2});
    QVERIFY(second == first);
    const auto& respiration = authority.state().stations().at(kSampleStation).respiration;
    QCOMPARE(respiration.settingsAt(first).pattern.rate, perMinute(30.0));
    // People are not held up by it.
    QVERIFY(judgeBy(authority, kNobody, fact::ParticipantJoined{{}, Role::Trainee, "New"})->effect
            == kNow);
}

void TestSessionAuthority::givesParticipantIds_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<int>("id"); // 0: refused
    const auto row = [](const char* name, int asked, Role role, const char* who, int id) {
        QTest::newRow(name) << FactBody{fact::ParticipantJoined{ParticipantId{std::uint16_t(asked)},
                                                                role, who}}
                            << id;
    };
    row("same name and role", 0, Role::Trainee, "Tom", 2);
    row("same name, other role", 0, Role::Observer, "Tom", 0);
    row("other name", 0, Role::Trainee, "Tim", 5);
    row("its own number", 2, Role::Trainee, "Tom", 2);
    row("the number of another", 4, Role::Trainee, "Tom", 0);
    row("its number in another role", 2, Role::Instructor, "Tom", 0);
    row("a number nobody has", 5, Role::Trainee, "Tim", 0);
}

void TestSessionAuthority::givesParticipantIds()
{
    QFETCH(const FactBody, body);
    QFETCH(const int, id);
    const Result<Fact> fact = judgeBy(sampleAuthority(), kSampleHost, body);
    QCOMPARE(fact ? int(std::get<fact::ParticipantJoined>(fact->body).participant.value) : 0, id);
    if (!fact)
        QVERIFY(fact.error().code == Errc::OutOfRange || fact.error().code == Errc::NameUnclear);
}

void TestSessionAuthority::givesObjectIds_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<int>("id");
    const auto row = [](const char* name, int asked, ParticipantId owner, ObjectKind kind,
                        const char* object, int id) {
        QTest::newRow(name) << FactBody{fact::ObjectShared{ObjectId{std::uint16_t(asked)}, owner,
                                                           kind, object}}
                            << id;
    };
    row("the same again", 0, kSampleTrainee, ObjectKind::Tube, "tube", 1);
    row("other owner", 0, kSampleOtherTrainee, ObjectKind::Tube, "tube", 2);
    row("other kind", 0, kSampleTrainee, ObjectKind::Stylus, "tube", 2);
    row("other name", 0, kSampleInstructor, ObjectKind::Tube, "tube 2", 2);
    row("somebody else's", 1, kSampleOtherTrainee, ObjectKind::Tube, "tube", 0);
    row("turned into something else", 1, kSampleTrainee, ObjectKind::Head, "tube", 0);
    row("renamed", 1, kSampleTrainee, ObjectKind::Tube, "other", 0);
    row("a number nothing has", 2, kSampleTrainee, ObjectKind::Tube, "tube", 0);
}

void TestSessionAuthority::givesObjectIds()
{
    QFETCH(const FactBody, body);
    QFETCH(const int, id);
    const Result<Fact> fact = judgeBy(sampleAuthority(), kSampleHost, body);
    QCOMPARE(fact ? int(std::get<fact::ObjectShared>(fact->body).object.value) : 0, id);
    if (!fact)
        QCOMPARE(fact.error().code, Errc::OutOfRange);
}

void TestSessionAuthority::letsTheFirstOfTwoTakeOver()
{
    // Both saw the first ownership; the second to be judged takes nothing.
    SessionAuthority authority = sampleAuthority();
    const auto take = [&](ParticipantId who, std::uint16_t epoch) {
        return judgeBy(authority, kSampleInstructor,
                       fact::ObjectHandedOver{kSampleTube, who, epoch});
    };
    QCOMPARE(verdict(take(kSampleInstructor, 2)), QByteArray{"owner changed"});
    const Result<Fact> first = take(kSampleInstructor, 1);
    QVERIFY(first);
    QVERIFY(first->effect == kNow);
    authority.commit(*first);
    QCOMPARE(verdict(take(kSampleOtherTrainee, 1)), QByteArray{"owner changed"});
    QVERIFY(authority.state().objects().at(kSampleTube).owner == kSampleInstructor);
    QCOMPARE(verdict(take(kSampleOtherTrainee, 2)), QByteArray{"fine"});
}

void TestSessionAuthority::handsOverOnlyWhatAndToWhomIsKnown()
{
    const auto hand = [&](ObjectId object, ParticipantId to) {
        return verdict(
            judgeBy(sampleAuthority(), kSampleInstructor, fact::ObjectHandedOver{object, to, 1}));
    };
    QCOMPARE(hand(ObjectId{2}, kSampleTrainee), QByteArray{"out of range"});
    QCOMPARE(hand(kSampleTube, ParticipantId{99}), QByteArray{"out of range"});
    QCOMPARE(hand(kSampleTube, kSampleObserver), QByteArray{"not permitted"});
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleTrainee, fact::ObjectWanted{ObjectId{2}})),
             QByteArray{"out of range"});
}

void TestSessionAuthority::runsOutOfIdsWithAnError()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::ParticipantJoined{ParticipantId{0xfffd}, Role::Trainee, "Last but one"});
    SessionAuthority authority{writer.log()};
    const Result<Fact> last =
        judgeBy(authority, kNobody, fact::ParticipantJoined{{}, Role::Trainee, "Last"});
    QVERIFY(std::get<fact::ParticipantJoined>(last->body).participant == ParticipantId{0xfffe});
    authority.commit(*last);
    QCOMPARE(verdict(judgeBy(authority, kNobody,
                             fact::ParticipantJoined{{}, Role::Trainee, "One too many"})),
             QByteArray{"out of range"});

    LogWriter fresh;
    fresh.add(kNow, fact::SessionCreated{"S", "1"});
    fresh.add(kNow, fact::StationAdded{"S"});
    const Result<Fact> first = judgeBy(SessionAuthority{fresh.log()}, kNobody,
                                       fact::ParticipantJoined{{}, Role::Trainee, "First"});
    QVERIFY(std::get<fact::ParticipantJoined>(first->body).participant == ParticipantId{1});
}

void TestSessionAuthority::settlesARepeatedProposal()
{
    SessionAuthority authority = sampleAuthority();
    QVERIFY(!authority.settled(ProposalId{5}));
    authority.commit(*judgeBy(authority, kSampleHost, fact::InspiratoryFractionSet{0.3}));
    QVERIFY(authority.settled(ProposalId{5}) == FactNumber{8});
    QVERIFY(!authority.settled(ProposalId{6}));
}

void TestSessionAuthority::resumesFromItsLog()
{
    LogWriter writer = sampleSession();
    writer.add(kNow + std::chrono::seconds{9}, fact::PhaseChanged{SessionPhase::Running});
    const SessionAuthority authority{writer.log()};
    QVERIFY(authority.settled(ProposalId{1003}) == FactNumber{3});
    const Result<Fact> fact =
        judgeBy(authority, kSampleHost, fact::BreathingRateSet{perMinute(20.0)});
    QCOMPARE(fact->number.value, std::uint64_t{9});
    QVERIFY(fact->effect == kNow + std::chrono::seconds{9});
}

void TestSessionAuthority::changesNothingByJudging()
{
    const SessionAuthority authority = sampleAuthority();
    QVERIFY(judgeBy(authority, kSampleHost, fact::StationAdded{"S"}, kNoStation).has_value());
    QCOMPARE(authority.state().lastApplied().value, std::uint64_t{7});
    QVERIFY(!authority.settled(ProposalId{5}));
}

CARINA_TEST(TestSessionAuthority)

} // namespace carina::test::session_authority_test

#include "tst_session_authority.moc"
