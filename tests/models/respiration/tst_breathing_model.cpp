#include "models/respiration/breathing_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::breathing_model_test
{

using test::FakeSessionNode;
using enum BreathingParameter;

class TestBreathingModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsTheValuesInForce();
    void setsAndTellsWhatTravels_data();
    void setsAndTellsWhatTravels();
    void keepsOneProposalUnderWayWhileASliderIsDragged();
    void doesNotProposeWhatIsAlreadySo();
    void undoesAWholeDragAtOnce();
    void undoesStepByStep();
    void givesUpWhatTheHostRefuses();
    void followsAnotherInstructor();
    void signalsOnlyWhatChanged();
    void boundsABreathByThePatient();
    void goesToAnotherStation();
    void endsADragThatAnotherStationInterrupts();
    void keepsAChangeApartFromThatOfAnotherStation();
    void changesAllStationsByOneFact();
    void undoesAtEachStationWhatWasThere();
    void leavesTheOtherValueOfEachBag();
    void undoesNotWhatSomebodyDecidedSince();
    void undoesWhereNobodyDecidedSince();
    void undoesNotWhatTheHostRefused();
    void takesBackAStopAtOnce();
    void boundsABreathByAllPatients();
    void stopsOverATimeAndGoesOn();
};

namespace
{

constexpr StationId kRoom{1};
constexpr double kTolerance = 1e-9; ///< of the unit shown
constexpr std::chrono::milliseconds kLead{100};

struct Console {
    FakeSessionNode node;
    SessionModel session{node};
    BreathingModel breathing{session, FakeSessionNode::kStation};

    /// What the node announced reaches the models.
    void deliver()
    {
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    /// Whatever was decided takes effect.
    void settle()
    {
        node.advance(kLead);
        deliver();
    }
    [[nodiscard]] double rate() const { return breathing.value(Rate); }
    [[nodiscard]] double rateAt(StationId station) const
    {
        const auto state = node.state();
        const auto& respiration = state->stations().at(station).respiration;
        return inPerMinute(respiration.settingsAt(SessionTime::max()).pattern.rate);
    }
};

#define COMPARE_NEAR(actual, expected)                                                             \
    QVERIFY2(std::abs((actual) - (expected)) <= kTolerance, qPrintable(QString::number(actual)))

} // namespace

void TestBreathingModel::showsTheValuesInForce()
{
    Console console;
    const BreathingPattern pattern;
    COMPARE_NEAR(console.rate(), inPerMinute(pattern.rate));
    COMPARE_NEAR(console.breathing.value(TidalVolume), inMillilitres(pattern.tidalVolume));
    COMPARE_NEAR(console.breathing.value(Expiration), 0.5875 / 0.4125);
    QVERIFY(!console.breathing.canUndo());
    QVERIFY(console.breathing.travellingText().isEmpty());
}

void TestBreathingModel::setsAndTellsWhatTravels_data()
{
    QTest::addColumn<int>("parameter");
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("rate") << int(Rate) << 24.0 << QStringLiteral("Breathing rate → 24\u00a0/min");
    QTest::newRow("tidal volume") << int(TidalVolume) << 450.0
                                  << QStringLiteral("Tidal volume → 450\u00a0ml");
    QTest::newRow("expiration") << int(Expiration) << 3.0
                                << QStringLiteral("Inspiration : expiration → 1 : 3.00");
    QTest::newRow("apnoea") << int(Own) << 0.0 << QStringLiteral("Breathing → stops");
    QTest::newRow("bag") << int(BagRate) << 10.0 << QStringLiteral("Bag by hand → 10\u00a0/min");
    QTest::newRow("volume of the bag")
        << int(BagVolume) << 450.0 << QStringLiteral("Volume of the bag → 450\u00a0ml");
}

// What is left is what a console shows meanwhile; what others decide in between replaces the rest.
void TestBreathingModel::stopsOverATimeAndGoesOn()
{
    Console console;
    console.node.decide(fact::PhaseChanged{SessionPhase::Running});
    console.breathing.setStoppingTime(std::chrono::seconds{20});
    console.breathing.set(Own, 0.0);
    console.settle();
    COMPARE_NEAR(console.breathing.value(Own), 0.0); // decided
    console.node.advance(std::chrono::seconds{10});
    QVERIFY(std::abs(console.breathing.ownBreathing() - 0.5) < 0.06);
    console.breathing.setStoppingTime(std::chrono::seconds{4});
    console.breathing.set(Own, 1.0);
    console.settle();
    console.node.advance(std::chrono::seconds{2});
    QVERIFY(std::abs(console.breathing.ownBreathing() - 0.75) < 0.15);
    console.node.advance(std::chrono::seconds{15});
    COMPARE_NEAR(console.breathing.ownBreathing(), 1.0);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.breathing.value(Own), 0.0);
}

