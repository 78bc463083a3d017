#include "models/respiration/respiration_model.h"
#include "models/respiration/respiration_words.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <set>

namespace carina::respiration_model_test
{

using test::FakeSessionNode;

class TestRespirationModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsWhatIsInForce();
    void setsAndTellsWhatTravels();
    void tellsThatBreathingHasStopped();
    void changesAllStationsAndUndoesEach();
    void endsADragThatAnotherStationInterrupts();
    void choosesAConditionWithASeverityToBeSeen();
    void putsATubeIntoOneBronchus();
    void keepsOneProposalUnderWayWhileASeverityIsDragged();
    void doesNotProposeWhatIsAlreadySo();
    void undoesADragAtOnceAndThenWhatWasBefore();
    void undoesNotWhatSomebodyDecidedSince();
    void givesUpWhatTheHostRefuses();
    void undoesWhatCameBeforeWhatTheHostRefuses();
    void followsAnotherInstructor();
    void letsOnlyAnInstructorChange();
    void changesNothingAfterTheEnd();
    void hasAWordForEverything();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};
constexpr LungCondition kRightPneumothorax{ConditionKind::SimplePneumothorax, 0.4,
                                           ConditionSide::Right};

LungCondition only(const LungConditions& conditions)
{
    return conditions.size() == 1 ? conditions.front() : LungCondition{};
}

struct Console {
    FakeSessionNode node;
    SessionModel session{node};
    RespirationModel model{session, FakeSessionNode::kStation};

    explicit Console(ParticipantId self = FakeSessionNode::kInstructor) : node{self} {}
    void deliver()
    {
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    void settle()
    {
        node.advance(kLead);
        deliver();
    }
    [[nodiscard]] RespiratorySettings decided() const
    {
        return node.state()
            ->stations()
            .at(FakeSessionNode::kStation)
            .respiration.settingsAt(SessionTime::max());
    }
};

} // namespace

void TestRespirationModel::showsWhatIsInForce()
{
    Console console;
    QVERIFY(console.model.conditions().empty());
    QVERIFY(console.model.ventilator() == VentilatorSettings{});
    QVERIFY(!console.model.canUndo());
    QVERIFY(console.model.travellingText().isEmpty());
    QVERIFY(console.model.obstacle().isEmpty());
}

void TestRespirationModel::changesAllStationsAndUndoesEach()
{
    constexpr StationId kRoom{1};
    Console console;
    console.node.addStation("Room 5");
    const auto at = [&](StationId station) {
        const auto state = console.node.state();
        const auto& respiration = state->stations().at(station).respiration;
        return respiration.settingsAt(SessionTime::max()).position;
    };
    console.model.setPosition(BodyPosition::Prone);
    console.settle();
    console.model.setForAll(true);
    console.model.setPosition(BodyPosition::LeftLateral);
    console.settle();
    QCOMPARE(at(FakeSessionNode::kStation), BodyPosition::LeftLateral);
    QCOMPARE(at(kRoom), BodyPosition::LeftLateral);
    console.model.undo();
    console.settle();
    QCOMPARE(at(FakeSessionNode::kStation), BodyPosition::Prone);
    QCOMPARE(at(kRoom), BodyPosition::Supine);
    console.model.setForAll(false);
    console.model.setStation(kRoom);
    QCOMPARE(console.model.position(), BodyPosition::Supine);
    QVERIFY(console.model.canUndo()); // what is of the other station
    console.model.setPosition(BodyPosition::RightLateral);
    console.settle();
    QCOMPARE(at(FakeSessionNode::kStation), BodyPosition::Prone);
    QCOMPARE(at(kRoom), BodyPosition::RightLateral);
    console.model.undo();
    console.settle();
    QCOMPARE(at(FakeSessionNode::kStation), BodyPosition::Prone);
    QCOMPARE(at(kRoom), BodyPosition::Supine);
    console.model.undo();
    console.settle();
    QCOMPARE(at(FakeSessionNode::kStation), BodyPosition::Supine);
}

/// At what it was dragged to last, which is undone as any other.
void TestRespirationModel::endsADragThatAnotherStationInterrupts()
{
    Console console;
    console.node.addStation("Room 5");
    console.node.hostGoesAway();
    for (const double severity : {0.1, 0.2, 0.3})
        console.model.setCondition(0, {ConditionKind::Asthma, severity, {}});
    console.model.setStation(StationId{1});
    console.node.hostComesBack();
    console.settle();
    QCOMPARE(only(console.decided().conditions).severity, 0.3);
    console.model.undo();
    console.settle();
    QVERIFY(console.decided().conditions.empty());
    QVERIFY(console.model.conditions().empty());
}

