#include "engine/io/anatomy_set/anatomy_cache.h"
#include "models/airway/head_position_model.h"
#include "models/patient/session_patient.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/lacking_patient.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <cmath>
#include <optional>

namespace carina::head_position_model_test
{

using test::FakeSessionNode;

class TestHeadPositionModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isNeutralAtFirst();
    void setsAPositionThatTravels();
    void tellsHowTheHeadLiesWhileThatChanges();
    void tellsWhatAStiffNeckLeaves();
    void tellsWhatAnInfantsNeckLeaves();
    void tellsALimitOnlyOfThePatientThatLiesThere();
    void undoesAChangeInItsMidstAtOnce();
    void undoesThroughTheHistory();
    void changesAllStationsAndUndoesEach();
    void followsAnotherInstructor();
    void doesNotProposeWhatIsAlreadySo();
    void letsOnlyAnInstructorChange();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};
constexpr double kRounding_deg = 1e-6;
constexpr const char* kNewborn = "newborn, 50 cm, girl";

struct Console {
    FakeSessionNode node;
    SessionModel session{node};
    HeadPositionModel model{session, FakeSessionNode::kStation};
    std::optional<SessionPatient> patient;

    explicit Console(ParticipantId self = FakeSessionNode::kInstructor) : node{self} {}
    void lay(const SharedPatientModel& lying)
    {
        patient.emplace(node, FakeSessionNode::kStation, lying, AnatomyCache::defaultFolder());
        model.setPatient(*patient);
    }
    void settle(Duration time = kLead)
    {
        node.advance(time);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] HeadPosition decided(StationId station = FakeSessionNode::kStation) const
    {
        return node.state()->stations().at(station).headPosition.decidedAt(SessionTime::max());
    }
    [[nodiscard]] bool showsNow(double flexion_deg, double extension_deg) const
    {
        const HeadPosition now = model.present();
        return std::abs(inDegrees(now.flexion) - flexion_deg) < kRounding_deg
               && std::abs(inDegrees(now.extension) - extension_deg) < kRounding_deg;
    }
};

} // namespace

void TestHeadPositionModel::isNeutralAtFirst()
{
    const Console console;
    QVERIFY(console.model.position() == HeadPosition{});
    QVERIFY(console.model.isNeutral());
    QCOMPARE(console.model.inForceText(), QStringLiteral("neck 0°, head 0°"));
    QVERIFY(console.model.travellingText().isEmpty());
    QVERIFY(!console.model.canUndo());
}

void TestHeadPositionModel::setsAPositionThatTravels()
{
    Console console;
    console.model.setPosition(kSniffing);
    QVERIFY(console.model.position() == kSniffing);
    QVERIFY(console.model.isNeutral()); // not in force yet
    QCOMPARE(console.model.travellingText(),
             QStringLiteral("Head position → Sniffing: neck 35° flexed, head 24° extended"));
    console.settle();
    QVERIFY(console.decided() == kSniffing);
    QVERIFY(console.model.present() == kSniffing);
    QVERIFY(console.model.travellingText().isEmpty());
}

/// 35 degrees over 10 s: 7 after two.
void TestHeadPositionModel::tellsHowTheHeadLiesWhileThatChanges()
{
    Console console;
    console.model.setChangeTime(std::chrono::seconds{10});
    console.model.setPosition(kNeckFlexed);
    console.settle();
    QVERIFY(console.model.position() == kNeckFlexed);
    QVERIFY(console.showsNow(0.0, 0.0));
    const QSignalSpy changed{&console.model, &HeadPositionModel::changed};
    console.settle(std::chrono::seconds{2});
    QVERIFY(console.showsNow(7.0, 0.0));
    QVERIFY(!changed.isEmpty());
    QCOMPARE(console.model.inForceText(), QStringLiteral("neck 7° flexed, head 0°"));
    console.settle(std::chrono::seconds{8});
    QVERIFY(console.showsNow(35.0, 0.0));
}

void TestHeadPositionModel::tellsWhatAStiffNeckLeaves()
{
    Console console;
    console.model.setPosition(kSniffing);
    console.settle();
    console.node.decide(fact::AirwayEventsSet{{{AirwayEventKind::StiffNeck, 1.0}}, {}});
    console.settle();
    QVERIFY(console.model.position() == kSniffing);
    QVERIFY(console.model.isNeutral());
}