void TestBreathingModel::setsAndTellsWhatTravels()
{
    QFETCH(const int, parameter);
    QFETCH(const double, value);
    QFETCH(const QString, text);
    Console console;
    const auto which = BreathingParameter(parameter);
    const double before = console.breathing.value(which);
    console.breathing.set(which, value);
    COMPARE_NEAR(console.breathing.value(which), before);
    QVERIFY(console.breathing.pending(which) == value);
    QCOMPARE(console.breathing.travellingText(), text);
    console.settle();
    COMPARE_NEAR(console.breathing.value(which), value);
    QVERIFY(!console.breathing.pending(which));
    QVERIFY(console.breathing.travellingText().isEmpty());
}

void TestBreathingModel::keepsOneProposalUnderWayWhileASliderIsDragged()
{
    Console console;
    console.node.hostGoesAway();
    for (int rate = 20; rate <= 40; ++rate) {
        console.breathing.set(Rate, rate);
        console.deliver();
    }
    QCOMPARE(console.node.proposed, 1);
    QVERIFY(console.breathing.pending(Rate) == 40.0);
    console.breathing.set(TidalVolume, 500.0); // travels beside it
    QCOMPARE(console.node.proposed, 2);
    console.node.hostComesBack();
    console.settle();
    QCOMPARE(console.node.proposed, 3);
    console.settle();
    COMPARE_NEAR(console.rate(), 40.0);
    COMPARE_NEAR(console.breathing.value(TidalVolume), 500.0);
    QVERIFY(!console.breathing.pending(Rate));
}

void TestBreathingModel::doesNotProposeWhatIsAlreadySo()
{
    Console console;
    console.breathing.set(Rate, console.rate());
    QCOMPARE(console.node.proposed, 0);
    QVERIFY(!console.breathing.canUndo());
}

void TestBreathingModel::undoesAWholeDragAtOnce()
{
    Console console;
    const double before = console.rate();
    for (int rate = 20; rate <= 30; ++rate)
        console.breathing.set(Rate, rate);
    console.settle();
    console.settle();
    COMPARE_NEAR(console.rate(), 30.0);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rate(), before);
    QVERIFY(!console.breathing.canUndo());
    console.breathing.undo(); // harmless
}

void TestBreathingModel::undoesStepByStep()
{
    Console console;
    console.breathing.set(Rate, 25.0);
    console.settle();
    console.breathing.set(TidalVolume, 500.0);
    console.settle();
    console.breathing.set(Rate, 30.0);
    console.settle();
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rate(), 25.0);
    COMPARE_NEAR(console.breathing.value(TidalVolume), 500.0);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.breathing.value(TidalVolume),
                 inMillilitres(BreathingPattern{}.tidalVolume));
    QVERIFY(console.breathing.canUndo());
}

void TestBreathingModel::givesUpWhatTheHostRefuses()
{
    Console console;
    const double before = console.rate();
    console.breathing.set(Rate, 500.0);
    console.settle();
    QVERIFY(!console.breathing.pending(Rate));
    COMPARE_NEAR(console.rate(), before);
    console.breathing.set(Rate, 30.0);
    console.settle();
    COMPARE_NEAR(console.rate(), 30.0);
}

void TestBreathingModel::followsAnotherInstructor()
{
    Console console;
    console.breathing.set(Rate, 25.0);
    console.node.decide(fact::BreathingRateSet{perMinute(35.0)}); // overtakes it
    console.settle();
    COMPARE_NEAR(console.rate(), 35.0);
    QVERIFY(!console.breathing.pending(Rate));
}

void TestBreathingModel::signalsOnlyWhatChanged()
{
    Console console;
    console.deliver();
    QSignalSpy changes{&console.breathing, &BreathingModel::changed};
    console.deliver();
    QCOMPARE(changes.count(), 0);
    console.node.decide(fact::BreathingRateSet{perMinute(35.0)});
    console.deliver();
    console.settle();
    QVERIFY(changes.count() >= 1);
}

