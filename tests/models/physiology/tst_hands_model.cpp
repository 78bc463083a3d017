#include "engine/lungs/mechanics/respiratory_system.h"
#include "models/physiology/hands_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::hands_model_test
{

using test::FakeSessionNode;

class TestHandsModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void inflatesAndEmptiesTheCuff();
    void drawsTheStylet();
    void squeezesTheBagAsThePatientBreathesQuietly();
    void letsGoOfTheBagThatAnInstructorSet();
    void leavesTheBagToWhoIsAtWork();
    void leavesNothingToAnObserver();
    void goesToAnotherStation();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};
constexpr StationId kRoom{1};

struct Hands {
    FakeSessionNode node;
    SessionModel session{node};
    HandsModel model{session, FakeSessionNode::kStation};

    explicit Hands(ParticipantId self = FakeSessionNode::kTrainee) : node{self} {}
    void settle()
    {
        node.advance(kLead);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] HandBag bagAt(StationId station) const
    {
        const auto state = node.state();
        return state->stations().at(station).respiration.settingsAt(SessionTime::max()).bag;
    }
};

} // namespace

void TestHandsModel::inflatesAndEmptiesTheCuff()
{
    Hands hands;
    QVERIFY(!hands.model.isCuffInflated());
    hands.model.setCuff(true);
    QVERIFY(hands.model.isCuffInflated());
    QCOMPARE(hands.model.travellingText(), QStringLiteral("Cuff → inflated"));
    hands.settle();
    QVERIFY(hands.model.isCuffInflated());
    QVERIFY(hands.model.travellingText().isEmpty());
    hands.model.setCuff(false);
    hands.settle();
    QVERIFY(!hands.model.isCuffInflated());
}

void TestHandsModel::drawsTheStylet()
{
    Hands hands;
    QVERIFY(!hands.model.hasStylet()); // nobody follows a tube
    hands.node.decide(fact::IntubationNoted{
        {.step = IntubationStep::TubePastTeeth, .at = *hands.node.now()}, millimetres(6.5)});
    hands.settle();
    QVERIFY(hands.model.hasStylet());
    hands.model.drawStylet();
    hands.settle();
    QVERIFY(!hands.model.hasStylet());
}

void TestHandsModel::squeezesTheBagAsThePatientBreathesQuietly()
{
    Hands hands;
    const PatientBuild infant{metres(0.66), 7.5, 0.5, Sex::Female};
    hands.node.decide(fact::PatientBuildSet{infant});
    hands.settle();
    const QSignalSpy changed{&hands.model, &HandsModel::changed};
    hands.model.squeezeBag(true);
    QVERIFY(hands.model.isBagSqueezed());
    QCOMPARE(hands.model.travellingText(), QStringLiteral("Bag → squeezed"));
    QVERIFY(!changed.isEmpty());
    hands.settle();
    QVERIFY(hands.model.travellingText().isEmpty());
    const BreathingPattern quiet = restingPattern(infant);
    const HandBag bag = hands.bagAt(FakeSessionNode::kStation);
    QCOMPARE(bag.rate.si, quiet.rate.si);
    QCOMPARE(bag.tidalVolume.si, quiet.tidalVolume.si);
    hands.model.squeezeBag(false);
    hands.settle();
    QVERIFY(!hands.model.isBagSqueezed());
    QCOMPARE(hands.bagAt(FakeSessionNode::kStation).rate.si, 0.0);
}

void TestHandsModel::letsGoOfTheBagThatAnInstructorSet()
{
    Hands hands;
    const HandBag set{perMinute(30.0), millilitres(150.0)};
    hands.node.decide(fact::BagSqueezed{set}, FakeSessionNode::kInstructor);
    hands.settle();
    QVERIFY(hands.model.isBagSqueezed());
    hands.model.squeezeBag(false);
    hands.settle();
    QVERIFY(!hands.model.isBagSqueezed());
    QVERIFY(hands.bagAt(FakeSessionNode::kStation) == (HandBag{Frequency{}, set.tidalVolume}));
}

void TestHandsModel::leavesTheBagToWhoIsAtWork()
{
    Hands hands;
    QVERIFY(hands.model.obstacleToBag().isEmpty());
    hands.node.decide(fact::WorkTaken{FakeSessionNode::kInstructor, FakeSessionNode::kTrainee});
    hands.settle();
    QCOMPARE(hands.model.obstacleToBag(),
             QStringLiteral("Ina is at work here and squeezes the bag."));
    QVERIFY(hands.model.obstacle().isEmpty()); // who helps handles cuff and stylet
    const int before = hands.node.proposed;
    hands.model.squeezeBag(true);
    QCOMPARE(hands.node.proposed, before);
    QVERIFY(!hands.model.isBagSqueezed());
    hands.node.decide(fact::WorkTaken{FakeSessionNode::kTrainee, FakeSessionNode::kInstructor});
    hands.settle();
    hands.model.squeezeBag(true);
    QVERIFY(hands.model.isBagSqueezed());
}

void TestHandsModel::leavesNothingToAnObserver()
{
    Hands hands{FakeSessionNode::kObserver};
    const int before = hands.node.proposed;
    QVERIFY(!hands.model.obstacle().isEmpty());
    QCOMPARE(hands.model.obstacleToBag(), hands.model.obstacle());
    hands.model.setCuff(true);
    hands.model.squeezeBag(true);
    hands.settle();
    QCOMPARE(hands.node.proposed, before);
    QVERIFY(!hands.model.isCuffInflated());
    QVERIFY(!hands.model.isBagSqueezed());
}

void TestHandsModel::goesToAnotherStation()
{
    Hands hands{FakeSessionNode::kInstructor};
    hands.node.addStation("Room 5");
    hands.model.setStation(kRoom);
    hands.model.squeezeBag(true);
    hands.model.setCuff(true);
    hands.settle();
    QVERIFY(hands.bagAt(kRoom).rate > Frequency{});
    QVERIFY(!(hands.bagAt(FakeSessionNode::kStation).rate > Frequency{}));
    hands.model.setStation(FakeSessionNode::kStation);
    QVERIFY(!hands.model.isBagSqueezed());
    QVERIFY(!hands.model.isCuffInflated());
}

CARINA_TEST(TestHandsModel)

} // namespace carina::hands_model_test

#include "tst_hands_model.moc"
