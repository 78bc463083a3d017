#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

namespace carina::test::conduct_test
{

/// Who mutes, removes and bans whom, and who comes in then.
class TestConduct : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyInstructorsDecide_data();
    void onlyInstructorsDecide();
    void onlyTheHostTellsOfATokenThatWasReplaced();
    void nobodyIsSilencedWhomTheSessionCannotDoWithout();
    void anotherInstructorMaySilenceAnInstructor();
    void whoIsMutedProposesNothing();
    void staysMutedWhenComingBack();
    void removedParticipantIsGoneAndMayComeBack();
    void bannedParticipantStaysOutUntilTheBanIsLifted();
    void lockedSessionAdmitsNobodyNew();
    void namesAParticipantWhoIsKnown();
    void isDecidedAfterTheEndToo();
    void tokenIsReplacedForOneStayOnly();
};

namespace
{

const fact::ParticipantRemoved kRemoval{kSampleTrainee, false, "too loud"};
const fact::ParticipantRemoved kBan{kSampleTrainee, true, "too loud"};
const fact::ParticipantJoined kTomAgain{{}, Role::Trainee, "Tom"};

QByteArray verdictAfter(const LogWriter& writer, ParticipantId author, FactBody body)
{
    return verdict(judgeBy(SessionAuthority{writer.log()}, author, std::move(body)));
}

} // namespace

void TestConduct::onlyInstructorsDecide_data()
{
    QTest::addColumn<FactBody>("body");
    const auto row = [](const char* name, const FactBody& body) { QTest::newRow(name) << body; };
    row("mute", fact::ParticipantMuted{kSampleOtherTrainee, true});
    row("unmute", fact::ParticipantMuted{kSampleOtherTrainee, false});
    row("remove", fact::ParticipantRemoved{kSampleOtherTrainee, false, {}});
    row("ban", fact::ParticipantRemoved{kSampleOtherTrainee, true, "why"});
    row("let back in", fact::BanLifted{kSampleOtherTrainee});
    row("lock", fact::SessionLocked{true});
    row("unlock", fact::SessionLocked{false});
    row("new code", fact::RoleCodeChanged{Role::Trainee});
}

void TestConduct::onlyInstructorsDecide()
{
    QFETCH(const FactBody, body);
    const SessionAuthority authority = sampleAuthority();
    QCOMPARE(verdict(judgeBy(authority, kSampleHost, body)), QByteArray{"fine"});
    QCOMPARE(verdict(judgeBy(authority, kSampleInstructor, body)), QByteArray{"fine"});
    for (const ParticipantId other : {kSampleTrainee, kSampleObserver, kNobody, ParticipantId{42}})
        QCOMPARE(verdict(judgeBy(authority, other, body)), QByteArray{"not permitted"});
    // A station that is not known makes no difference: it is about the session.
    QCOMPARE(verdict(judgeBy(authority, kSampleInstructor, body, StationId{9})),
             QByteArray{"fine"});
}

void TestConduct::onlyTheHostTellsOfATokenThatWasReplaced()
{
    const fact::TokenReplaced replaced{kSampleTrainee};
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, replaced)), QByteArray{"fine"});
    QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleInstructor, replaced)),
             QByteArray{"not permitted"});
}

void TestConduct::nobodyIsSilencedWhomTheSessionCannotDoWithout()
{
    LogWriter writer = sampleSession();
    for (const ParticipantId needed : {kSampleHost, kSampleInstructor}) {
        if (needed == kSampleHost)
            writer.add(kNow, fact::ParticipantJoined{kSampleHost, Role::Instructor, "Dr. Hall"});
        else
            writer.add(kNow, fact::ParticipantLeft{kSampleHost});
        for (const FactBody& body : {FactBody{fact::ParticipantMuted{needed, true}},
                                     FactBody{fact::ParticipantRemoved{needed, false, {}}},
                                     FactBody{fact::ParticipantRemoved{needed, true, {}}}})
            QCOMPARE(verdictAfter(writer, kSampleInstructor, body), QByteArray{"not permitted"});
        QCOMPARE(verdictAfter(writer, kSampleInstructor, fact::ParticipantMuted{needed, false}),
                 QByteArray{"fine"});
    }
}

void TestConduct::anotherInstructorMaySilenceAnInstructor()
{
    constexpr ParticipantId kSecond{9};
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::ParticipantJoined{kSecond, Role::Instructor, "Irma"});
    const fact::ParticipantRemoved removal{kSampleInstructor, false, {}};
    QCOMPARE(verdictAfter(writer, kSecond, removal), QByteArray{"fine"});
    writer.add(kNow, fact::ParticipantMuted{kSecond, true}); // instructs nobody now
    QCOMPARE(verdictAfter(writer, kSampleHost, removal), QByteArray{"not permitted"});
}

