#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/session/respiration/respiration_rules.h"
#include "models/physiology/drug_words.h"
#include "models/physiology/gas_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <cmath>
#include <set>

namespace carina::gas_model_test
{

using test::FakeSessionNode;

class TestGasModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsWhatIsInForce();
    void setsAndTellsWhatTravels();
    void undoesGasAndCuff();
    void obstructsTheTubeThatThereIs();
    void changesAllStationsAndUndoesEach();
    void givesByTheWeightOfEachPatient();
    void offersNoMoreThanAllCanBeGiven();
    void listsWhatWasGivenLately();
    void tellsWhereTheTubeIsAndWhatOverridesIt();
    void setsWhereTheTubeIs();
    void proposesTheSizeOfTheTubeThatThereIs();
    void drawsTheStyletOfATubeThatIsFollowed();
    void letsOnlyAnInstructorChangeGasAndGiveDrugs();
    void letsWhoIsAtTheStationHandleTheTube();
    void hasAWordForEverything();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};
constexpr StationId kRoom{1};
constexpr GasSupply kPreoxygenation{1.0, true, true};

struct Console {
    FakeSessionNode node;
    SessionModel session{node};
    GasModel model{session, FakeSessionNode::kStation};

    explicit Console(ParticipantId self = FakeSessionNode::kInstructor) : node{self} {}
    void settle()
    {
        node.advance(kLead);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] GasSupply decidedAt(StationId station) const
    {
        return node.state()->stations().at(station).respiration.gasAt(SessionTime::max());
    }
    [[nodiscard]] std::vector<DrugDose> dosesAt(StationId station) const
    {
        const auto state = node.state();
        std::vector<DrugDose> doses;
        for (const GivenDose& given : state->stations().at(station).respiration.dosesWithin(
                 SessionTime::min(), SessionTime::max()))
            doses.push_back(given.dose);
        return doses;
    }
    void note(IntubationStep step, TubeSeat seat)
    {
        node.decide(fact::IntubationNoted{{.step = step, .at = *node.now(), .seat = seat}, {}});
        settle();
    }
};

} // namespace

void TestGasModel::showsWhatIsInForce()
{
    Console console;
    QVERIFY(console.model.gas() == GasSupply{});
    QVERIFY(!console.model.isCuffInflated());
    QVERIFY(!console.model.hasStylet());
    QVERIFY(!console.model.canUndo());
    QCOMPARE(console.model.weight_kg(), 40.0);
    QVERIFY(console.model.givenText().isEmpty());
    QVERIFY(console.model.tubeText().isEmpty());
    QVERIFY(console.model.travellingText().isEmpty());
    QVERIFY(console.model.obstacle().isEmpty());
}

void TestGasModel::setsAndTellsWhatTravels()
{
    Console console;
    QSignalSpy changed{&console.model, &GasModel::changed};
    console.model.setGas(kPreoxygenation);
    QVERIFY(console.model.gas() == kPreoxygenation);
    QCOMPARE(console.model.travellingText(),
             QStringLiteral("Gas → oxygen 100\u00a0%, mask held, probe on"));
    console.settle();
    QVERIFY(console.decidedAt(FakeSessionNode::kStation) == kPreoxygenation);
    QVERIFY(console.model.travellingText().isEmpty());
    QVERIFY(!changed.isEmpty());
    console.model.setCuff(true);
    QCOMPARE(console.model.travellingText(), QStringLiteral("Cuff → inflated"));
    console.settle();
    QVERIFY(console.model.isCuffInflated());
}

void TestGasModel::undoesGasAndCuff()
{
    Console console;
    console.model.setGas(kPreoxygenation);
    console.settle();
    console.model.setCuff(true);
    console.settle();
    console.model.undo();
    console.settle();
    QVERIFY(!console.model.isCuffInflated());
    QVERIFY(console.model.gas() == kPreoxygenation);
    console.model.undo();
    console.settle();
    QVERIFY(console.model.gas() == GasSupply{});
    QVERIFY(!console.model.canUndo());
    console.model.give(DrugKind::Propofol, 2.0);
    console.settle();
    QVERIFY(!console.model.canUndo()); // what is in the body stays there
}

