#include "models/objects/liftables.h"
#include "models/objects/object_action_model.h"
#include "models/objects/object_words.h"
#include "models/patient/shared_patient.h"
#include "models/station/stations_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <map>
#include <set>

namespace carina::lifting_test
{

using test::FakeSessionNode;

/// What can be lifted out of the patient, as a person at a program lifts and moves it.
class TestLifting : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sharesEachGroupAndATubeOnceAtEachStation();
    void sharesWhatASessionFromBeforeLacks();
    void offersTheGroupsThatThePatientHas();
    void saysWhoHasIt();
    void movesOnlyWhatIsLiftedOut();
    void putsItBackWithItsMotion();
    void offersWhatTheHostPermits_data();
    void offersWhatTheHostPermits();
    void saysThatATraineesHandsAreFull();
    void twoMoveTheirOwnAtOnce();
    void undoesOneStepAfterTheOther();
    void undoesWhatItPutBackOnceItIsLiftedAgain();
    void forgetsItsStepsWhenAnotherHadIt();
    void theHistoryTakesBackStepsOfAllObjects();
    void theHistoryLiftsOutAgainWhatWasPutBack();
    void theHistoryForgetsWhatAnotherHad();
    void theHistoryTakesBackWhatIsOfAnotherStation();
    void theHistoryForgetsWhatIsOfAStationThatWasClosed();
    void aTraineePutsBackWhatIsTheirs();
    void anInstructorPutsBackEverythingAndThePatient();
    void takesNothingOverThatAnotherTookMeanwhile();
    void namesWhatIsLiftedOut();
};

namespace
{

using std::chrono::seconds;

constexpr StationId kStation = FakeSessionNode::kStation;
constexpr StationId kRoom{1};
constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
constexpr ParticipantId kIna = FakeSessionNode::kInstructor;
constexpr ParticipantId kHost = FakeSessionNode::kHost;
constexpr ObjectId kPatient = FakeSessionNode::kPatient;
constexpr ObjectId kAirway{3}; ///< the groups are in their order
constexpr ObjectId kLungs{4};
constexpr ObjectId kSecondTube{9};
constexpr double kSmall = 1e-6; ///< of rates, which travel as 32-bit numbers: metres, radians, 1

/// A program at a station where everything that can be lifted out is in its place.
struct Seat {
    FakeSessionNode node;
    SessionModel session{node};
    SharedObjectModel object{session, kStation};
    ObjectActionModel model{object};

    explicit Seat(ParticipantId self, ParticipantId patientOwner = kIna) : node{kHost}
    {
        node.sharePatient(patientOwner);
        shareLiftables(node, kStation);
        node.becomes(self);
    }
    [[nodiscard]] ParticipantId ownerOf(ObjectId id) const
    {
        return node.state()->objects().at(id).owner;
    }
    /// Another gets an object, or it is put back.
    void pass(ObjectId id, ParticipantId to)
    {
        node.decide(fact::ObjectHandedOver{id, to, node.state()->objects().at(id).epoch});
    }
    void lift(ObjectId id)
    {
        object.choose(id);
        object.lift();
    }
    /// Moves what is chosen along x by 0.1 m.
    void move()
    {
        model.setKind(ActionKind::Translation);
        model.setAxis(ObjectActionModel::Axis::X);
        model.setSpeed(100.0);
        model.start();
        node.advance(seconds{1});
        model.stop();
    }
    /// Of an object, from its place.
    [[nodiscard]] double x(ObjectId id) const
    {
        const auto shown = node.shown(id, *node.now());
        return shown ? shown->acted.X_AO.translation().x() : 0.0;
    }
    [[nodiscard]] bool isAt(ObjectId id, double expected) const
    {
        return std::abs(x(id) - expected) < kSmall;
    }
};

} // namespace

