#include "engine/anatomy/organ_group.h"
#include "engine/session/participant_limits.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

#include <QTest>

namespace carina::test::lifted_objects_test
{
namespace
{

constexpr ObjectId kLungs{10};
constexpr ObjectId kSecondTube{11};
constexpr StationId kOther{1};

fact::ObjectShared group(ObjectId object, const char* name)
{
    return {object, kNobody, ObjectKind::OrganGroup, name};
}

/// The sample session with lungs and a second tube to lift out, and another station.
LogWriter session()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, group(kLungs, "lungs"));
    writer.add(kNow, fact::ObjectShared{kSecondTube, kNobody, ObjectKind::SpareTube, "tube"});
    writer.add(kNow, fact::StationAdded{"Station 2"}, kOther);
    return writer;
}

SharedObject lungs(const LogWriter& writer) { return stateOf(writer).objects().at(kLungs); }

/// The lungs pass to somebody, or back, as the session is now.
fact::ObjectHandedOver pass(const LogWriter& writer, ParticipantId owner)
{
    return {kLungs, owner, lungs(writer).epoch};
}

QByteArray judged(const LogWriter& writer, ParticipantId author, const FactBody& body,
                  StationId station = kSampleStation)
{
    return verdict(judgeBy(SessionAuthority{writer.log()}, author, body, station));
}

} // namespace

class TestLiftedObjects : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void belongToNobodyUntilSomebodyLiftsThem();
    void onlyTheHostSaysWhatCanBeLifted();
    void haveNoOwnerToBeginWith();
    void areOthersAtEachStation();
    void areSharedOnceWhoeverHasThem();
    void areLimitedForAStation();
    void aTraineeLiftsForThemselvesWhatNobodyHolds();
    void ofTwoWhoLiftAtOnceTheFirstHasIt();
    void aTraineePutsBackOrHandsOverWhatTheyHold();
    void aTraineeHoldsAtMostFourGroups();
    void doNotCountAmongThoseThatATraineeShares();
    void areWantedOnlyFromWhoHoldsThem();
    void onlyWhatCanBeLiftedIsNobodys();
    void becomeFreeWhenTheirHolderGoes_data();
    void becomeFreeWhenTheirHolderGoes();
    void stayWithAnInstructorWhoGoesToAnotherStation();
    void areNotLiftedByWhoIsAway();
    void knowTheLastEpochInTheirPlace();
};

void TestLiftedObjects::belongToNobodyUntilSomebodyLiftsThem()
{
    LogWriter writer = session();
    QVERIFY(lungs(writer).owner == kNobody);
    writer.add(kNow, pass(writer, kSampleTrainee));
    QVERIFY(lungs(writer).owner == kSampleTrainee);
    writer.add(kNow, pass(writer, kNobody));
    QVERIFY(lungs(writer).owner == kNobody);
    QCOMPARE(lungs(writer).epoch, std::uint16_t{3});
}

void TestLiftedObjects::onlyTheHostSaysWhatCanBeLifted()
{
    const LogWriter writer = sampleSession();
    const auto airway = group({}, "airway");
    QCOMPARE(judged(writer, kSampleHost, airway), QByteArray{"fine"});
    for (const ParticipantId other : {kSampleInstructor, kSampleTrainee, kSampleObserver})
        QCOMPARE(judged(writer, other, airway), QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleHost, group({}, "spleen")), QByteArray{"out of range"});
    for (const OrganGroup known : kOrganGroups)
        QCOMPARE(judged(writer, kSampleHost, group({}, groupName(known))), QByteArray{"fine"});
}

void TestLiftedObjects::haveNoOwnerToBeginWith()
{
    const LogWriter writer = sampleSession();
    fact::ObjectShared owned = group({}, "airway");
    owned.owner = kSampleTrainee;
    QCOMPARE(judged(writer, kSampleHost, owned), QByteArray{"out of range"});
    QCOMPARE(judged(writer, kSampleHost, fact::ObjectShared{{}, kNobody, ObjectKind::Tube, "t"}),
             QByteArray{"out of range"});
}

void TestLiftedObjects::areOthersAtEachStation()
{
    const LogWriter writer = session();
    const SessionAuthority authority{writer.log()};
    const auto here = judgeBy(authority, kSampleHost, group({}, "lungs"));
    const auto there = judgeBy(authority, kSampleHost, group({}, "lungs"), kOther);
    QVERIFY(std::get<fact::ObjectShared>(here->body).object == kLungs);
    QVERIFY(!stateOf(writer).objects().contains(std::get<fact::ObjectShared>(there->body).object));
    // So is the patient, which nobody carries from one to the other.
    LogWriter laid = writer;
    const fact::ObjectShared patient{{}, kSampleHost, ObjectKind::Patient, "Adult"};
    laid.add(kNow, fact::ObjectShared{ObjectId{12}, kSampleHost, ObjectKind::Patient, "Adult"});
    const auto second = judgeBy(SessionAuthority{laid.log()}, kSampleHost, patient, kOther);
    QVERIFY(std::get<fact::ObjectShared>(second->body).object == ObjectId{13});
}

