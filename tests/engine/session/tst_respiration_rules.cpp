#include "engine/session/respiration_rules.h"

#include "engine/session/fact_codec.h"
#include "engine/session/fact_rules.h"
#include "tests/engine/session/lived_respiration.h"

#include <QTest>
#include <functional>
#include <limits>
#include <random>

namespace carina
{

using Spoil = void (*)(RespiratoryState&);

/// Which facts about respiration no patient can have, and no fold can take.
class TestRespirationRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void boundsNumbers_data();
    void boundsNumbers();
    void refusesATubeInBothBronchi();
    void allowsNoTubeAndNoEffort();
    void refusesACheckpointThatNoFoldCanTake_data();
    void refusesACheckpointThatNoFoldCanTake();
    void letsAFoldGoOnFromWhatIsAccepted();
};

} // namespace carina

Q_DECLARE_METATYPE(carina::FactBody)
Q_DECLARE_METATYPE(carina::Spoil)

namespace carina
{

namespace
{

QByteArray verdictOf(const FactBody& body)
{
    const Result<void> result = checkBody(body);
    if (result)
        return "fine";
    return result.error().code == Errc::OutOfRange  ? "out of range"
           : result.error().code == Errc::NotFinite ? "not finite"
                                                    : "another error";
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

void TestRespirationRules::boundsNumbers_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("verdict");
    using Make = std::function<FactBody(double)>;
    const auto rows = [](const char* what, double lowest, double highest, const Make& make) {
        const double step = 1e-6 * (highest - lowest);
        const auto row = [&](const char* name, double value, const char* verdict) {
            QTest::addRow("%s, %s", what, name) << make(value) << QByteArray{verdict};
        };
        row("lowest", lowest, "fine");
        row("below", lowest - step, "out of range");
        row("highest", highest, "fine");
        row("above", highest + step, "out of range");
        row("infinite", kInfinity, "not finite");
    };
    const auto build = [](auto set) {
        return [set](double v) -> FactBody {
            fact::PatientBuildSet fact;
            set(fact.build, v);
            return fact;
        };
    };
    rows("height in mm", 500.0, 2300.0,
         build([](PatientBuild& b, double v) { b.height = millimetres(v); }));
    rows("weight in kg", 5.0, 300.0,
         build([](PatientBuild& b, double v) { b.weightInKilograms = v; }));
    rows("age in years", 2.0, 120.0, build([](PatientBuild& b, double v) { b.ageInYears = v; }));
    rows("severity", 0.0, 1.0, [](double v) -> FactBody {
        return fact::LungConditionSet{{ConditionKind::Ards, v, ConditionSide::Both}};
    });
    const auto ventilator = [](auto set) {
        return [set](double v) -> FactBody {
            fact::VentilatorSet fact;
            set(fact.settings, v);
            return fact;
        };
    };
    rows("PEEP in cmH2O", 0.0, 25.0,
         ventilator([](VentilatorSettings& s, double v) { s.peep = cmH2O(v); }));
    rows("driving pressure in cmH2O", 0.0, 60.0,
         ventilator([](VentilatorSettings& s, double v) { s.drivingPressure = cmH2O(v); }));
    rows("pressure limit in cmH2O", 5.0, 100.0,
         ventilator([](VentilatorSettings& s, double v) { s.pressureLimit = cmH2O(v); }));
    rows("pause", 0.0, 0.8, ventilator([](VentilatorSettings& s, double v) { s.pauseShare = v; }));
    rows("trigger in L/s", 0.0, 0.5,
         ventilator([](VentilatorSettings& s, double v) { s.trigger = litresPerSecond(v); }));
    rows("own rate per minute", 4.0, 60.0,
         ventilator([](VentilatorSettings& s, double v) { s.ownRate = perMinute(v); }));
    rows("own effort", 0.0, 2.0,
         ventilator([](VentilatorSettings& s, double v) { s.ownEffort = v; }));
    rows("tube in mm", 2.0, 12.0,
         [](double v) -> FactBody { return fact::TubePlaced{millimetres(v)}; });
}

void TestRespirationRules::boundsNumbers()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, verdict);
    QCOMPARE(verdictOf(body), verdict);
}