void TestLifting::sharesEachGroupAndATubeOnceAtEachStation()
{
    FakeSessionNode node{kHost};
    node.addStation("Station 2");
    for (const StationId station : {kStation, StationId{1}, kStation})
        shareLiftables(node, station);
    std::map<StationId, std::multiset<std::string>> names;
    const auto state = node.state();
    for (const auto& [id, object] : state->objects())
        if (isLiftable(object.kind)) {
            QVERIFY(object.owner == kNobody);
            names[object.station].insert(object.name);
        }
    const std::multiset<std::string> all{"airway",  "lungs", "skeleton",   "vessels",
                                         "muscles", "other", "second tube"};
    QVERIFY(
        (names
         == std::map<StationId, std::multiset<std::string>>{{kStation, all}, {StationId{1}, all}}));
}

/// As when a stored session is continued, in which somebody has the lungs.
void TestLifting::sharesWhatASessionFromBeforeLacks()
{
    FakeSessionNode node{kHost};
    node.decide(fact::ObjectShared{{}, kNobody, ObjectKind::OrganGroup, "lungs"});
    const ObjectId lungs = node.state()->objects().rbegin()->first;
    node.decide(fact::ObjectHandedOver{lungs, kTom, 1});
    const std::size_t before = node.state()->objects().size();
    shareLiftables(node, kStation);
    QCOMPARE(node.state()->objects().size(), before + 6);
    QVERIFY(node.state()->objects().at(lungs).owner == kTom);
}

void TestLifting::offersTheGroupsThatThePatientHas()
{
    Seat seat{kTom};
    const auto names = [&seat] {
        QStringList all;
        for (const auto& object : seat.object.objects())
            all << object.name;
        return all;
    };
    QCOMPARE(names().join(QStringLiteral(", ")),
             QStringLiteral("Adult, Airway, Lungs, Skeleton, Heart and vessels, Muscles, Other "
                            "organs, Second tube"));
    seat.object.setGroups({OrganGroup::Lungs});
    QCOMPARE(names().join(QStringLiteral(", ")), QStringLiteral("Adult, Lungs, Second tube"));
}

void TestLifting::saysWhoHasIt()
{
    Seat seat{kTom};
    QVERIFY(!seat.object.isLiftable()); // the patient
    seat.object.choose(kLungs);
    QVERIFY(seat.object.isLiftable());
    QCOMPARE(seat.object.ownerText(), QStringLiteral("○ nobody: in its place"));
    seat.object.lift();
    QCOMPARE(seat.object.ownerText(), QStringLiteral("● you"));
    seat.node.hostGoesAway();
    seat.model.putBack();
    QCOMPARE(seat.object.ownerText(), QStringLiteral("● you → back to its place"));
    QVERIFY(!seat.object.canPutBack()); // once is enough
}

void TestLifting::movesOnlyWhatIsLiftedOut()
{
    Seat seat{kTom};
    seat.object.choose(kLungs);
    QVERIFY(!seat.model.canStart());
    seat.model.start();
    QVERIFY(!seat.node.shown(kLungs, *seat.node.now()));
    seat.object.lift();
    QVERIFY(seat.model.canStart());
    seat.move();
    QVERIFY(seat.isAt(kLungs, 0.1));
    QVERIFY(seat.isAt(kPatient, 0.0));
}

void TestLifting::putsItBackWithItsMotion()
{
    Seat seat{kTom};
    seat.lift(kLungs);
    seat.move();
    seat.model.putBack();
    QVERIFY(seat.ownerOf(kLungs) == kNobody);
    QVERIFY(!seat.node.shown(kLungs, *seat.node.now()));
    QCOMPARE(seat.model.placeText(), QStringLiteral("In its original place"));
    seat.object.lift();
    seat.move();
    QVERIFY(seat.isAt(kLungs, 0.1)); // from its place again
}