void TestLiftedObjects::areSharedOnceWhoeverHasThem()
{
    LogWriter writer = session();
    writer.add(kNow, pass(writer, kSampleTrainee));
    const auto again = judgeBy(SessionAuthority{writer.log()}, kSampleHost, group({}, "lungs"));
    QVERIFY(std::get<fact::ObjectShared>(again->body).object == kLungs);
    writer.add(kNow, again->body);
    QVERIFY(lungs(writer).owner == kSampleTrainee);
}

void TestLiftedObjects::areLimitedForAStation()
{
    LogWriter writer = session();
    const auto tube = [](std::size_t number) {
        return fact::ObjectShared{ObjectId{std::uint16_t(20 + number)}, kNobody,
                                  ObjectKind::SpareTube, "tube " + std::to_string(number)};
    };
    for (std::size_t number = 2; number < kMostLiftables; ++number) {
        fact::ObjectShared next = tube(number);
        next.object = {};
        QCOMPARE(judged(writer, kSampleHost, next), QByteArray{"fine"});
        writer.add(kNow, tube(number));
    }
    const fact::ObjectShared last{{}, kNobody, ObjectKind::SpareTube, "one more"};
    QCOMPARE(judged(writer, kSampleHost, last), QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleHost, last, kOther), QByteArray{"fine"});
}

void TestLiftedObjects::aTraineeLiftsForThemselvesWhatNobodyHolds()
{
    LogWriter writer = session();
    QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kSampleTrainee)), QByteArray{"fine"});
    QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kSampleOtherTrainee)),
             QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleObserver, pass(writer, kSampleObserver)),
             QByteArray{"not permitted"});
    // At the station where they are.
    writer.add(kNow, fact::ParticipantMoved{kSampleTrainee}, kOther);
    for (const StationId station : {kSampleStation, kOther})
        QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kSampleTrainee), station),
                 QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleInstructor, pass(writer, kSampleOtherTrainee)),
             QByteArray{"fine"});
}

void TestLiftedObjects::ofTwoWhoLiftAtOnceTheFirstHasIt()
{
    LogWriter writer = session();
    const auto tess = pass(writer, kSampleOtherTrainee);
    const auto ina = pass(writer, kSampleInstructor);
    writer.add(kNow, pass(writer, kSampleTrainee));
    // The trainee may not take from another, the instructor may, but knows better first.
    QCOMPARE(judged(writer, kSampleOtherTrainee, tess), QByteArray{"owner changed"});
    QCOMPARE(judged(writer, kSampleInstructor, ina), QByteArray{"owner changed"});
    QCOMPARE(judged(writer, kSampleOtherTrainee, pass(writer, kSampleOtherTrainee)),
             QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleInstructor, pass(writer, kSampleInstructor)),
             QByteArray{"fine"});
}

void TestLiftedObjects::aTraineePutsBackOrHandsOverWhatTheyHold()
{
    LogWriter writer = session();
    QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kNobody)), QByteArray{"owner changed"});
    writer.add(kNow, pass(writer, kSampleTrainee));
    QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kNobody)), QByteArray{"fine"});
    // To an instructor, or to who asked.
    QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kSampleInstructor)), QByteArray{"fine"});
    QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kSampleOtherTrainee)),
             QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleOtherTrainee, pass(writer, kNobody)),
             QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleInstructor, pass(writer, kNobody)), QByteArray{"fine"});
}

void TestLiftedObjects::aTraineeHoldsAtMostFourGroups()
{
    LogWriter writer = session();
    std::uint16_t id = 20;
    for (const char* name : {"airway", "skeleton", "vessels", "muscles"}) {
        const ObjectId object{++id};
        writer.add(kNow, group(object, name));
        const fact::ObjectHandedOver lifted{object, kSampleTrainee, 1};
        QCOMPARE(judged(writer, kSampleTrainee, lifted), QByteArray{"fine"});
        writer.add(kNow, lifted);
    }
    QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kSampleTrainee)),
             QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleInstructor, pass(writer, kSampleTrainee)),
             QByteArray{"not permitted"});
    QCOMPARE(judged(writer, kSampleOtherTrainee, pass(writer, kSampleOtherTrainee)),
             QByteArray{"fine"});
    QCOMPARE(judged(writer, kSampleTrainee, fact::ObjectHandedOver{kSecondTube, kSampleTrainee, 1}),
             QByteArray{"fine"});
    writer.add(kNow, fact::ObjectHandedOver{ObjectId{id}, kNobody, 2});
    QCOMPARE(judged(writer, kSampleTrainee, pass(writer, kSampleTrainee)), QByteArray{"fine"});
}

