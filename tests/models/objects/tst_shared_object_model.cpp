#include "models/objects/shared_object_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::shared_object_model_test
{

using test::FakeSessionNode;

class TestSharedObjectModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void offersOnlyWhatActionsMove();
    void saysWhoCanDoNothing_data();
    void saysWhoCanDoNothing();
    void saysWhoseItIs();
    void offersWhatTheHostPermits_data();
    void offersWhatTheHostPermits();
    void knowsOnlyItsStation();
    void listsThoseWhoAskFirst();
    void listsEverybodyHereForAnInstructor();
    void asksAndTakesTheWishBack();
    void takesOver();
    void offersNothingTwiceWhileTheHostIsAway();
    void losesToWhoeverWasFirst();
};

namespace
{

constexpr ObjectId kPatient = FakeSessionNode::kPatient;

struct Seat {
    FakeSessionNode node;
    SessionModel session{node};
    SharedObjectModel model{session, FakeSessionNode::kStation};

    /// Who sits here, and whose the patient is.
    explicit Seat(ParticipantId self, ParticipantId owner = FakeSessionNode::kTrainee) : node{self}
    {
        node.sharePatient(owner);
    }
    [[nodiscard]] const SharedObject& patient() const
    {
        m_state = node.state();
        return m_state->objects().at(kPatient);
    }
    void addTrainee(const char* name)
    {
        node.decide(fact::ParticipantJoined{{}, Role::Trainee, name});
    }
    [[nodiscard]] QStringList heirs() const
    {
        QStringList names;
        for (const auto& heir : model.heirs())
            names << heir.name;
        return names;
    }

private:
    mutable std::shared_ptr<const SessionState> m_state;
};

} // namespace

void TestSharedObjectModel::offersOnlyWhatActionsMove()
{
    Seat seat{FakeSessionNode::kInstructor};
    QCOMPARE(seat.model.objects().size(), std::size_t{1}); // not the tracked tube
    QVERIFY(seat.model.objects().front().id == kPatient);
    QVERIFY(seat.model.chosen()->id == kPatient);
    seat.node.decide(fact::ObjectShared{
        {}, FakeSessionNode::kInstructor, ObjectKind::Patient, "Second patient"});
    QVERIFY(seat.model.chosen()->id == kPatient); // until another is chosen
    QSignalSpy changes{&seat.model, &SharedObjectModel::changed};
    seat.model.choose(ObjectId{3});
    QCOMPARE(changes.size(), 1);
    QVERIFY(seat.model.chosen()->id == ObjectId{3});
    seat.model.choose(FakeSessionNode::kTube); // which is not offered
    QVERIFY(seat.model.chosen()->id == kPatient);
}

void TestSharedObjectModel::saysWhoCanDoNothing_data()
{
    QTest::addColumn<int>("self");
    QTest::addColumn<QString>("start");
    QTest::newRow("observer") << int(FakeSessionNode::kObserver.value)
                              << QStringLiteral("Observers cannot move anything.");
    QTest::newRow("not admitted yet")
        << int(kNobody.value) << QStringLiteral("Wait until the session has admitted you.");
    QTest::newRow("trainee") << int(FakeSessionNode::kTrainee.value) << QString{};
    QTest::newRow("instructor") << int(FakeSessionNode::kInstructor.value) << QString{};
}

void TestSharedObjectModel::saysWhoCanDoNothing()
{
    QFETCH(int, self);
    QFETCH(QString, start);
    const Seat seat{ParticipantId{std::uint16_t(self)}};
    QCOMPARE(seat.model.obstacle().isEmpty(), start.isEmpty());
    QVERIFY(seat.model.obstacle().startsWith(start));
    FakeSessionNode bare{FakeSessionNode::kTrainee};
    SessionModel session{bare};
    QVERIFY(SharedObjectModel(session, FakeSessionNode::kStation)
                .obstacle()
                .startsWith(QStringLiteral("No object that can be moved is shared yet")));
}