void TestGasModel::obstructsTheTubeThatThereIs()
{
    Console console;
    QVERIFY(!console.model.hasTube());
    console.note(IntubationStep::ThroughCords, TubeSeat::Trachea);
    QVERIFY(console.model.hasTube());
    console.model.setObstruction(0.6);
    QCOMPARE(console.model.travellingText(), QStringLiteral("Tube → obstructed by 60\u00a0%"));
    console.settle();
    QCOMPARE(console.model.obstruction(), 0.6);
    const auto state = console.node.state();
    const RespirationTimeline& patient =
        state->stations().at(FakeSessionNode::kStation).respiration;
    QCOMPARE(patient.tubePlaceAt(*console.node.now()).obstruction, 0.6);
    console.model.undo();
    QCOMPARE(console.model.travellingText(), QStringLiteral("Tube → open"));
    console.settle();
    QCOMPARE(console.model.obstruction(), 0.0);
}

void TestGasModel::changesAllStationsAndUndoesEach()
{
    Console console;
    console.node.addStation("Room 5");
    console.node.decideAt(kRoom, fact::GasSupplySet{{0.5, false, true}});
    console.settle();
    console.model.setForAll(true);
    console.model.setGas(kPreoxygenation);
    console.settle();
    QVERIFY(console.decidedAt(FakeSessionNode::kStation) == kPreoxygenation);
    QVERIFY(console.decidedAt(kRoom) == kPreoxygenation);
    console.model.undo();
    console.settle();
    QVERIFY(console.decidedAt(FakeSessionNode::kStation) == GasSupply{});
    QVERIFY(console.decidedAt(kRoom) == (GasSupply{0.5, false, true}));
    console.model.setForAll(false);
    console.model.setStation(kRoom);
    QCOMPARE(console.model.gas().inspiredOxygen, 0.5);
}

