#include "models/objects/liftables.h"
#include "models/objects/object_action_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <array>

namespace carina::object_hand_over_test
{

using test::FakeSessionNode;

/// What changes hands, and comes back by the session's undo.
class TestObjectHandOver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesBackToWhomItBelonged_data();
    void givesBackToWhomItBelonged();
    void putsBackWhatWasLiftedOut();
    void goesBackAStepAtATime();
    void takesBackAllDownToAStep();
    void takesBackWhatIsStillUnderWay();
    void givesThePatientBackAfterEverythingWasPutBack();
    void undoesAtOnceThatEverythingWasPutBack();
    void undoesTheRestOfWhatWasPutBackAndSaysWhy();
    void saysWhyItStays_data();
    void saysWhyItStays();
    void takesBackWhatIsOfAnotherStation();
};

namespace
{

constexpr StationId kStation = FakeSessionNode::kStation;
constexpr StationId kOtherStation{1};
constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
constexpr ParticipantId kIna = FakeSessionNode::kInstructor;
constexpr ParticipantId kTess{4};
constexpr ObjectId kPatient = FakeSessionNode::kPatient;
constexpr ObjectId kLungs{4}; ///< the groups are shared in their order
constexpr std::array kOtherGroups{ObjectId{3}, ObjectId{5}, ObjectId{6}, ObjectId{7}};
constexpr ObjectId kOwn = kOtherGroups[0]; ///< the airway
constexpr double kSmall = 1e-6;            ///< metres: rates travel as 32-bit numbers

/// An instructor's console; another trainee, Tess, is here, too.
struct Desk {
    FakeSessionNode node{FakeSessionNode::kHost};
    SessionModel session{node};
    SharedObjectModel object{session, kStation};
    ObjectActionModel model{object};
    ChangeHistory history;
    QSignalSpy refused{&history, &ChangeHistory::refused};

    explicit Desk(ParticipantId patientOwner = kTom)
    {
        node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tess"});
        node.addStation("Room 5");
        node.sharePatient(patientOwner);
        shareLiftables(node, kStation);
        node.becomes(kIna);
        model.setHistory(history);
    }
    [[nodiscard]] ParticipantId ownerOf(ObjectId id) const
    {
        return node.state()->objects().at(id).owner;
    }
    /// Somebody else gets an object, or it is put back.
    void pass(ObjectId id, ParticipantId to)
    {
        node.decide(fact::ObjectHandedOver{id, to, node.state()->objects().at(id).epoch});
        deliver();
    }
    static void deliver() { QCoreApplication::sendPostedEvents(); }
    void undo(int count = 1)
    {
        history.undo(count);
        deliver();
    }
    void takeOver(ObjectId id)
    {
        object.choose(id);
        object.takeOver();
    }
    void putBack(ObjectId id)
    {
        object.choose(id);
        model.putBack();
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
        node.advance(std::chrono::seconds{1});
        model.stop();
    }
    [[nodiscard]] double x(ObjectId id) const
    {
        const auto shown = node.shown(id, *node.now());
        return shown ? shown->acted.X_AO.translation().x() : 0.0;
    }
    /// Why the last change stayed.
    [[nodiscard]] QString reason() const
    {
        return refused.isEmpty() ? QString{} : refused.last().front().toString();
    }
};

/// What an instructor does with what is Tom's.
struct Deed {
    const char* name;
    void (*make)(Desk&);
    ObjectId object;
    const char* text; ///< in the history
};
constexpr std::array kDeeds{
    Deed{"taken over", [](Desk& desk) { desk.takeOver(kPatient); }, kPatient,
         "Adult → taken over from Tom"},
    Deed{"given to another",
         [](Desk& desk) {
             desk.object.choose(kPatient);
             desk.object.handOver(kTess);
         },
         kPatient, "Adult → given to Tess"},
    Deed{"put back", [](Desk& desk) { desk.putBack(kLungs); }, kLungs, "Lungs → put back"}};

/// What happened since the lungs, which were Tom's, were taken over.
struct Obstacle {
    const char* name;
    void (*happen)(Desk&);
    const char* told;
};
constexpr std::array kObstacles{
    Obstacle{"another has it", [](Desk& desk) { desk.pass(kLungs, kTess); },
             "Not undone: Tess has got Lungs since."},
    Obstacle{"it was put back", [](Desk& desk) { desk.pass(kLungs, kNobody); },
             "Not undone: somebody has put Lungs back since."},
    Obstacle{"whose it was has it", [](Desk& desk) { desk.pass(kLungs, kTom); },
             "Nothing to undo: Tom has got Lungs back."},
    Obstacle{"whose it was has left",
             [](Desk& desk) { desk.node.decide(fact::ParticipantLeft{kTom}); },
             "Not undone: Tom, to whom Lungs belonged, has left the session."},
    Obstacle{"whose it was is elsewhere",
             [](Desk& desk) { desk.node.decideAt(kOtherStation, fact::ParticipantMoved{kTom}); },
             "Not undone: Tom, to whom Lungs belonged, is at another station now."},
    Obstacle{"whose it was has both hands full",
             [](Desk& desk) {
                 for (const ObjectId group : kOtherGroups)
                     desk.pass(group, kTom);
             },
             "Not undone: Tom, to whom Lungs belonged, has as much as they may hold."}};

} // namespace