void TestRespirationRules::refusesATubeInBothBronchi()
{
    const auto tubeIn = [](ConditionSide side) {
        return fact::LungConditionSet{{ConditionKind::MainstemIntubation, 0.5, side}};
    };
    QCOMPARE(verdictOf(tubeIn(ConditionSide::Both)), QByteArray{"out of range"});
    QCOMPARE(verdictOf(tubeIn(ConditionSide::Left)), QByteArray{"fine"});
}

void TestRespirationRules::allowsNoTubeAndNoEffort()
{
    QCOMPARE(verdictOf(fact::TubePlaced{}), QByteArray{"fine"});
    QCOMPARE(verdictOf(fact::VentilatorSet{}), QByteArray{"fine"}); // own rate 0
    QCOMPARE(verdictOf(fact::ManikinBreathed{}), QByteArray{"fine"});
}

void TestRespirationRules::refusesACheckpointThatNoFoldCanTake_data()
{
    QTest::addColumn<Spoil>("spoil");
    const auto row = [](const char* name, Spoil spoil) { QTest::newRow(name) << spoil; };
    row("span", [](RespiratoryState& s) { s.system.lungs[1].curve.span.si = 0.0; });
    row("width", [](RespiratoryState& s) { s.system.lungs[0].curve.width.si = -1.0; });
    row("limbs", [](RespiratoryState& s) { s.system.lungs[0].limbVolume.si = 0.0; });
    row("bronchi", [](RespiratoryState& s) { s.system.lungs[0].bronchi.si = -1e-9; });
    row("wall", [](RespiratoryState& s) { s.system.lungs[0].wall.si = 0.0; });
    row("resting volume", [](RespiratoryState& s) { s.system.lungs[1].wallVolume.si = 0.0; });
    row("tear", [](RespiratoryState& s) { s.system.lungs[1].valve.si = 1.0; });
    row("airway", [](RespiratoryState& s) { s.system.upperLaminar.si = -1.0; });
    row("turbulence", [](RespiratoryState& s) { s.system.upperTurbulent = -1.0; });
    row("mediastinum", [](RespiratoryState& s) { s.system.mediastinum.si = -1.0; });
    row("its room", [](RespiratoryState& s) { s.system.mediastinumMost.si = -1.0; });
    row("rate", [](RespiratoryState& s) { s.breath.rate.si = 0.0; });
    row("volume", [](RespiratoryState& s) { s.breath.tidalVolume.si = 0.0; });
    row("fraction", [](RespiratoryState& s) { s.breath.inspiratoryFraction = 0.95; });
    row("breaths", [](RespiratoryState& s) { s.clock.breaths = -1.0; });
    row("clock", [](RespiratoryState& s) { s.clock.rate.si = 2.0; });
    row("measured", [](RespiratoryState& s) { s.clock.measured.si = -0.1; });
    row("pull", [](RespiratoryState& s) { s.clock.pull = 1.5; });
    row("trigger", [](RespiratoryState& s) { s.clock.sinceTrigger = 1e10; });
    row("steps", [](RespiratoryState& s) { s.steps = -1; });
    row("steps of a breath",
        [](RespiratoryState& s) { s.tally.steps = std::numeric_limits<std::int64_t>::max(); });
    row("ventilator", [](RespiratoryState& s) { s.ventilator.sinceBreath = -5; });
}

void TestRespirationRules::refusesACheckpointThatNoFoldCanTake()
{
    QFETCH(const Spoil, spoil);
    fact::RespirationCheckpoint checkpoint{SessionTime{}, test::livedRespiration()};
    QCOMPARE(verdictOf(checkpoint), QByteArray{"fine"});
    spoil(checkpoint.state);
    QCOMPARE(verdictOf(checkpoint), QByteArray{"out of range"});
}

/// Numbers changed at random in a checkpoint that came from elsewhere: a fold made from it breathes
/// on, if only nonsense, and does not stop the program.
void TestRespirationRules::letsAFoldGoOnFromWhatIsAccepted()
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

} // namespace carina

QTEST_APPLESS_MAIN(carina::TestRespirationRules)
#include "tst_respiration_rules.moc"
