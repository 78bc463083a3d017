#include "apps/instructor/intubation_assistant.h"

#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::intubation_assistant_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

constexpr Duration kTakesEffect = 500ms; ///< more than decision and answer take together

/// A console in a running session, with a trainee at work.
struct Console {
    explicit Console(MotionKind kind = MotionKind::Good)
        : assistant{node, FakeSessionNode::kStation, {.kind = kind}}
    {
    }

    FakeSessionNode node{FakeSessionNode::kInstructor};
    IntubationAssistant assistant;

    void goOn(Duration time)
    {
        const SessionTime until = *node.now() + time;
        while (*node.now() < until) {
            node.advance(100ms);
            assistant.look();
        }
    }
    void run()
    {
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        goOn(kTakesEffect);
    }
    void note(IntubationStep step)
    {
        node.decide(fact::IntubationNoted{.event = {.step = step, .at = *node.now()}},
                    FakeSessionNode::kTrainee);
        goOn(kTakesEffect);
    }
    [[nodiscard]] const Station& station()
    {
        m_state = node.state();
        return m_state->stations().at(FakeSessionNode::kStation);
    }
    [[nodiscard]] bool isMaskHeld()
    {
        const GasSupply gas = station().respiration.gasAt(*node.now());
        return gas.maskHeld && gas.inspiredOxygen == 1.0;
    }
    [[nodiscard]] bool isBagSqueezed()
    {
        return station().respiration.settingsAt(*node.now()).bag.rate > Frequency{};
    }
    [[nodiscard]] std::size_t doses()
    {
        return station().respiration.dosesWithin(SessionTime{}, *node.now() + 1s).size();
    }

private:
    std::shared_ptr<const SessionState> m_state;
};

} // namespace

class TestIntubationAssistant : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void waitsForTheSession()
    {
        Console console;
        console.goOn(30s);
        QCOMPARE(console.node.proposed, 0);
        console.run();
        QVERIFY(console.isMaskHeld());
    }

    void givesOxygenFirstAndThenDrugsAndBag()
    {
        Console console;
        console.run();
        console.goOn(IntubationAssistant::kPreoxygenation - 1s);
        QCOMPARE(console.doses(), 0U);
        QVERIFY(!console.isBagSqueezed());
        console.goOn(1s + kTakesEffect);
        QCOMPARE(console.doses(), 3U);
        QVERIFY(console.isBagSqueezed());
        QVERIFY(console.isMaskHeld());
    }

    void makesWayForTheBlade()
    {
        Console console;
        console.run();
        console.goOn(20s);
        console.note(IntubationStep::BladeIn);
        QVERIFY(!console.isBagSqueezed());
        QVERIFY(!console.isMaskHeld());
        console.goOn(30s);
        QCOMPARE(console.doses(), 3U); // once
    }

    void squeezesTheBagThroughATubeWithACuff()
    {
        Console console;
        console.run();
        console.goOn(20s);
        console.note(IntubationStep::BladeIn);
        console.note(IntubationStep::ThroughCords);
        console.goOn(5s);
        QVERIFY(!console.isBagSqueezed());
        console.note(IntubationStep::CuffInflated);
        console.goOn(1s);
        QVERIFY(!console.isBagSqueezed());
        console.goOn(2s);
        QVERIFY(console.isBagSqueezed());
        console.note(IntubationStep::TubeOut);
        QVERIFY(!console.isBagSqueezed());
    }

    void hearsEachNoteOnceAlsoOfATubeThatRestsAgain()
    {
        Console console;
        console.run();
        console.note(IntubationStep::BladeIn);
        console.note(IntubationStep::CuffInflated);
        console.note(IntubationStep::AtRest);
        console.goOn(3s);
        QVERIFY(console.isBagSqueezed());
        console.goOn(1s);
        console.note(IntubationStep::AtRest);
        QVERIFY(console.isBagSqueezed()); // BladeIn would rest it
    }

    void givesNoDrugsOnceTheBladeIsIn()
    {
        Console console;
        console.run();
        console.note(IntubationStep::BladeIn);
        console.goOn(30s);
        QCOMPARE(console.doses(), 0U);
    }

    void flexesTheNeckWhereTheScriptDoes_data()
    {
        QTest::addColumn<MotionKind>("kind");
        QTest::addColumn<bool>("flexes");
        QTest::newRow("neck_flexed") << MotionKind::NeckFlexed << true;
        QTest::newRow("good") << MotionKind::Good << false;
    }
    void flexesTheNeckWhereTheScriptDoes()
    {
        QFETCH(const MotionKind, kind);
        QFETCH(const bool, flexes);
        Console console{kind};
        console.run();
        console.note(IntubationStep::FirstBreath);
        console.goOn(IntubationAssistant::kToFlexion - 1s);
        QCOMPARE(headPositionAt(console.station(), *console.node.now()).flexion.si, 0.0);
        console.goOn(IntubationAssistant::kFlexes + 1s + kTakesEffect);
        QCOMPARE(headPositionAt(console.station(), *console.node.now()).flexion > degrees(10.0),
                 flexes);
    }
};

CARINA_TEST(TestIntubationAssistant)

} // namespace carina::intubation_assistant_test

#include "tst_intubation_assistant.moc"