void TestLifting::offersWhatTheHostPermits_data()
{
    QTest::addColumn<int>("self");
    QTest::addColumn<int>("owner");
    QTest::addColumn<QByteArray>("offered");
    const auto row = [](const char* name, ParticipantId self, ParticipantId owner,
                        const char* offered) {
        QTest::newRow(name) << int(self.value) << int(owner.value) << QByteArray{offered};
    };
    row("a trainee, what is free", kTom, kNobody, "lift");
    row("a trainee, what is theirs", kTom, kTom, "back give");
    row("a trainee, what is another's", kTom, kIna, "ask");
    row("an instructor, what is free", kIna, kNobody, "lift");
    row("an instructor, what is a trainee's", kIna, kTom, "back take ask");
    row("an observer, what is free", FakeSessionNode::kObserver, kNobody, "");
    row("an observer, what is a trainee's", FakeSessionNode::kObserver, kTom, "");
}

void TestLifting::offersWhatTheHostPermits()
{
    QFETCH(int, self);
    QFETCH(int, owner);
    QFETCH(QByteArray, offered);
    Seat seat{ParticipantId{std::uint16_t(self)}};
    if (ParticipantId{std::uint16_t(owner)} != kNobody)
        seat.pass(kLungs, ParticipantId{std::uint16_t(owner)});
    seat.object.choose(kLungs);
    QByteArrayList all;
    if (seat.object.canLift())
        all << "lift";
    if (seat.object.canPutBack())
        all << "back";
    if (seat.object.canTakeOver())
        all << "take";
    if (seat.object.canAsk())
        all << "ask";
    if (!seat.object.heirs().empty() && seat.object.isOwn())
        all << "give";
    QCOMPARE(all.join(' '), offered);
}

void TestLifting::saysThatATraineesHandsAreFull()
{
    Seat seat{kTom};
    for (std::uint16_t id = kAirway.value; id < kAirway.value + 4; ++id)
        seat.lift(ObjectId{id});
    seat.object.choose(ObjectId{7});
    QVERIFY(!seat.object.canLift());
    QCOMPARE(seat.object.wishText(), QStringLiteral("You hold 4 groups of organs, as many as you "
                                                    "may. Put one back first."));
    seat.object.choose(kSecondTube);
    QVERIFY(seat.object.canLift() && seat.object.wishText().isEmpty());
    seat.object.choose(kAirway);
    seat.model.putBack();
    seat.lift(ObjectId{7});
    QVERIFY(seat.ownerOf(ObjectId{7}) == kTom);
}

void TestLifting::twoMoveTheirOwnAtOnce()
{
    Seat seat{kTom};
    seat.pass(kAirway, kIna);
    seat.lift(kLungs);
    seat.node.ownerActs(kAirway, {ActionKind::Translation, Vec3::UnitX(), -0.2});
    seat.move();
    QVERIFY(seat.isAt(kAirway, -0.2));
    QVERIFY(seat.isAt(kLungs, 0.1));
}

void TestLifting::undoesOneStepAfterTheOther()
{
    Seat seat{kTom};
    seat.lift(kLungs);
    QVERIFY(!seat.model.canUndo());
    seat.move();
    seat.model.setSpeed(50.0);
    seat.model.start();
    seat.node.advance(seconds{2});
    QVERIFY(seat.isAt(kLungs, 0.2));
    seat.model.undo(); // in the middle of it
    seat.node.advance(seconds{1});
    QVERIFY(seat.isAt(kLungs, 0.1));
    seat.model.reset();
    QVERIFY(seat.isAt(kLungs, 0.0));
    seat.model.undo();
    QVERIFY(seat.isAt(kLungs, 0.1));
    seat.model.undo();
    QVERIFY(seat.isAt(kLungs, 0.0));
    QVERIFY(!seat.model.canUndo());
    seat.model.undo();
    QVERIFY(!seat.node.refusal());
}

void TestLifting::undoesWhatItPutBackOnceItIsLiftedAgain()
{
    Seat seat{kTom};
    seat.lift(kLungs);
    seat.move();
    seat.model.putBack();
    QVERIFY(!seat.model.canUndo()); // it is nobody's
    seat.object.lift();
    seat.model.undo();
    QVERIFY(seat.isAt(kLungs, 0.1));
}