/// 25 ml/kg, and no more than anybody may be set to.
void TestBreathingModel::boundsABreathByThePatient()
{
    Console console;
    QCOMPARE(console.breathing.largestTidalVolume_ml(), 1000); // the child of 40 kg
    console.node.decide(fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    QCOMPARE(console.breathing.largestTidalVolume_ml(), 1925);
    console.node.decide(fact::PatientBuildSet{{metres(2.1), 110.0, 40.0, Sex::Male}});
    QCOMPARE(console.breathing.largestTidalVolume_ml(), 2000);
}

void TestBreathingModel::goesToAnotherStation()
{
    Console console;
    console.node.addStation("Room 5");
    console.breathing.set(Rate, 25.0);
    console.settle();
    QVERIFY(console.breathing.canUndo());
    QSignalSpy changes{&console.breathing, &BreathingModel::changed};
    console.breathing.setStation(kRoom);
    QVERIFY(changes.count() >= 1);
    COMPARE_NEAR(console.rate(), inPerMinute(BreathingPattern{}.rate));
    QVERIFY(console.breathing.canUndo()); // what is of the other station
    console.breathing.set(Rate, 33.0);
    console.settle();
    COMPARE_NEAR(console.rate(), 33.0);
    console.breathing.setStation(FakeSessionNode::kStation);
    COMPARE_NEAR(console.rate(), 25.0);
    const double before = inPerMinute(BreathingPattern{}.rate);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rateAt(kRoom), before);
    COMPARE_NEAR(console.rate(), 25.0);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rate(), before);
    QVERIFY(!console.breathing.canUndo());
}

/// At what it was dragged to last, which is undone as any other.
void TestBreathingModel::endsADragThatAnotherStationInterrupts()
{
    Console console;
    console.node.addStation("Room 5");
    const double before = console.rate();
    console.node.hostGoesAway();
    console.breathing.set(Rate, 20.0);
    console.breathing.set(Rate, 40.0);
    console.breathing.setStation(kRoom);
    console.node.hostComesBack();
    console.settle();
    COMPARE_NEAR(console.rateAt(FakeSessionNode::kStation), 40.0);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rateAt(FakeSessionNode::kStation), before);
    COMPARE_NEAR(console.rate(), before);
}

/// Also while what was just taken back is on its way.
void TestBreathingModel::keepsAChangeApartFromThatOfAnotherStation()
{
    Console console;
    console.node.addStation("Room 5");
    const double before = console.rate();
    console.breathing.setStation(kRoom);
    console.breathing.set(Rate, 20.0);
    console.settle();
    console.breathing.setStation(FakeSessionNode::kStation);
    console.breathing.set(Rate, 22.0);
    console.settle();
    console.breathing.undo();
    console.breathing.set(Rate, 24.0);
    console.settle();
    console.settle();
    COMPARE_NEAR(console.rate(), 24.0);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rate(), before);
    COMPARE_NEAR(console.rateAt(kRoom), 20.0);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rateAt(kRoom), before);
}

void TestBreathingModel::changesAllStationsByOneFact()
{
    Console console;
    console.node.addStation("Room 5");
    console.breathing.setForAll(true);
    const FactNumber before = console.node.state()->lastApplied();
    console.breathing.set(Rate, 25.0);
    QCOMPARE(console.node.state()->lastApplied().value, before.value + 1);
    QVERIFY(console.breathing.pending(Rate));
    console.settle();
    COMPARE_NEAR(console.rate(), 25.0);
    COMPARE_NEAR(console.rateAt(kRoom), 25.0);
    console.breathing.setForAll(false);
    console.breathing.set(Rate, 30.0);
    console.settle();
    COMPARE_NEAR(console.rate(), 30.0);
    COMPARE_NEAR(console.rateAt(kRoom), 25.0);
    console.breathing.setForAll(true);
    console.breathing.set(Rate, 30.0); // so here, and not there
    console.settle();
    COMPARE_NEAR(console.rateAt(kRoom), 30.0);
}

void TestBreathingModel::undoesAtEachStationWhatWasThere()
{
    Console console;
    console.node.addStation("Room 5");
    console.breathing.set(Rate, 22.0);
    console.settle();
    console.breathing.setForAll(true);
    console.breathing.set(Rate, 30.0);
    console.settle();
    COMPARE_NEAR(console.rateAt(kRoom), 30.0);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rate(), 22.0);
    COMPARE_NEAR(console.rateAt(kRoom), inPerMinute(BreathingPattern{}.rate));
}

