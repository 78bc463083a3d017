#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

#include <QTest>

#include <functional>

namespace carina::test::people_test
{
namespace
{

ParticipantId atWork(const LogWriter& writer) { return stateOf(writer).atWork(kSampleStation); }

QByteArray judged(const LogWriter& writer, ParticipantId author, const FactBody& body)
{
    return verdict(judgeBy(SessionAuthority{writer.log()}, author, body));
}

fact::ObjectShared tubeOf(ObjectId object, ParticipantId owner)
{
    return {object, owner, ObjectKind::Tube, "tube"};
}

} // namespace

class TestPeople : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The sample session's trainee has a tube from the start.
    void firstTraineeWithATubeIsAtWork()
    {
        QVERIFY(stateOf(sampleSession()).atWork(StationId{1}) == kNobody);
        LogWriter writer = sampleSession();
        QVERIFY(atWork(writer) == kSampleTrainee);
        writer.add(kNow, tubeOf(ObjectId{2}, kSampleOtherTrainee));
        QVERIFY(atWork(writer) == kSampleTrainee);
    }

    void onlyATraineesTubeBringsTheWork()
    {
        LogWriter writer = sampleSession();
        writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
        writer.add(kNow,
                   fact::ObjectShared{ObjectId{2}, kSampleOtherTrainee, ObjectKind::Head, ""});
        writer.add(kNow, tubeOf(ObjectId{3}, kSampleInstructor));
        QVERIFY(atWork(writer) == kNobody);
        writer.add(kNow, tubeOf(ObjectId{4}, kSampleOtherTrainee));
        QVERIFY(atWork(writer) == kSampleOtherTrainee);
    }

    void nobodyIsAtWorkOnceWhoWasHasGone()
    {
        LogWriter writer = sampleSession(); // the other trainee has no tube
        writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
        QVERIFY(atWork(writer) == kNobody);
        LogWriter removed = sampleSession();
        removed.add(kNow, fact::ParticipantRemoved{kSampleTrainee, false, ""});
        QVERIFY(atWork(removed) == kNobody);
    }

    void workOfWhoGoesPassesToTheNextWithATube_data()
    {
        using Log = std::function<void(LogWriter&)>;
        QTest::addColumn<Log>("goes");
        QTest::newRow("leaves") << Log{
            [](LogWriter& writer) { writer.add(kNow, fact::ParticipantLeft{kSampleTrainee}); }};
        QTest::newRow("falls silent") << Log{[](LogWriter& writer) {
            writer.add(kNow, fact::ParticipantFellSilent{kSampleTrainee});
        }};
        QTest::newRow("is removed") << Log{[](LogWriter& writer) {
            writer.add(kNow, fact::ParticipantRemoved{kSampleTrainee, false, ""});
        }};
        QTest::newRow("is moved") << Log{[](LogWriter& writer) {
            writer.add(kNow, fact::ParticipantMoved{kSampleTrainee}, StationId{1});
        }};
        QTest::newRow("comes in elsewhere") << Log{[](LogWriter& writer) {
            writer.add(kNow, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"},
                       StationId{1});
        }};
    }

