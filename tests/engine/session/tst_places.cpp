#include "engine/session/name_index.h"
#include "engine/session/participant_limits.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

namespace carina::test::places_test
{
namespace
{

using namespace std::chrono_literals;

constexpr ParticipantId kFirstOfCrowd{100};

ParticipantId ofCrowd(std::size_t number)
{
    return ParticipantId{static_cast<std::uint16_t>(kFirstOfCrowd.value + number)};
}

/// A session that Tess, who came in at its beginning, leaves at a time; who is of the crowd comes
/// in then, until all places of trainees are taken but hers.
LogWriter withCrowd(SessionTime tessLeaves)
{
    LogWriter writer = sampleSession();
    writer.add(tessLeaves, fact::ParticipantLeft{kSampleOtherTrainee});
    for (std::size_t i = 2; i < mostPresentOf(Role::Trainee); ++i)
        writer.add(tessLeaves, fact::ParticipantJoined{ofCrowd(i), Role::Trainee,
                                                       "crowd " + std::to_string(i)});
    return writer;
}

QByteArray joining(const LogWriter& log, const char* name, SessionTime now)
{
    const Proposal join{ProposalId{5}, kNobody, kNoStation,
                        fact::ParticipantJoined{{}, Role::Trainee, name}};
    return verdict(SessionAuthority{log.log()}.judge(join, now, kNear));
}

} // namespace

/// Who gets one of the places of a role.
class TestPlaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// One code under 223 names kept out whoever was away for three seconds.
    void whoWasAwayFindsTheirPlace()
    {
        const SessionTime left = atSeconds(600.0);
        const LogWriter log = withCrowd(left);
        QCOMPARE(joining(log, "Zoe", left + 3s), QByteArray{"session full"});
        QCOMPARE(joining(log, "Tess", left + 3s), QByteArray{"fine"});
        QCOMPARE(joining(log, "Tess", left + kPlaceKept - 1ns), QByteArray{"fine"});
        // From then on the place is anybody's.
        QCOMPARE(joining(log, "Zoe", left + kPlaceKept), QByteArray{"fine"});
    }

    /// Names that come and go in turn would take up all places.
    void placeIsKeptForAsLongAsSomebodyWasThere()
    {
        const SessionTime left = atSeconds(5.0);
        const LogWriter log = withCrowd(left);
        QCOMPARE(joining(log, "Zoe", left + 5s - 1ns), QByteArray{"session full"});
        QCOMPARE(joining(log, "Zoe", left + 5s), QByteArray{"fine"});
    }

    void placeOfWhoWasRemovedIsFree()
    {
        const SessionTime left = atSeconds(600.0);
        LogWriter log = withCrowd(left);
        log.add(left, fact::ParticipantRemoved{kSampleOtherTrainee, false, {}}, kSampleStation,
                kSampleInstructor);
        QCOMPARE(joining(log, "Zoe", left + 1s), QByteArray{"fine"});
    }

    void nobodyComesBackToAPlaceThatIsTaken()
    {
        const SessionTime left = atSeconds(600.0);
        LogWriter log = withCrowd(left);
        const SessionTime later = left + kPlaceKept;
        log.add(later, fact::ParticipantJoined{ofCrowd(1), Role::Trainee, "crowd 1"});
        QCOMPARE(joining(log, "Tess", later), QByteArray{"session full"});
    }

    void oneAddressHasNotAllPlacesAndNames()
    {
        for (const Role role : {Role::Instructor, Role::Trainee, Role::Observer}) {
            QVERIFY(mostPresentFrom(role) > 0 && mostPresentFrom(role) < mostPresentOf(role));
            QVERIFY(mostNamesFrom(role) > 0 && mostNamesFrom(role) < mostNamesOf(role));
        }
    }

    void namesAreFoundByTheirLooks()
    {
        NameIndex names;
        QVERIFY(!names.alike("Anna"));
        names.add("Anna");
        names.add("Instructor");
        for (const char* other : {"Anna", "ANNA", "An na", "\u0410nna", "Anna\u2800"})
            QVERIFY2(names.alike(other) && *names.alike(other) == "Anna", other);
        QVERIFY(names.alike("lnstructor"));
        QVERIFY(!names.alike("Anne"));
    }
};

CARINA_TEST(TestPlaces)

} // namespace carina::test::places_test

#include "tst_places.moc"