void TestRespirationModel::setsAndTellsWhatTravels()
{
    Console console;
    console.model.setCondition(0, kRightPneumothorax);
    QVERIFY(only(console.model.conditions()) == kRightPneumothorax);
    QCOMPARE(console.model.inForceText(), QStringLiteral("Normal")); // until it has travelled
    QCOMPARE(console.model.travellingText(),
             QStringLiteral("Condition → Pneumothorax, simple, right lung, severity\u00a00.40"));
    VentilatorSettings ventilator;
    ventilator.mode = VentilationMode::VolumeControl;
    ventilator.peep = cmH2O(8.0);
    console.model.setVentilator(ventilator);
    console.model.setPosition(BodyPosition::LeftLateral);
    QCOMPARE(console.model.position(), BodyPosition::LeftLateral);
    QCOMPARE(console.model.travellingText().section(QLatin1Char('\n'), 1),
             QStringLiteral("Ventilation → Volume control, PEEP\u00a08\u00a0cmH2O\n"
                            "Position → Left lateral"));
    console.settle();
    QVERIFY(console.model.travellingText().isEmpty());
    QCOMPARE(console.model.inForceText(),
             QStringLiteral("Pneumothorax, simple, right lung, severity\u00a00.40; left lateral"));
    QVERIFY(only(console.decided().conditions) == kRightPneumothorax);
    QVERIFY(console.decided().ventilator == ventilator);
    QCOMPARE(console.decided().position, BodyPosition::LeftLateral);
}

void TestRespirationModel::tellsThatBreathingHasStopped()
{
    Console console;
    console.node.decide(fact::PhaseChanged{SessionPhase::Running});
    console.node.decide(fact::BreathingStopped{true, std::chrono::seconds{10}});
    console.settle();
    console.node.advance(std::chrono::seconds{5});
    QCOMPARE(console.model.inForceText(), QStringLiteral("Normal")); // it stops, but has not yet
    console.node.advance(std::chrono::seconds{6});
    QCOMPARE(console.model.inForceText(), QStringLiteral("Own breathing has stopped"));
    console.model.setCondition(0, kRightPneumothorax);
    console.settle();
    QCOMPARE(console.model.inForceText(),
             QStringLiteral("Pneumothorax, simple, right lung, severity\u00a00.40; own breathing "
                            "has stopped"));
}

void TestRespirationModel::choosesAConditionWithASeverityToBeSeen()
{
    Console console;
    console.model.choose(0, ConditionKind::Copd);
    QVERIFY(only(console.model.conditions())
            == (LungCondition{ConditionKind::Copd, 0.5, ConditionSide::Both}));
    console.settle();
    console.model.setCondition(0, {ConditionKind::Copd, 0.8, ConditionSide::Both});
    console.settle();
    console.model.choose(0, ConditionKind::Atelectasis);
    console.settle();
    QVERIFY(only(console.model.conditions())
            == (LungCondition{ConditionKind::Atelectasis, 0.8, ConditionSide::Right}));
    console.model.setCondition(0, {ConditionKind::Atelectasis, 0.8, ConditionSide::Left});
    console.settle();
    for (const ConditionKind one :
         {ConditionKind::SimplePneumothorax, ConditionKind::TensionPneumothorax,
          ConditionKind::MainstemIntubation}) {
        console.model.choose(0, one);
        console.settle();
        QVERIFY(only(console.model.conditions()) == (LungCondition{one, 0.8, ConditionSide::Left}));
    }
    console.model.choose(0, ConditionKind::Ards);
    console.settle();
    QCOMPARE(only(console.model.conditions()).side, ConditionSide::Both);
    console.model.choose(0, ConditionKind::Normal);
    console.settle();
    QVERIFY(console.model.conditions().empty());
}

void TestRespirationModel::putsATubeIntoOneBronchus()
{
    Console console;
    console.model.setCondition(0, {ConditionKind::MainstemIntubation, 0.7, ConditionSide::Both});
    console.settle();
    QVERIFY(only(console.decided().conditions)
            == (LungCondition{ConditionKind::MainstemIntubation, 0.7, ConditionSide::Right}));
}

void TestRespirationModel::keepsOneProposalUnderWayWhileASeverityIsDragged()
{
    Console console;
    console.node.hostGoesAway();
    for (int hundredths = 1; hundredths <= 40; ++hundredths) {
        console.model.setCondition(0, {ConditionKind::Ards, hundredths / 100.0, {}});
        console.deliver();
    }
    QCOMPARE(console.node.proposed, 1);
    console.model.setPosition(BodyPosition::Prone); // travels beside it
    QCOMPARE(console.node.proposed, 2);
    console.node.hostComesBack();
    console.settle();
    QCOMPARE(console.node.proposed, 3);
    console.settle();
    QCOMPARE(only(console.decided().conditions).severity, 0.4);
    QVERIFY(console.model.travellingText().isEmpty());
}

void TestRespirationModel::doesNotProposeWhatIsAlreadySo()
{
    Console console;
    console.model.choose(0, ConditionKind::Normal);
    console.model.setVentilator({});
    console.model.setPosition(BodyPosition::Supine);
    QCOMPARE(console.node.proposed, 0);
    QVERIFY(!console.model.canUndo());
}