/// 35 degrees where incisors and glottis are 79 mm apart, and less in proportion where they are
/// less; the head is extended as it was laid.
void TestHeadPositionModel::tellsWhatAnInfantsNeckLeaves()
{
    Console console;
    const SharedPatientModel newborn = test::landmarksOf(kNewborn);
    const AirwayLandmarks& at = newborn->landmarks();
    const double way_mm = 1e3 * (at.p_A_glottis - at.p_A_incisors).norm();
    console.lay(newborn);
    console.model.setPosition(kSniffing);
    console.settle();
    QVERIFY(console.model.position() == kSniffing);
    QVERIFY(console.showsNow(35.0 * way_mm / 79.0, 24.2));
    QCOMPARE(console.model.limitText(), QStringLiteral("this patient's neck flexes no farther"));
    QCOMPARE(console.model.inForceText(),
             QStringLiteral("neck 22° flexed, head 24° extended (this patient's neck flexes no "
                            "farther)"));
    // A stiff neck leaves 14 degrees, which are within the infant's 22.
    console.node.decide(fact::AirwayEventsSet{{{AirwayEventKind::StiffNeck, 0.6}}, {}});
    console.settle();
    QVERIFY(console.showsNow(14.0, 12.0));
    QVERIFY(console.model.limitText().isEmpty());
    console.node.decide(fact::AirwayEventsSet{});
    console.model.setPosition(kHeadExtended);
    console.settle();
    QVERIFY(console.model.present() == kHeadExtended);
    QVERIFY(console.model.limitText().isEmpty());
}

/// While another one is chosen there and not here yet, nothing is known of it.
void TestHeadPositionModel::tellsALimitOnlyOfThePatientThatLiesThere()
{
    Console console;
    console.model.setPosition(kSniffing);
    console.settle();
    const QSignalSpy changed{&console.model, &HeadPositionModel::changed};
    console.lay(test::landmarksOf(kNewborn));
    QVERIFY(!changed.isEmpty());
    QVERIFY(!console.model.limitText().isEmpty());
    console.node.decide(fact::AnatomyChosen{"another", "Another"});
    console.settle();
    QVERIFY(console.model.present() == kSniffing);
    QVERIFY(console.model.limitText().isEmpty());
    console.lay(test::landmarksOf("adult")); // which is not chosen either
    QVERIFY(console.model.limitText().isEmpty());
}

void TestHeadPositionModel::undoesAChangeInItsMidstAtOnce()
{
    Console console;
    console.model.setPosition(kHeadExtended);
    console.settle();
    console.model.setChangeTime(std::chrono::minutes{10});
    console.model.setPosition(kSniffing);
    console.settle(std::chrono::minutes{5});
    QVERIFY(console.model.present().flexion > degrees(10.0));
    console.model.undo();
    console.settle();
    QVERIFY(console.model.present() == kHeadExtended);
    console.model.undo();
    console.settle();
    QVERIFY(console.decided() == HeadPosition{});
    QVERIFY(!console.model.canUndo());
}

void TestHeadPositionModel::undoesThroughTheHistory()
{
    Console console;
    ChangeHistory history;
    console.model.setHistory(history);
    console.model.setPosition(kHeadExtended);
    console.settle();
    QCOMPARE(history.texts(),
             QStringList{QStringLiteral("Head position → Extended: neck 0°, head 20° extended")});
    history.undo();
    console.settle();
    QVERIFY(console.decided() == HeadPosition{});
    QVERIFY(history.isEmpty());
}

void TestHeadPositionModel::changesAllStationsAndUndoesEach()
{
    constexpr StationId kRoom{1};
    Console console;
    console.node.addStation("Room 5");
    console.model.setPosition(kNeckFlexed);
    console.settle();
    console.model.setForAll(true);
    console.model.setPosition(kSniffing);
    console.settle();
    QVERIFY(console.decided() == kSniffing);
    QVERIFY(console.decided(kRoom) == kSniffing);
    console.model.setForAll(false);
    console.model.setStation(kRoom);
    QVERIFY(console.model.position() == kSniffing);
    console.model.undo();
    console.settle();
    QVERIFY(console.decided() == kNeckFlexed);
    QVERIFY(console.decided(kRoom) == HeadPosition{});
}

void TestHeadPositionModel::followsAnotherInstructor()
{
    Console console;
    const QSignalSpy changed{&console.model, &HeadPositionModel::changed};
    console.node.decide(fact::HeadPositionSet{kHeadExtended, {}});
    console.settle();
    QVERIFY(console.model.position() == kHeadExtended);
    QVERIFY(!changed.isEmpty());
}

void TestHeadPositionModel::doesNotProposeWhatIsAlreadySo()
{
    Console console;
    console.model.setPosition({});
    QCOMPARE(console.node.proposed, 0);
    QVERIFY(!console.model.canUndo());
}

void TestHeadPositionModel::letsOnlyAnInstructorChange()
{
    Console console{FakeSessionNode::kObserver};
    QVERIFY(!console.model.obstacle().isEmpty());
    console.model.setPosition(kSniffing);
    QCOMPARE(console.node.proposed, 0);
    QVERIFY(console.model.position() == HeadPosition{});
}

CARINA_TEST(TestHeadPositionModel)

} // namespace carina::head_position_model_test

#include "tst_head_position_model.moc"