void TestLiftedObjects::doNotCountAmongThoseThatATraineeShares()
{
    LogWriter writer = session();
    std::uint16_t id = 20;
    for (const char* name : {"airway", "skeleton", "vessels", "muscles"}) {
        writer.add(kNow, group(ObjectId{++id}, name));
        writer.add(kNow, fact::ObjectHandedOver{ObjectId{id}, kSampleTrainee, 1});
    }
    for (const ObjectKind kind :
         {ObjectKind::Head, ObjectKind::Hand, ObjectKind::Jaw, ObjectKind::Stylus}) {
        QCOMPARE(judged(writer, kSampleTrainee, fact::ObjectShared{{}, kSampleTrainee, kind, "x"}),
                 QByteArray{"fine"});
        writer.add(kNow, fact::ObjectShared{ObjectId{++id}, kSampleTrainee, kind, "x"});
    }
}

void TestLiftedObjects::areWantedOnlyFromWhoHoldsThem()
{
    LogWriter writer = session();
    const fact::ObjectWanted wish{kLungs};
    QCOMPARE(judged(writer, kSampleOtherTrainee, wish), QByteArray{"owner changed"});
    writer.add(kNow, pass(writer, kSampleTrainee));
    QCOMPARE(judged(writer, kSampleOtherTrainee, wish), QByteArray{"fine"});
    writer.add(kNow, wish, kSampleStation, kSampleOtherTrainee);
    QCOMPARE(lungs(writer).wantedBy, std::vector{kSampleOtherTrainee});
    writer.add(kNow, pass(writer, kNobody));
    QVERIFY(lungs(writer).wantedBy.empty());
}

void TestLiftedObjects::onlyWhatCanBeLiftedIsNobodys()
{
    const LogWriter writer = session();
    const fact::ObjectHandedOver dropped{kSampleTube, kNobody, 1};
    for (const ParticipantId author : {kSampleHost, kSampleInstructor, kSampleTrainee})
        QCOMPARE(judged(writer, author, dropped), QByteArray{"out of range"});
}

void TestLiftedObjects::becomeFreeWhenTheirHolderGoes_data()
{
    QTest::addColumn<int>("how");
    QTest::newRow("leaves") << 0;
    QTest::newRow("is removed") << 1;
    QTest::newRow("is moved") << 2;
    QTest::newRow("comes in elsewhere") << 3;
}

void TestLiftedObjects::becomeFreeWhenTheirHolderGoes()
{
    QFETCH(int, how);
    LogWriter writer = session();
    writer.add(kNow, pass(writer, kSampleTrainee));
    const fact::ParticipantJoined joined{kSampleTrainee, Role::Trainee, "Tom"};
    const std::array<FactBody, 4> bodies{
        fact::ParticipantLeft{kSampleTrainee},
        fact::ParticipantRemoved{kSampleTrainee, false, ""},
        fact::ParticipantMoved{kSampleTrainee},
        joined,
    };
    const FactBody& body = bodies.at(std::size_t(how));
    QVERIFY(mayChangeOwners(body));
    writer.add(kNow, body, kOther);
    QVERIFY(lungs(writer).owner == kNobody);
    QVERIFY(lungs(writer).station == kSampleStation);
    // The tube goes where its owner goes.
    QVERIFY(stateOf(writer).objects().at(kSampleTube).owner == kSampleTrainee);
}

void TestLiftedObjects::stayWithAnInstructorWhoGoesToAnotherStation()
{
    LogWriter writer = session();
    writer.add(kNow, pass(writer, kSampleInstructor));
    writer.add(kNow, fact::ParticipantMoved{kSampleInstructor}, kOther);
    QVERIFY(lungs(writer).owner == kSampleInstructor);
    writer.add(kNow, fact::ParticipantLeft{kSampleInstructor});
    QVERIFY(lungs(writer).owner == kNobody);
}

void TestLiftedObjects::areNotLiftedByWhoIsAway()
{
    LogWriter writer = session();
    writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
    QCOMPARE(judged(writer, kSampleInstructor, pass(writer, kSampleTrainee)),
             QByteArray{"out of range"});
}

void TestLiftedObjects::knowTheLastEpochInTheirPlace()
{
    LogWriter writer = session();
    QCOMPARE(lungs(writer).inPlace, std::optional<std::uint16_t>{1});
    writer.add(kNow, pass(writer, kSampleTrainee));
    writer.add(kNow, pass(writer, kSampleOtherTrainee));
    QCOMPARE(lungs(writer).inPlace, std::optional<std::uint16_t>{1});
    writer.add(kNow, pass(writer, kNobody));
    QCOMPARE(lungs(writer).inPlace, std::optional<std::uint16_t>{4});
    QVERIFY(!stateOf(writer).objects().at(kSampleTube).inPlace);
}

CARINA_TEST(TestLiftedObjects)

} // namespace carina::test::lifted_objects_test

#include "tst_lifted_objects.moc"