void TestLifting::forgetsItsStepsWhenAnotherHadIt()
{
    Seat seat{kTom};
    seat.lift(kLungs);
    seat.move();
    seat.pass(kLungs, kIna);
    QCoreApplication::sendPostedEvents();
    seat.pass(kLungs, kTom);
    QCoreApplication::sendPostedEvents();
    QVERIFY(seat.object.isOwn() && !seat.model.canUndo());
}

void TestLifting::theHistoryTakesBackStepsOfAllObjects()
{
    Seat seat{kIna};
    ChangeHistory history;
    seat.model.setHistory(history);
    seat.lift(kLungs);
    seat.move();
    seat.lift(kAirway);
    seat.move();
    seat.object.choose(kLungs);
    seat.move();
    QCOMPARE(history.texts(), (QStringList{QStringLiteral("Lungs: moved along x"),
                                           QStringLiteral("Airway: moved along x"),
                                           QStringLiteral("Airway → lifted out"),
                                           QStringLiteral("Lungs: moved along x"),
                                           QStringLiteral("Lungs → lifted out")}));
    history.undo();
    QVERIFY(seat.isAt(kLungs, 0.1) && seat.isAt(kAirway, 0.1));
    history.undo(); // not the one that is chosen
    QVERIFY(seat.isAt(kLungs, 0.1) && seat.isAt(kAirway, 0.0));
    history.undo();
    QVERIFY(seat.ownerOf(kAirway) == kNobody);
    history.undo();
    QVERIFY(seat.isAt(kLungs, 0.0));
    history.undo();
    QVERIFY(seat.ownerOf(kLungs) == kNobody);
    QVERIFY(history.isEmpty());
}

void TestLifting::theHistoryLiftsOutAgainWhatWasPutBack()
{
    Seat seat{kIna};
    ChangeHistory history;
    seat.model.setHistory(history);
    seat.lift(kLungs);
    seat.move();
    seat.model.putBack();
    QCoreApplication::sendPostedEvents();
    QVERIFY(seat.ownerOf(kLungs) == kNobody);
    QCOMPARE(history.texts().front(), QStringLiteral("Lungs → put back"));
    history.undo();
    QCoreApplication::sendPostedEvents();
    QVERIFY(seat.ownerOf(kLungs) == kIna);
    QVERIFY(seat.isAt(kLungs, 0.1));
    history.undo();
    QVERIFY(seat.isAt(kLungs, 0.0));
}

void TestLifting::theHistoryForgetsWhatAnotherHad()
{
    Seat seat{kIna};
    ChangeHistory history;
    seat.model.setHistory(history);
    seat.lift(kAirway);
    seat.move();
    seat.lift(kLungs);
    seat.move();
    seat.pass(kLungs, kTom);
    QCoreApplication::sendPostedEvents();
    QCOMPARE(history.texts(), (QStringList{QStringLiteral("Lungs → lifted out"), // says why not
                                           QStringLiteral("Airway: moved along x"),
                                           QStringLiteral("Airway → lifted out")}));
}

void TestLifting::theHistoryTakesBackWhatIsOfAnotherStation()
{
    Seat seat{kIna};
    seat.node.addStation("Room 5");
    StationsModel stations{seat.session};
    ChangeHistory history;
    seat.model.setHistory(history);
    stations.setHistory(history);
    seat.lift(kLungs);
    seat.move();
    stations.show(kRoom);
    seat.object.setStation(kRoom);
    QCoreApplication::sendPostedEvents();
    QCOMPARE(history.texts(), (QStringList{QStringLiteral("Station 1: Lungs: moved along x"),
                                           QStringLiteral("Station 1: Lungs → lifted out")}));
    history.undo();
    QVERIFY(seat.isAt(kLungs, 0.0));
    history.undo();
    QVERIFY(seat.ownerOf(kLungs) == kNobody);
    QVERIFY(history.isEmpty());
    QVERIFY(!seat.node.refusal());
}