void TestSharedObjectModel::saysWhoseItIs()
{
    Seat seat{FakeSessionNode::kInstructor};
    QCOMPARE(seat.model.ownerText(), QStringLiteral("◆ Tom"));
    QVERIFY(!seat.model.isOwn());
    seat.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    QCOMPARE(seat.model.ownerText(), QStringLiteral("○ Tom, has left"));
    seat.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tom"});
    seat.node.decide(fact::ParticipantFellSilent{FakeSessionNode::kTrainee});
    QCOMPARE(seat.model.ownerText(), QStringLiteral("▲ Tom, is away"));
    seat.model.takeOver();
    QCOMPARE(seat.model.ownerText(), QStringLiteral("● you"));
    QVERIFY(seat.model.isOwn());
}

void TestSharedObjectModel::offersWhatTheHostPermits_data()
{
    QTest::addColumn<int>("self");
    QTest::addColumn<int>("owner");
    QTest::addColumn<bool>("asks");
    QTest::addColumn<bool>("takes");
    QTest::addColumn<QStringList>("heirs");
    const int ina = FakeSessionNode::kInstructor.value;
    const int tom = FakeSessionNode::kTrainee.value;
    const int olga = FakeSessionNode::kObserver.value;
    const int tess = 4;
    const QString Ina = QStringLiteral("Ina"), Tom = QStringLiteral("Tom"),
                  Tess = QStringLiteral("Tess");
    QTest::newRow("instructor who has it")
        << ina << ina << false << false << QStringList{Tom, Tess};
    QTest::newRow("instructor who has it not") << ina << tom << true << true << QStringList{Tess};
    QTest::newRow("trainee who has it") << tom << tom << false << false << QStringList{Ina};
    QTest::newRow("trainee who has it not") << tess << tom << true << false << QStringList{};
    QTest::newRow("observer") << olga << tom << false << false << QStringList{};
    QTest::newRow("stranger") << int(kNobody.value) << tom << false << false << QStringList{};
}

void TestSharedObjectModel::offersWhatTheHostPermits()
{
    QFETCH(int, self);
    QFETCH(int, owner);
    QFETCH(bool, asks);
    QFETCH(bool, takes);
    QFETCH(QStringList, heirs);
    Seat seat{ParticipantId{std::uint16_t(self)}, ParticipantId{std::uint16_t(owner)}};
    seat.addTrainee("Tess");
    QCOMPARE(seat.model.canAsk(), asks);
    QCOMPARE(seat.model.canTakeOver(), takes);
    QCOMPARE(seat.heirs(), heirs);
    // What is not offered is not proposed either, and what is offered the host takes.
    const int before = seat.node.proposed;
    seat.model.ask();
    seat.model.takeOver();
    QCOMPARE(seat.node.proposed - before, int(asks) + int(takes));
    QVERIFY(!seat.node.refusal());
    if (heirs.isEmpty()) {
        seat.model.handOver(FakeSessionNode::kInstructor);
        QCOMPARE(seat.node.proposed - before, int(asks) + int(takes));
    }
}

void TestSharedObjectModel::knowsOnlyItsStation()
{
    Seat seat{FakeSessionNode::kInstructor};
    seat.addTrainee("Tess");
    seat.node.addStation("Room 5");
    QVERIFY(seat.heirs().contains(QStringLiteral("Tess")));
    seat.node.decideAt(StationId{1}, fact::ParticipantMoved{ParticipantId{4}});
    QVERIFY(!seat.heirs().contains(QStringLiteral("Tess"))); // what is here is not hers to have
    QSignalSpy changed{&seat.model, &SharedObjectModel::changed};
    seat.model.setStation(StationId{1});
    QCOMPARE(changed.count(), 1);
    QVERIFY(seat.model.objects().empty());
    QVERIFY(!seat.model.chosen());
}