    /// The trainee's 7 has one too, and comes after the sample's other trainee.
    void workOfWhoGoesPassesToTheNextWithATube()
    {
        QFETCH(std::function<void(LogWriter&)>, goes);
        LogWriter writer = sampleSession();
        writer.add(kNow, fact::StationAdded{"Station 2"}, StationId{1});
        writer.add(kNow, fact::ParticipantJoined{ParticipantId{7}, Role::Trainee, "Tim"});
        writer.add(kNow, tubeOf(ObjectId{7}, ParticipantId{7}));
        writer.add(kNow, tubeOf(ObjectId{8}, kSampleOtherTrainee));
        writer.add(kNow, tubeOf(ObjectId{9}, kSampleInstructor));
        goes(writer);
        QVERIFY(atWork(writer) == kSampleOtherTrainee);
        // Whoever comes back finds that others went on.
        writer.add(kNow, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"});
        QVERIFY(atWork(writer) == kSampleOtherTrainee);
        writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
        QVERIFY(atWork(writer) == kSampleOtherTrainee);
    }

    void whoComesBackGoesOnUnlessAnotherHasTakenTheWork()
    {
        const fact::ParticipantJoined back{kSampleTrainee, Role::Trainee, "Tom"};
        LogWriter writer = sampleSession();
        writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
        LogWriter taken = writer;
        writer.add(kNow, back);
        QVERIFY(atWork(writer) == kSampleTrainee);
        taken.add(kNow, fact::WorkTaken{kSampleOtherTrainee, kNobody});
        taken.add(kNow, back);
        QVERIFY(atWork(taken) == kSampleOtherTrainee);
    }

    /// Also if they were not the last to be at work.
    void whoComesBackWithATubeTakesUpWhatNobodyDoes()
    {
        LogWriter writer = sampleSession();
        writer.add(kNow, tubeOf(ObjectId{2}, kSampleOtherTrainee));
        writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
        writer.add(kNow, fact::ParticipantLeft{kSampleOtherTrainee});
        writer.add(kNow, fact::ParticipantJoined{kSampleOtherTrainee, Role::Trainee, "Tess"});
        QVERIFY(atWork(writer) == kSampleOtherTrainee);
    }

    void aTraineeTakesOnlyWhatNobodyDoes()
    {
        LogWriter writer = sampleSession();
        const fact::WorkTaken tess{kSampleOtherTrainee, kSampleTrainee};
        QCOMPARE(judged(writer, kSampleOtherTrainee, tess), QByteArray{"not permitted"});
        writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
        QCOMPARE(judged(writer, kSampleOtherTrainee, fact::WorkTaken{kSampleOtherTrainee, kNobody}),
                 QByteArray{"fine"});
        // For themselves, not for another.
        QCOMPARE(judged(writer, kSampleOtherTrainee, fact::WorkTaken{kSampleInstructor, kNobody}),
                 QByteArray{"not permitted"});
    }

    void handsOverOnlyWhatIsStillTheirs()
    {
        LogWriter writer = sampleSession();
        const fact::WorkTaken given{kSampleOtherTrainee, kSampleTrainee};
        QCOMPARE(judged(writer, kSampleTrainee, given), QByteArray{"fine"});
        writer.add(kNow, given);
        QVERIFY(atWork(writer) == kSampleOtherTrainee);
        // Of two instructors who give it away at once the first is right.
        QCOMPARE(
            judged(writer, kSampleInstructor, fact::WorkTaken{kSampleInstructor, kSampleTrainee}),
            QByteArray{"owner changed"});
        QCOMPARE(
            judged(writer, kSampleTrainee, fact::WorkTaken{kSampleTrainee, kSampleOtherTrainee}),
            QByteArray{"not permitted"});
    }

    void workIsOnlyForWhoIsThere()
    {
        LogWriter writer = sampleSession();
        writer.add(kNow, fact::StationAdded{"Station 2"}, StationId{1});
        writer.add(kNow, fact::ParticipantJoined{ParticipantId{7}, Role::Trainee, "Far"},
                   StationId{1});
        const auto given = [&](ParticipantId to) {
            return judged(writer, kSampleInstructor, fact::WorkTaken{to, kSampleTrainee});
        };
        QCOMPARE(given(ParticipantId{7}), QByteArray{"out of range"});
        QCOMPARE(given(ParticipantId{99}), QByteArray{"out of range"});
        QCOMPARE(given(kSampleObserver), QByteArray{"not permitted"});
        QCOMPARE(given(kSampleOtherTrainee), QByteArray{"fine"});
        // Who works at one station gives away nothing at another.
        QCOMPARE(verdict(judgeBy(SessionAuthority{writer.log()}, kSampleTrainee,
                                 fact::WorkTaken{ParticipantId{7}, kNobody}, StationId{1})),
                 QByteArray{"not permitted"});
        writer.add(kNow, fact::ParticipantLeft{kSampleOtherTrainee});
        QCOMPARE(given(kSampleOtherTrainee), QByteArray{"out of range"});
    }

    void mutedOnesPassNothingOn()
    {
        LogWriter writer = sampleSession();
        writer.add(kNow, fact::ParticipantMuted{kSampleTrainee, true});
        QCOMPARE(
            judged(writer, kSampleTrainee, fact::WorkTaken{kSampleOtherTrainee, kSampleTrainee}),
            QByteArray{"muted"});
    }

    void aPlaceHoldsUntilItIsChanged()
    {
        LogWriter writer = sampleSession();
        const auto turn = [&] { return stateOf(writer).participants().at(kSampleTrainee).turn; };
        QCOMPARE(inDegrees(turn()), 0.0);
        writer.add(kNow, fact::PlaceChosen{kSampleTrainee, degrees(90.0)});
        writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
        writer.add(kNow, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"});
        QCOMPARE(inDegrees(turn()), 90.0);
        writer.add(kNow, fact::PlaceChosen{kSampleTrainee, {}});
        QCOMPARE(inDegrees(turn()), 0.0);
        writer.add(kNow, fact::PlaceChosen{ParticipantId{99}, degrees(90.0)}); // changes nothing
        QCOMPARE(judged(writer, kSampleInstructor, fact::PlaceChosen{ParticipantId{99}, {}}),
                 QByteArray{"out of range"});
    }
};

CARINA_TEST(TestPeople)

} // namespace carina::test::people_test

#include "tst_people.moc"