void TestLifting::theHistoryForgetsWhatIsOfAStationThatWasClosed()
{
    Seat seat{kIna};
    seat.node.addStation("Room 5");
    ChangeHistory history;
    seat.model.setHistory(history);
    seat.lift(kLungs);
    seat.move();
    QVERIFY(seat.model.canUndo());
    for (const ParticipantId who : {kIna, kTom, FakeSessionNode::kObserver})
        seat.node.decideAt(kRoom, fact::ParticipantMoved{who});
    seat.node.decideAt(kStation, fact::StationClosed{});
    QVERIFY(!seat.node.refusal());
    QCoreApplication::sendPostedEvents();
    QVERIFY(!seat.model.canUndo());
    QCOMPARE(history.texts(), QStringList{QStringLiteral("Lungs → lifted out")}); // says why not
    StationsModel stations{seat.session};
    stations.setHistory(history);
    QVERIFY(history.isEmpty());
}

void TestLifting::aTraineePutsBackWhatIsTheirs()
{
    Seat seat{kTom};
    QVERIFY(!seat.model.canPutAllBack());
    seat.pass(kAirway, kIna);
    QVERIFY(!seat.model.canPutAllBack());
    seat.lift(kLungs);
    seat.move();
    seat.lift(kSecondTube);
    QVERIFY(seat.model.canPutAllBack());
    seat.model.putAllBack();
    QVERIFY(seat.ownerOf(kLungs) == kNobody && seat.ownerOf(kSecondTube) == kNobody);
    QVERIFY(seat.ownerOf(kAirway) == kIna);
    QVERIFY(!seat.model.canPutAllBack());
}

void TestLifting::anInstructorPutsBackEverythingAndThePatient()
{
    Seat seat{kIna, kTom};
    seat.pass(kLungs, kTom);
    seat.lift(kAirway);
    seat.node.ownerActs(kPatient, {ActionKind::Translation, Vec3::UnitX(), 0.1});
    seat.node.advance(seconds{1});
    seat.model.putAllBack();
    QCoreApplication::sendPostedEvents();
    QVERIFY(seat.ownerOf(kLungs) == kNobody && seat.ownerOf(kAirway) == kNobody);
    QVERIFY(seat.ownerOf(kPatient) == kIna);
    seat.node.advance(seconds{1});
    QVERIFY(seat.isAt(kPatient, 0.0));
    QVERIFY(!seat.model.canPutAllBack());
}

void TestLifting::takesNothingOverThatAnotherTookMeanwhile()
{
    Seat seat{kIna, kTom};
    seat.node.ownerActs(kPatient, {ActionKind::Translation, Vec3::UnitX(), 0.1});
    seat.node.advance(seconds{1});
    const ParticipantId ivo{4};
    seat.node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ivo"});
    seat.node.hostGoesAway();
    seat.model.putAllBack();
    seat.pass(kPatient, ivo); // whose proposal came first
    seat.node.hostComesBack();
    QCoreApplication::sendPostedEvents();
    QVERIFY(seat.ownerOf(kPatient) == ivo);
    seat.pass(kPatient, kIna);
    QCoreApplication::sendPostedEvents();
    QVERIFY(!seat.isAt(kPatient, 0.0)); // nobody asked for that
}

void TestLifting::namesWhatIsLiftedOut()
{
    Seat seat{kTom};
    const auto lifted = [&seat] { return liftedObjects(seat.node, kStation, *seat.node.now()); };
    QVERIFY(liftedText(lifted()).isEmpty());
    seat.lift(kLungs);
    seat.pass(kSecondTube, kIna);
    QCOMPARE(liftedText(lifted()), QStringLiteral("▲ Lifted out: Lungs (you), Second tube (Ina)"));
    seat.move();
    QVERIFY(std::abs(lifted().front().acted.X_AO.translation().x() - 0.1) < kSmall);
    QVERIFY(liftedObjects(seat.node, StationId{1}, *seat.node.now()).empty());
}

CARINA_TEST(TestLifting)

} // namespace carina::lifting_test

#include "tst_lifting.moc"