void TestRespirationModel::undoesADragAtOnceAndThenWhatWasBefore()
{
    Console console;
    VentilatorSettings ventilator;
    ventilator.mode = VentilationMode::PressureControl;
    console.model.setVentilator(ventilator);
    console.settle();
    console.node.hostGoesAway();
    for (const double severity : {0.1, 0.2, 0.3})
        console.model.setCondition(0, {ConditionKind::Asthma, severity, {}});
    console.node.hostComesBack();
    console.settle();
    console.settle();
    console.model.undo();
    console.settle();
    QVERIFY(console.model.conditions().empty());
    QVERIFY(console.model.ventilator() == ventilator);
    console.model.undo();
    console.settle();
    QVERIFY(console.model.ventilator() == VentilatorSettings{});
    QVERIFY(!console.model.canUndo());
    console.model.undo();
    QVERIFY(console.model.ventilator() == VentilatorSettings{});
}

void TestRespirationModel::givesUpWhatTheHostRefuses()
{
    Console console;
    VentilatorSettings ventilator;
    ventilator.peep = cmH2O(80.0);
    console.model.setVentilator(ventilator);
    console.settle();
    QVERIFY(console.model.ventilator() == VentilatorSettings{});
    QVERIFY(console.model.travellingText().isEmpty());
    QVERIFY(!console.model.canUndo());
}

/// What was refused came to nothing.
void TestRespirationModel::undoesWhatCameBeforeWhatTheHostRefuses()
{
    Console console;
    VentilatorSettings ventilator;
    ventilator.peep = cmH2O(8.0);
    console.model.setVentilator(ventilator);
    console.settle();
    VentilatorSettings impossible = ventilator;
    impossible.peep = cmH2O(80.0);
    console.model.setVentilator(impossible);
    console.settle();
    QVERIFY(console.model.ventilator() == ventilator);
    QVERIFY(console.model.canUndo());
    console.model.undo();
    console.settle();
    QVERIFY(console.model.ventilator() == VentilatorSettings{});
    QVERIFY(!console.model.canUndo());
}

void TestRespirationModel::undoesNotWhatSomebodyDecidedSince()
{
    Console console;
    ChangeHistory history;
    console.model.setHistory(history);
    console.model.setPosition(BodyPosition::Prone);
    console.settle();
    console.model.setCondition(0, {ConditionKind::Asthma, 0.3, {}});
    console.settle();
    console.node.decide(fact::LungConditionsSet{{kRightPneumothorax}}); // by another
    console.settle();
    QCOMPARE(history.texts(), QStringList{QStringLiteral("Position → Prone")});
    history.undo(2);
    console.settle();
    QVERIFY(only(console.decided().conditions) == kRightPneumothorax);
    QCOMPARE(console.decided().position, BodyPosition::Supine);
}

void TestRespirationModel::followsAnotherInstructor()
{
    Console console;
    QSignalSpy changes{&console.model, &RespirationModel::changed};
    console.node.decide(fact::LungConditionsSet{{kRightPneumothorax}});
    console.settle();
    QVERIFY(only(console.model.conditions()) == kRightPneumothorax);
    QCOMPARE(changes.size(), 1);
    console.settle();
    QCOMPARE(changes.size(), 1);
}

void TestRespirationModel::letsOnlyAnInstructorChange()
{
    Console console{FakeSessionNode::kObserver};
    QVERIFY(!console.model.obstacle().isEmpty());
    console.model.choose(0, ConditionKind::Copd);
    console.model.setPosition(BodyPosition::Prone);
    QCOMPARE(console.node.proposed, 0);
}

void TestRespirationModel::changesNothingAfterTheEnd()
{
    Console console;
    console.node.decide(fact::PhaseChanged{SessionPhase::Running});
    console.settle();
    console.node.decide(fact::PhaseChanged{SessionPhase::Ended});
    console.settle();
    console.model.choose(0, ConditionKind::Copd);
    QCOMPARE(console.node.proposed, 0);
}

void TestRespirationModel::hasAWordForEverything()
{
    std::set<QString> words;
    for (const ConditionKind kind : kConditionKinds)
        words.insert(conditionText(kind));
    for (const ConditionSide side :
         {ConditionSide::Both, ConditionSide::Right, ConditionSide::Left})
        words.insert(sideText(side));
    for (const VentilationMode mode : {VentilationMode::Spontaneous, VentilationMode::VolumeControl,
                                       VentilationMode::PressureControl})
        words.insert(modeText(mode));
    for (const BodyPosition position : kBodyPositions)
        words.insert(positionText(position));
    QCOMPARE(words.size(), std::size_t{21});
    QVERIFY(!words.contains(QString{}));
    QCOMPARE(conditionText(LungCondition{}), QStringLiteral("Normal"));
    QCOMPARE(ventilatorText({}), QStringLiteral("Spontaneous"));
    VentilatorSettings pressure;
    pressure.mode = VentilationMode::PressureControl;
    pressure.drivingPressure = cmH2O(14.0);
    QCOMPARE(ventilatorText(pressure),
             QStringLiteral("Pressure control, PEEP\u00a05\u00a0cmH2O, 14\u00a0cmH2O above it"));
}

CARINA_TEST(TestRespirationModel)

} // namespace carina::respiration_model_test

#include "tst_respiration_model.moc"