// One fact has both values of a bag: rate and volume are changed at each station for itself.
void TestBreathingModel::leavesTheOtherValueOfEachBag()
{
    Console console;
    console.node.addStation("Room 5");
    const auto bagAt = [&console](StationId station) {
        const auto state = console.node.state();
        return state->stations().at(station).respiration.settingsAt(SessionTime::max()).bag;
    };
    const HandBag there{perMinute(12.0), millilitres(350.0)};
    console.node.decideAt(kRoom, fact::BagSqueezed{there});
    console.settle();
    const HandBag here = bagAt(FakeSessionNode::kStation);
    COMPARE_NEAR(inPerMinute(here.rate), 0.0); // none here
    console.breathing.setForAll(true);
    console.breathing.set(BagVolume, 420.0);
    console.settle();
    for (const StationId station : {FakeSessionNode::kStation, kRoom})
        COMPARE_NEAR(inMillilitres(bagAt(station).tidalVolume), 420.0);
    COMPARE_NEAR(inPerMinute(bagAt(kRoom).rate), 12.0); // it is squeezed as before
    COMPARE_NEAR(inPerMinute(bagAt(FakeSessionNode::kStation).rate), 0.0);
    console.breathing.undo();
    console.settle();
    for (const auto& [station, bag] :
         {std::pair{kRoom, there}, std::pair{FakeSessionNode::kStation, here}}) {
        COMPARE_NEAR(inPerMinute(bagAt(station).rate), inPerMinute(bag.rate));
        COMPARE_NEAR(inMillilitres(bagAt(station).tidalVolume), inMillilitres(bag.tidalVolume));
    }
    console.node.hostGoesAway(); // both are on their way at once
    console.breathing.set(BagRate, 10.0);
    console.breathing.set(BagVolume, 500.0);
    console.node.hostComesBack();
    console.settle();
    for (const StationId station : {FakeSessionNode::kStation, kRoom}) {
        COMPARE_NEAR(inPerMinute(bagAt(station).rate), 10.0);
        COMPARE_NEAR(inMillilitres(bagAt(station).tidalVolume), 500.0);
    }
}

void TestBreathingModel::undoesNotWhatSomebodyDecidedSince()
{
    Console console;
    ChangeHistory history;
    console.breathing.setHistory(history);
    console.breathing.set(TidalVolume, 400.0);
    console.settle();
    console.breathing.set(Rate, 25.0);
    console.settle();
    console.breathing.set(Rate, 27.0);
    console.settle();
    QCOMPARE(history.texts().size(), 3);
    console.node.decide(fact::BreathingRateSet{perMinute(35.0)}); // by another
    console.settle();
    QCOMPARE(history.texts(), QStringList{QStringLiteral("Tidal volume → 400\u00a0ml")});
    history.undo(3);
    console.settle();
    COMPARE_NEAR(console.rate(), 35.0);
    COMPARE_NEAR(console.breathing.value(TidalVolume),
                 inMillilitres(BreathingPattern{}.tidalVolume));
}

void TestBreathingModel::undoesWhereNobodyDecidedSince()
{
    Console console;
    console.node.addStation("Room 5");
    const double before = console.rate();
    console.breathing.setForAll(true);
    console.breathing.set(Rate, 30.0);
    console.settle();
    console.node.decideAt(kRoom, fact::BreathingRateSet{perMinute(14.0)});
    console.settle();
    QVERIFY(console.breathing.canUndo());
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.rate(), before);
    COMPARE_NEAR(console.rateAt(kRoom), 14.0);
}

void TestBreathingModel::undoesNotWhatTheHostRefused()
{
    Console console;
    ChangeHistory history;
    console.breathing.setHistory(history);
    console.breathing.set(Rate, 500.0);
    QVERIFY(console.breathing.canUndo()); // it is on its way
    console.settle();
    QVERIFY(!console.breathing.canUndo());
    QVERIFY(history.isEmpty());
}

void TestBreathingModel::takesBackAStopAtOnce()
{
    Console console;
    console.node.decide(fact::PhaseChanged{SessionPhase::Running});
    console.breathing.setStoppingTime(std::chrono::minutes{5});
    console.breathing.set(Own, 0.0);
    console.settle();
    console.node.advance(std::chrono::minutes{4});
    QVERIFY(console.breathing.ownBreathing() < 0.3);
    console.breathing.undo();
    console.settle();
    COMPARE_NEAR(console.breathing.value(Own), 1.0);
    COMPARE_NEAR(console.breathing.ownBreathing(), 1.0);
}

void TestBreathingModel::boundsABreathByAllPatients()
{
    Console console;
    console.node.addStation("Room 5");
    console.node.decide(fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    QCOMPARE(console.breathing.largestTidalVolume_ml(), 1925);
    console.breathing.setForAll(true);
    QCOMPARE(console.breathing.largestTidalVolume_ml(), 1000); // the child in room 5
}

CARINA_TEST(TestBreathingModel)

} // namespace carina::breathing_model_test

#include "tst_breathing_model.moc"
