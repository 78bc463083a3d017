#include "engine/session/facts/fact_codec.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/respiration/respiration_rules.h"
#include "tests/engine/session/respiration/lived_respiration.h"
#include "tests/support/test_class.h"

#include <limits>
#include <random>

namespace carina::checkpoint_rules_test
{

using Spoil = void (*)(RespiratoryState&);

/// Which checkpoints no fold can take, and that a fold takes its own.
class TestCheckpointRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refusesACheckpointThatNoFoldCanTake_data();
    void refusesACheckpointThatNoFoldCanTake();
    void acceptsWhatAFoldComesTo_data();
    void acceptsWhatAFoldComesTo();
    void letsAFoldGoOnFromWhatIsAccepted();
};

} // namespace carina::checkpoint_rules_test

namespace carina::checkpoint_rules_test
{

namespace
{

bool isRefused(const RespiratoryState& state)
{
    const Result<void> verdict = checkBody(fact::RespirationCheckpoint{SessionTime{}, state});
    return !verdict && verdict.error().code == Errc::OutOfRange;
}

} // namespace

void TestCheckpointRules::refusesACheckpointThatNoFoldCanTake_data()
{
    QTest::addColumn<Spoil>("spoil");
    const auto row = [](const char* name, Spoil spoil) { QTest::newRow(name) << spoil; };
    row("span", [](RespiratoryState& s) { s.system.lungs[1].curve.span.si = 0.0; });
    row("width", [](RespiratoryState& s) { s.system.lungs[0].curve.width.si = -1.0; });
    row("limbs", [](RespiratoryState& s) { s.system.lungs[0].limbVolume.si = 0.0; });
    row("bronchi", [](RespiratoryState& s) { s.system.lungs[0].bronchi.si = -1e-9; });
    row("compression", [](RespiratoryState& s) { s.system.lungs[0].compression = 0.9; });
    row("wall", [](RespiratoryState& s) { s.system.lungs[0].wall.si = 0.0; });
    row("resting volume", [](RespiratoryState& s) { s.system.lungs[1].wallVolume.si = 0.0; });
    row("tear", [](RespiratoryState& s) { s.system.lungs[1].valve.si = 1.0; });
    row("airway", [](RespiratoryState& s) { s.system.upperLaminar.si = -1.0; });
    row("turbulence", [](RespiratoryState& s) { s.system.upperTurbulent = -1.0; });
    row("mediastinum", [](RespiratoryState& s) { s.system.mediastinum.si = -1.0; });
    row("its weight", [](RespiratoryState& s) { s.system.mediastinalWeight.si = -1e7; });
    row("drive", [](RespiratoryState& s) { s.system.lungs[1].drive = -0.1; });
    row("sag", [](RespiratoryState& s) { s.system.sag = -1.1; });
    row("its room", [](RespiratoryState& s) { s.system.mediastinumMost.si = -1.0; });
    row("rate", [](RespiratoryState& s) { s.breath.rate = perMinute(1.0); });
    row("volume", [](RespiratoryState& s) { s.breath.tidalVolume.si = 0.0; });
    row("fraction", [](RespiratoryState& s) { s.breath.inspiratoryFraction = 0.95; });
    row("breaths", [](RespiratoryState& s) { s.clock.breaths = -1.0; });
    row("clock", [](RespiratoryState& s) { s.clock.rate.si = 2.0; });
    row("measured", [](RespiratoryState& s) { s.clock.measured.si = -0.1; });
    row("pull", [](RespiratoryState& s) { s.clock.pull = 0.51; });
    row("trigger", [](RespiratoryState& s) { s.clock.sinceTrigger = 1e10; });
    row("steps", [](RespiratoryState& s) { s.steps = -1; });
    row("steps of a breath",
        [](RespiratoryState& s) { s.tally.steps = std::numeric_limits<std::int64_t>::max(); });
    row("gas", [](RespiratoryState& s) { s.content[1].gas.si = 0.06; });
    row("no gas", [](RespiratoryState& s) { s.content[0].gas.si = -1e-6; });
    row("limb", [](RespiratoryState& s) { s.content[0].limb = 1.1; });
    row("other limb", [](RespiratoryState& s) { s.content[1].limb = -0.1; });
    row("trapped", [](RespiratoryState& s) { s.content[1].trapped.si = 0.06; });
    row("less than none trapped", [](RespiratoryState& s) { s.content[0].trapped.si = -1e-6; });
    row("floor", [](RespiratoryState& s) { s.system.lungs[1].curve.floor.si = -1e-6; });
    row("centre", [](RespiratoryState& s) { s.system.lungs[1].curve.centre.si = 1e7; });
    row("spread", [](RespiratoryState& s) { s.system.lungs[1].limbSpread.si = -1.0; });
    row("great span", [](RespiratoryState& s) { s.system.lungs[0].curve.span.si = 0.06; });
    row("slack wall", [](RespiratoryState& s) { s.system.lungs[0].wall.si = 1e-3; });
    row("wall's recoil", [](RespiratoryState& s) { s.system.lungs[0].wallRecoil.si = 1e7; });
    row("pleural gas", [](RespiratoryState& s) { s.system.lungs[0].pleuralGas.si = -1e-6; });
    row("relief", [](RespiratoryState& s) { s.system.lungs[0].relief.si = -0.1; });
    row("uptake", [](RespiratoryState& s) { s.system.lungs[0].uptake.si = 11.0; });
    row("uptake's end", [](RespiratoryState& s) { s.system.lungs[0].uptakeEnd.si = -1e-6; });
    row("dead alveoli", [](RespiratoryState& s) { s.system.lungs[1].alveolarDeadSpace.si = 0.06; });
    row("dead space", [](RespiratoryState& s) { s.system.anatomicalDeadSpace.si = -1e-6; });
    row("strength", [](RespiratoryState& s) { s.system.effort = 11.0; });
    row("effort", [](RespiratoryState& s) { s.effort.si = 1e7; });
    row("muscle", [](RespiratoryState& s) { s.muscle.si = -2e6; });
    row("opening", [](RespiratoryState& s) { s.opening.pressure = cmH2O(101.0); });
    row("driven flow", [](RespiratoryState& s) { s.opening.flow.si = 2.0; });
    row("inspired", [](RespiratoryState& s) { s.tally.inspired.si = -1e-6; });
    row("least gas", [](RespiratoryState& s) { s.tally.least[1].si = 0.06; });
    row("most gas", [](RespiratoryState& s) { s.tally.most[0].si = 0.06; });
    row("peak", [](RespiratoryState& s) { s.tally.peak.si = 1e7; });
    row("plateau", [](RespiratoryState& s) { s.tally.plateau.si = -1e7; });
    row("last volume", [](RespiratoryState& s) { s.last.tidalVolume.si = 2.0; });
    row("last rate", [](RespiratoryState& s) { s.last.rate.si = 501.0; });
    row("last auto-PEEP", [](RespiratoryState& s) { s.last.autoPeep.si = 1e7; });
    row("last ventilation", [](RespiratoryState& s) { s.last.alveolarVentilation.si = 2.0; });
    row("ventilator", [](RespiratoryState& s) { s.ventilator.sinceBreath = -5; });
}

void TestCheckpointRules::refusesACheckpointThatNoFoldCanTake()
{
    QFETCH(const Spoil, spoil);
    RespiratoryState state = test::livedRespiration();
    QVERIFY(!isRefused(state));
    spoil(state);
    QVERIFY(isRefused(state));
}

void TestCheckpointRules::acceptsWhatAFoldComesTo_data()
{
    QTest::addColumn<double>("weight_kg");
    QTest::addColumn<double>("height_m");
    QTest::addColumn<double>("years");
    QTest::newRow("newborn") << 1.0 << 0.4 << 0.0;
    QTest::newRow("infant") << 5.0 << 0.5 << 2.0;
    QTest::newRow("child") << 40.0 << 1.5 << 12.0;
    QTest::newRow("giant") << 300.0 << 2.3 << 120.0;
}

/// A host does not refuse its own checkpoints: each condition at its worst, breathing as fast, as
/// deep, as long and as strong as can be set, from a hard manikin to a hard ventilator.
void TestCheckpointRules::acceptsWhatAFoldComesTo()
{
    QFETCH(const double, weight_kg);
    QFETCH(const double, height_m);
    QFETCH(const double, years);
    for (const ConditionKind kind : kConditionKinds) {
        RespiratorySettings settings;
        settings.build = {metres(height_m), weight_kg, years, Sex::Male};
        const bool isMainstem = kind == ConditionKind::MainstemIntubation;
        if (kind != ConditionKind::Normal)
            settings.conditions = {
                {kind, 1.0, isMainstem ? ConditionSide::Left : ConditionSide::Both}};
        settings.position = BodyPosition(static_cast<int>(kind) % 5);
        settings.pattern = {kFastestBreathing, kLargestTidalVolume, kShortestInspiration};
        settings.ventilator.pressureLimit = kHighestPressureLimit;
        settings.ventilator.drivingPressure = kHighestDrivingPressure;
        settings.ventilator.peep = kHighestPeep;
        settings.ventilator.ownRate = kSlowestBreathing;
        settings.ventilator.ownEffort = kStrongestEffort;
        RespiratoryFold fold{settings};
        for (int i = 0; i < 6000; ++i) {
            if (i % 2000 == 1999) {
                settings.ventilator.mode = VentilationMode(i / 2000 + 1 > 2 ? 0 : i / 2000 + 1);
                settings.tube = kNarrowestTube;
                fold.set(settings);
            }
            if (i == 100 || i == 1500)
                fold.trigger(0.0);
            fold.step();
            if (i % 50 != 0)
                continue;
            const auto verdict =
                checkBody(fact::RespirationCheckpoint{SessionTime{}, fold.state()});
            QVERIFY2(verdict, verdict ? "" : verdict.error().detail.c_str());
        }
    }
}

/// Numbers changed at random in a checkpoint that came from elsewhere: a fold made from it breathes
/// on, if only nonsense, and does not stop the program.
void TestCheckpointRules::letsAFoldGoOnFromWhatIsAccepted()
{
    std::mt19937 random{7};
    const std::vector<std::byte> seed =
        encodeBody(fact::RespirationCheckpoint{SessionTime{}, test::livedRespiration()});
    int accepted = 0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<std::byte> bytes = seed;
        for (unsigned change = 0; change <= random() % 4; ++change)
            bytes[1 + random() % (bytes.size() - 1)] = static_cast<std::byte>(random() & 0xff);
        const Result<FactBody> read = decodeBody(bytes);
        if (!read || !checkBody(*read))
            continue;
        ++accepted;
        RespiratorySettings settings;
        settings.ventilator.mode = VentilationMode(random() % 3);
        RespiratoryFold fold{settings, std::get<fact::RespirationCheckpoint>(*read).state};
        for (int step = 0; step < 100; ++step) {
            if (step == 40)
                fold.trigger(0.1);
            fold.step();
        }
        QCOMPARE(fold.state().steps,
                 std::get<fact::RespirationCheckpoint>(*read).state.steps + 100);
    }
    QVERIFY(accepted > 500 && accepted < 3000);
}

CARINA_TEST(TestCheckpointRules)

} // namespace carina::checkpoint_rules_test

#include "tst_checkpoint_rules.moc"