void TestObjectHandOver::givesBackToWhomItBelonged_data()
{
    QTest::addColumn<int>("place");
    for (int place = 0; place < int(kDeeds.size()); ++place)
        QTest::newRow(kDeeds[std::size_t(place)].name) << place;
}

void TestObjectHandOver::givesBackToWhomItBelonged()
{
    QFETCH(const int, place);
    const Deed& deed = kDeeds[std::size_t(place)];
    Desk desk;
    desk.pass(kLungs, kTom);
    deed.make(desk);
    QVERIFY(desk.ownerOf(deed.object) != kTom);
    QCOMPARE(desk.history.texts(), QStringList{QString::fromUtf8(deed.text)});
    desk.undo();
    QVERIFY(desk.ownerOf(deed.object) == kTom);
    QVERIFY(desk.history.isEmpty());
    QVERIFY(desk.refused.isEmpty());
    QVERIFY(!desk.node.refusal());
}

void TestObjectHandOver::putsBackWhatWasLiftedOut()
{
    Desk desk;
    desk.lift(kLungs);
    QVERIFY(desk.ownerOf(kLungs) == kIna);
    QCOMPARE(desk.history.texts(), QStringList{QStringLiteral("Lungs → lifted out")});
    desk.undo();
    QVERIFY(desk.ownerOf(kLungs) == kNobody);
}

void TestObjectHandOver::goesBackAStepAtATime()
{
    Desk desk{kIna};
    desk.object.choose(kPatient);
    desk.object.handOver(kTom);
    desk.object.takeOver();
    desk.undo();
    QVERIFY(desk.ownerOf(kPatient) == kTom);
    desk.undo();
    QVERIFY(desk.ownerOf(kPatient) == kIna);
    QVERIFY(desk.refused.isEmpty());
}

/// The place from before the first of them counts, and not that from before the last.
void TestObjectHandOver::takesBackAllDownToAStep()
{
    Desk desk;
    desk.lift(kLungs);
    desk.move();
    desk.putBack(kLungs);
    Desk::deliver();
    QCOMPARE(desk.history.texts().size(), 3);
    desk.undo(2);
    QVERIFY(desk.ownerOf(kLungs) == kIna);
    QVERIFY(std::abs(desk.x(kLungs)) < kSmall);
    desk.undo();
    QVERIFY(desk.ownerOf(kLungs) == kNobody);
    QVERIFY(!desk.node.refusal());
}

void TestObjectHandOver::takesBackWhatIsStillUnderWay()
{
    Desk desk;
    desk.node.hostGoesAway();
    desk.takeOver(kPatient);
    desk.lift(kLungs);
    desk.undo(2);
    QVERIFY(desk.refused.isEmpty());
    desk.node.hostComesBack();
    QVERIFY(desk.ownerOf(kPatient) == kTom);
    QVERIFY(desk.ownerOf(kLungs) == kNobody);
    QVERIFY(!desk.node.refusal());
}

void TestObjectHandOver::givesThePatientBackAfterEverythingWasPutBack()
{
    Desk desk;
    desk.node.ownerActs(kPatient, {ActionKind::Translation, Vec3::UnitX(), 0.1});
    desk.node.advance(std::chrono::seconds{1});
    desk.node.ownerActs(kPatient, {});
    desk.model.putAllBack();
    Desk::deliver();
    QVERIFY(desk.ownerOf(kPatient) == kIna);
    QCOMPARE(desk.history.texts(), QStringList{QStringLiteral("Everything put back")});
    desk.undo();
    QVERIFY(desk.ownerOf(kPatient) == kTom);
    QVERIFY(std::abs(desk.x(kPatient) - 0.1) < kSmall);
}