void TestConduct::whoIsMutedProposesNothing()
{
    LogWriter writer = sampleSession();
    const fact::ObjectShared own{{}, kSampleTrainee, ObjectKind::Stylus, "stylus"};
    QCOMPARE(verdictAfter(writer, kSampleTrainee, own), QByteArray{"fine"});
    writer.add(kNow, fact::ParticipantMuted{kSampleTrainee, true});
    QCOMPARE(verdictAfter(writer, kSampleTrainee, own), QByteArray{"muted"});
    QCOMPARE(verdictAfter(writer, kSampleTrainee, fact::ParticipantMuted{kSampleTrainee, false}),
             QByteArray{"muted"});
    // But what concerns safety.
    const fact::RegistrationStated notGood{
        {RegistrationState::NotGood, StaleReason::None, millimetres(4.0)}};
    QCOMPARE(verdictAfter(writer, kSampleTrainee, notGood), QByteArray{"fine"});
    writer.add(kNow, fact::ParticipantMuted{kSampleTrainee, false});
    QCOMPARE(verdictAfter(writer, kSampleTrainee, own), QByteArray{"fine"});
}

void TestConduct::staysMutedWhenComingBack()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::ParticipantMuted{kSampleTrainee, true});
    writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
    writer.add(kNow, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"});
    QVERIFY(stateOf(writer).participants().at(kSampleTrainee).muted);
    QVERIFY(!stateOf(writer).participants().at(kSampleOtherTrainee).muted);
}

void TestConduct::removedParticipantIsGoneAndMayComeBack()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::ObjectWanted{kSampleTube}, kSampleStation, kSampleOtherTrainee);
    const fact::ParticipantRemoved removal{kSampleOtherTrainee, false, "too loud"};
    const FactNumber at = writer.add(kNow, removal, kSampleStation, kSampleInstructor).number;
    const SessionState state = stateOf(writer);
    const Participant& tess = state.participants().at(kSampleOtherTrainee);
    QVERIFY(!tess.present);
    QVERIFY(state.objects().at(kSampleTube).wantedBy.empty());
    QVERIFY(tess.removal && !tess.removal->banned && tess.removal->at == at);
    QCOMPARE(removalText(state, *tess.removal), std::string{"Ina: too loud"});
    QCOMPARE(removalText(state, {kSampleInstructor, {}, false, at}), std::string{"Ina"});
    const fact::ParticipantJoined again{{}, Role::Trainee, "Tess"};
    QCOMPARE(verdictAfter(writer, kNobody, again), QByteArray{"fine"});
    writer.add(kNow, fact::ParticipantJoined{kSampleOtherTrainee, Role::Trainee, "Tess"});
    QVERIFY(!stateOf(writer).participants().at(kSampleOtherTrainee).removal);
}

void TestConduct::bannedParticipantStaysOutUntilTheBanIsLifted()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, kBan, kSampleStation, kSampleInstructor);
    const Result<Fact> refused = judgeBy(SessionAuthority{writer.log()}, kNobody, kTomAgain);
    QCOMPARE(verdict(refused), QByteArray{"banned"});
    QCOMPARE(refused.error().detail, std::string{"Ina: too loud"});
    // Nor in another role: that would be a name which looks like another's.
    QCOMPARE(verdictAfter(writer, kNobody, fact::ParticipantJoined{{}, Role::Observer, "tom"}),
             QByteArray{"name unclear"});
    writer.add(kNow, fact::BanLifted{kSampleTrainee});
    QCOMPARE(verdictAfter(writer, kNobody, kTomAgain), QByteArray{"fine"});
}

void TestConduct::lockedSessionAdmitsNobodyNew()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
    const fact::ParticipantJoined newcomer{{}, Role::Trainee, "New"};
    writer.add(kNow, fact::SessionLocked{true});
    QVERIFY(stateOf(writer).isLocked());
    QCOMPARE(verdictAfter(writer, kNobody, newcomer), QByteArray{"session locked"});
    QCOMPARE(verdictAfter(writer, kNobody, kTomAgain), QByteArray{"fine"});
    writer.add(kNow, fact::SessionLocked{false});
    QCOMPARE(verdictAfter(writer, kNobody, newcomer), QByteArray{"fine"});
}

void TestConduct::namesAParticipantWhoIsKnown()
{
    constexpr ParticipantId kUnknown{42};
    for (const FactBody& body :
         {FactBody{fact::ParticipantMuted{kUnknown}}, FactBody{fact::ParticipantRemoved{kUnknown}},
          FactBody{fact::BanLifted{kUnknown}}, FactBody{fact::TokenReplaced{kUnknown}}}) {
        QCOMPARE(verdict(judgeBy(sampleAuthority(), kSampleHost, body)),
                 QByteArray{"out of range"});
        LogWriter writer = sampleSession();
        writer.add(kNow, body);
        QCOMPARE(stateOf(writer).participants().size(), std::size_t{4});
    }
}

void TestConduct::isDecidedAfterTheEndToo()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(2.0), fact::PhaseChanged{SessionPhase::Ended});
    QCOMPARE(verdictAfter(writer, kSampleInstructor, kRemoval), QByteArray{"fine"});
    QCOMPARE(verdictAfter(writer, kSampleInstructor, fact::SessionLocked{}), QByteArray{"fine"});
}

void TestConduct::tokenIsReplacedForOneStayOnly()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, fact::TokenReplaced{kSampleTrainee});
    QVERIFY(stateOf(writer).participants().at(kSampleTrainee).tokenReplaced);
    writer.add(kNow, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"});
    QVERIFY(!stateOf(writer).participants().at(kSampleTrainee).tokenReplaced);
}

CARINA_TEST(TestConduct)

} // namespace carina::test::conduct_test

#include "tst_conduct.moc"