void TestSharedObjectModel::listsThoseWhoAskFirst()
{
    Seat seat{FakeSessionNode::kTrainee};
    seat.addTrainee("Tess");
    seat.addTrainee("Theo");
    seat.addTrainee("Away");
    seat.node.decide(fact::ParticipantLeft{ParticipantId{6}});
    QCOMPARE(seat.heirs(), QStringList{QStringLiteral("Ina")}); // nobody else gets it unasked
    QVERIFY(seat.model.wishText().isEmpty());
    seat.node.decide(fact::ObjectWanted{kPatient}, ParticipantId{5});
    seat.node.decide(fact::ObjectWanted{kPatient}, ParticipantId{4});
    QCOMPARE(seat.model.wishText(), QStringLiteral("Asking for it: Theo, Tess"));
    QCOMPARE(seat.heirs(),
             (QStringList{QStringLiteral("Theo"), QStringLiteral("Tess"), QStringLiteral("Ina")}));
    seat.model.handOver(ParticipantId{5});
    QVERIFY(seat.patient().owner == ParticipantId{5});
    QCOMPARE(seat.model.wishText(), QStringLiteral("Asking for it: Tess"));
}

void TestSharedObjectModel::listsEverybodyHereForAnInstructor()
{
    Seat seat{FakeSessionNode::kInstructor};
    seat.addTrainee("Tess");
    seat.addTrainee("Theo");
    seat.node.decide(fact::ObjectWanted{kPatient}, ParticipantId{5});
    QCOMPARE(seat.heirs(), (QStringList{QStringLiteral("Theo"), QStringLiteral("Tess")}));
}

void TestSharedObjectModel::asksAndTakesTheWishBack()
{
    Seat seat{FakeSessionNode::kTrainee, FakeSessionNode::kInstructor};
    QVERIFY(!seat.model.isAsking());
    seat.model.ask();
    QVERIFY(seat.model.isAsking());
    QCOMPARE(seat.model.wishText(), QStringLiteral("Asking for it: you"));
    seat.model.ask();
    QVERIFY(!seat.model.isAsking());
    QVERIFY(seat.patient().wantedBy.empty());
}

void TestSharedObjectModel::takesOver()
{
    Seat seat{FakeSessionNode::kInstructor};
    seat.model.takeOver();
    QVERIFY(seat.patient().owner == FakeSessionNode::kInstructor);
    QCOMPARE(seat.patient().epoch, std::uint16_t{2});
}

void TestSharedObjectModel::offersNothingTwiceWhileTheHostIsAway()
{
    Seat seat{FakeSessionNode::kTrainee};
    seat.node.hostGoesAway();
    seat.model.handOver(FakeSessionNode::kInstructor);
    QCOMPARE(seat.model.ownerText(), QStringLiteral("● you → Ina"));
    QVERIFY(seat.model.heirs().empty());
    QVERIFY(!seat.model.canAsk());
    seat.node.hostComesBack();
    QCOMPARE(seat.model.ownerText(), QStringLiteral("◆ Ina"));
    seat.node.hostGoesAway();
    seat.model.ask();
    QVERIFY(!seat.model.canAsk());
    seat.node.hostComesBack();
    QVERIFY(seat.model.isAsking());
}

void TestSharedObjectModel::losesToWhoeverWasFirst()
{
    Seat seat{FakeSessionNode::kInstructor};
    seat.node.hostGoesAway();
    seat.model.takeOver();
    // Meanwhile its owner gave it to somebody else, which the host judged first.
    seat.addTrainee("Tess");
    seat.node.decide(fact::ObjectWanted{kPatient}, ParticipantId{4});
    seat.node.decide(fact::ObjectHandedOver{kPatient, ParticipantId{4}, 1},
                     FakeSessionNode::kTrainee);
    seat.node.hostComesBack();
    QCOMPARE(seat.node.refusal()->code, Errc::OwnerChanged);
    QCOMPARE(seat.model.ownerText(), QStringLiteral("◆ Tess"));
    QVERIFY(seat.model.canTakeOver());
}

CARINA_TEST(TestSharedObjectModel)

} // namespace carina::shared_object_model_test

#include "tst_shared_object_model.moc"