/// This person's own as it was moved, what was another's in its place.
void TestObjectHandOver::undoesAtOnceThatEverythingWasPutBack()
{
    Desk desk;
    desk.pass(kLungs, kTom);
    desk.node.ownerActs(kLungs, {ActionKind::Translation, Vec3::UnitX(), 0.1});
    desk.node.ownerActs(kPatient, {ActionKind::Translation, Vec3::UnitX(), 0.1});
    desk.lift(kOwn);
    desk.move();
    const QStringList before = desk.history.texts();
    desk.node.hostGoesAway();
    desk.model.putAllBack();
    desk.node.hostComesBack(); // what is taken over arrives later
    Desk::deliver();
    QVERIFY(desk.ownerOf(kLungs) == kNobody && desk.ownerOf(kOwn) == kNobody);
    QVERIFY(desk.ownerOf(kPatient) == kIna);
    QCOMPARE(desk.history.texts(), QStringList{QStringLiteral("Everything put back")} + before);
    desk.undo();
    QVERIFY(desk.ownerOf(kLungs) == kTom && desk.ownerOf(kPatient) == kTom);
    QVERIFY(desk.ownerOf(kOwn) == kIna);
    QVERIFY(std::abs(desk.x(kOwn) - 0.1) < kSmall);
    QVERIFY(std::abs(desk.x(kPatient) - 0.1) < kSmall);
    QVERIFY(std::abs(desk.x(kLungs)) < kSmall);
    QCOMPARE(desk.history.texts(), before);
    QVERIFY(desk.refused.isEmpty());
    QVERIFY(!desk.node.refusal());
}

void TestObjectHandOver::undoesTheRestOfWhatWasPutBackAndSaysWhy()
{
    Desk desk;
    desk.pass(kLungs, kTom);
    desk.pass(kOwn, kTom);
    desk.pass(kOtherGroups[1], kTess);
    desk.model.putAllBack();
    desk.pass(kLungs, kTess);
    desk.pass(kOwn, kTess);
    desk.undo();
    QVERIFY(desk.ownerOf(kLungs) == kTess && desk.ownerOf(kOwn) == kTess);
    QVERIFY(desk.ownerOf(kOtherGroups[1]) == kTess);
    QCOMPARE(desk.refused.size(), 1); // once, of both
    QCOMPARE(desk.reason(), QStringLiteral("Not undone: Tess has got Lungs since. "
                                           "Not undone: Tess has got Airway since."));
    QVERIFY(desk.history.isEmpty());
}

void TestObjectHandOver::saysWhyItStays_data()
{
    QTest::addColumn<int>("place");
    for (int place = 0; place < int(kObstacles.size()); ++place)
        QTest::newRow(kObstacles[std::size_t(place)].name) << place;
}

void TestObjectHandOver::saysWhyItStays()
{
    QFETCH(const int, place);
    const Obstacle& obstacle = kObstacles[std::size_t(place)];
    Desk desk;
    desk.pass(kLungs, kTom);
    desk.takeOver(kLungs);
    obstacle.happen(desk);
    const ParticipantId owner = desk.ownerOf(kLungs);
    const int before = desk.node.proposed;
    desk.undo();
    QCOMPARE(desk.reason(), QString::fromUtf8(obstacle.told));
    QCOMPARE(desk.node.proposed, before);
    QVERIFY(desk.ownerOf(kLungs) == owner);
    QVERIFY(desk.history.isEmpty()); // the next undo is about the change before
}

void TestObjectHandOver::takesBackWhatIsOfAnotherStation()
{
    Desk desk;
    desk.takeOver(kPatient);
    desk.object.setStation(kOtherStation);
    desk.undo();
    QVERIFY(desk.ownerOf(kPatient) == kTom);
    QVERIFY(desk.history.isEmpty());
    QVERIFY(desk.refused.isEmpty());
}

CARINA_TEST(TestObjectHandOver)

} // namespace carina::object_hand_over_test

#include "tst_object_hand_over.moc"