void TestGasModel::givesByTheWeightOfEachPatient()
{
    Console console;
    console.node.addStation("Room 5");
    console.node.decideAt(kRoom, fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    console.settle();
    console.model.give(DrugKind::Rocuronium, 0.5);
    console.settle();
    QVERIFY(console.dosesAt(FakeSessionNode::kStation)
            == (std::vector<DrugDose>{{DrugKind::Rocuronium, 20.0}}));
    QVERIFY(console.dosesAt(kRoom).empty());
    console.model.setForAll(true);
    console.model.give(DrugKind::Propofol, 2.0);
    console.settle();
    QCOMPARE(console.dosesAt(FakeSessionNode::kStation).back().milligrams, 80.0);
    QCOMPARE(console.dosesAt(kRoom).back().milligrams, 154.0);
}

void TestGasModel::offersNoMoreThanAllCanBeGiven()
{
    Console console;
    console.node.addStation("Room 5");
    console.node.decideAt(kRoom, fact::PatientBuildSet{{metres(1.75), 80.0, 40.0, Sex::Male}});
    console.settle();
    const double most = mostMilligrams(DrugKind::Sugammadex);
    QCOMPARE(console.model.mostDose_mgPerKg(DrugKind::Sugammadex), most / 40.0);
    console.model.setForAll(true);
    QCOMPARE(console.model.mostDose_mgPerKg(DrugKind::Sugammadex), most / 80.0);
    for (const DrugKind kind : kDrugKinds)
        QVERIFY(usualDose_mgPerKg(kind) < mostMilligrams(kind) / kHeaviestPatient);
}

void TestGasModel::listsWhatWasGivenLately()
{
    Console console;
    console.model.give(DrugKind::Fentanyl, 0.002);
    console.settle();
    console.model.give(DrugKind::Propofol, 2.0);
    console.settle();
    QCOMPARE(console.model.givenText(),
             QStringLiteral("Fentanyl 80\u00a0\u00b5g, Propofol 80\u00a0mg"));
    console.node.advance(GasModel::kShownDoses + kLead);
    QCOMPARE(console.model.givenText(), QString{});
}

void TestGasModel::tellsWhereTheTubeIsAndWhatOverridesIt()
{
    Console console;
    console.note(IntubationStep::InOesophagus, TubeSeat::Oesophagus);
    QCOMPARE(console.model.tubeText(), QStringLiteral("Tube: in the oesophagus, as tracked"));
    console.model.setTube({TubeSeat::Trachea, millimetres(6.5)});
    console.settle();
    QVERIFY(console.model.tubeText().startsWith(QStringLiteral("▲ Tube: in the trachea")));
    QVERIFY(console.model.tubeText().contains(QStringLiteral("as the console sets it")));
}

void TestGasModel::setsWhereTheTubeIs()
{
    Console console;
    const SetTube wrong{TubeSeat::Oesophagus, millimetres(6.5)};
    console.model.setTube(wrong);
    QVERIFY(console.model.tube() == wrong);
    QCOMPARE(console.model.travellingText(),
             QStringLiteral("Tube → in the oesophagus, 6.5\u00a0mm"));
    console.settle();
    const auto place = [&] {
        const auto state = console.node.state();
        return state->stations()
            .at(FakeSessionNode::kStation)
            .respiration.tubePlaceAt(*console.node.now());
    };
    QVERIFY(place() == (TubePlace{TubeSeat::Oesophagus, millimetres(6.5)}));
    console.model.undo();
    QCOMPARE(console.model.travellingText(), QStringLiteral("Tube → as tracked"));
    console.settle();
    QVERIFY(!console.model.tube().isSet());
    QVERIFY(place() == TubePlace{});
    console.model.setTube({TubeSeat::Trachea, millimetres(13.0)}); // which the host refuses
    console.settle();
    QVERIFY(!console.model.tube().isSet());
    QVERIFY(!console.model.canUndo());
}

void TestGasModel::proposesTheSizeOfTheTubeThatThereIs()
{
    Console console;
    const PatientBuild child{metres(1.5), 40.0, 12.0, Sex::Female};
    console.node.decide(fact::PatientBuildSet{child});
    console.settle();
    QCOMPARE(console.model.likelyTubeSize(), usualTube(child.ageInYears, child.sex));
    const IntubationEvent through{
        .step = IntubationStep::ThroughCords, .at = *console.node.now(), .seat = TubeSeat::Trachea};
    console.node.decide(fact::IntubationNoted{through, millimetres(5.5)});
    console.settle();
    QCOMPARE(console.model.likelyTubeSize(), millimetres(5.5));
    console.model.setTube({TubeSeat::Oesophagus, millimetres(6.0)});
    console.settle();
    QCOMPARE(console.model.likelyTubeSize(), millimetres(6.0));
}

void TestGasModel::drawsTheStyletOfATubeThatIsFollowed()
{
    Console console;
    console.note(IntubationStep::ThroughCords, TubeSeat::Trachea);
    QVERIFY(console.model.hasStylet());
    console.model.drawStylet();
    console.settle();
    QVERIFY(!console.model.hasStylet());
    console.note(IntubationStep::TubeOut, TubeSeat::None);
    QVERIFY(console.model.hasStylet());
}

void TestGasModel::letsOnlyAnInstructorChangeGasAndGiveDrugs()
{
    for (const ParticipantId self : {FakeSessionNode::kTrainee, FakeSessionNode::kObserver}) {
        Console console{self};
        const int before = console.node.proposed;
        QVERIFY(!console.model.obstacle().isEmpty());
        console.model.setGas(kPreoxygenation);
        console.model.give(DrugKind::Propofol, 2.0);
        console.model.setTube({TubeSeat::Trachea, millimetres(6.5)});
        console.settle();
        QCOMPARE(console.node.proposed, before);
        QVERIFY(console.model.gas() == GasSupply{});
    }
}

void TestGasModel::letsWhoIsAtTheStationHandleTheTube()
{
    Console observer{FakeSessionNode::kObserver};
    observer.note(IntubationStep::ThroughCords, TubeSeat::Trachea);
    const int before = observer.node.proposed;
    QVERIFY(!observer.model.obstacleToTube().isEmpty());
    observer.model.setCuff(true);
    observer.model.drawStylet();
    QCOMPARE(observer.node.proposed, before);
    QVERIFY(!observer.model.isCuffInflated());

    Console trainee{FakeSessionNode::kTrainee};
    trainee.note(IntubationStep::ThroughCords, TubeSeat::Trachea);
    QVERIFY(trainee.model.obstacleToTube().isEmpty());
    trainee.model.setCuff(true);
    trainee.model.drawStylet();
    trainee.settle();
    QVERIFY(trainee.model.isCuffInflated());
    QVERIFY(!trainee.model.hasStylet());
}

void TestGasModel::hasAWordForEverything()
{
    std::set<QString> words;
    for (const DrugKind kind : kDrugKinds) {
        words.insert(drugText(kind));
        QVERIFY(usualDose_mgPerKg(kind) > 0.0);
    }
    QCOMPARE(words.size(), kDrugKinds.size());
    words.clear();
    for (const TubeSeat seat : kTubeSeats)
        words.insert(seatText(seat));
    QCOMPARE(words.size(), kTubeSeats.size());
    QVERIFY(!words.contains(QString{}));
    QCOMPARE(doseText({DrugKind::Fentanyl, 0.15}), QStringLiteral("Fentanyl 150\u00a0\u00b5g"));
    QVERIFY(gasText({0.21, false, false}).contains(QStringLiteral("21\u00a0%")));
}

CARINA_TEST(TestGasModel)

} // namespace carina::gas_model_test

#include "tst_gas_model.moc"
