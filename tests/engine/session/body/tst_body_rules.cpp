#include "engine/session/body/body_rules.h"

#include "engine/session/facts/fact_rules.h"
#include "tests/engine/physiology/bed.h"
#include "tests/engine/session/body/lived_body.h"
#include "tests/support/test_class.h"

#include <functional>
#include <limits>

namespace carina::body_rules_test
{

using SpoilBody = void (*)(BodyState&);

/// Which facts about gas, drugs and tube no patient can have, and which states no body comes to.
class TestBodyRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void boundsNumbers_data();
    void boundsNumbers();
    void boundsADoseByItsDrug();
    void refusesAStateThatNoBodyComesTo_data();
    void refusesAStateThatNoBodyComesTo();
    void acceptsABodyInApnoea_data();
    void acceptsABodyInApnoea();
};

} // namespace carina::body_rules_test

namespace carina::body_rules_test
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

} // namespace

void TestBodyRules::boundsNumbers_data()
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
        row("infinite", std::numeric_limits<double>::infinity(), "not finite");
    };
    const auto noted = [](auto set) {
        return [set](double v) -> FactBody {
            fact::IntubationNoted fact;
            set(fact.event, v);
            return fact;
        };
    };
    rows("oxygen", 0.21, 1.0, [](double v) -> FactBody {
        return fact::GasSupplySet{{v, false, true}};
    });
    rows("obstruction", 0.0, 1.0, [](double v) -> FactBody { return fact::TubeObstructed{v}; });
    rows("confidence", 0.0, 1.0, noted([](IntubationEvent& e, double v) { e.confidence = v; }));
    rows("glottis", 0.0, 1.0, noted([](IntubationEvent& e, double v) { e.glotticOpening = v; }));
    rows("depth in m", 0.0, 1.0,
         noted([](IntubationEvent& e, double v) { e.depthAtTeeth = metres(v); }));
    rows("above the carina in m", -1.0, 1.0,
         noted([](IntubationEvent& e, double v) { e.tipAboveCarina = metres(v); }));
    rows("besides in m", 0.0, 1.0,
         noted([](IntubationEvent& e, double v) { e.besides = metres(v); }));
    rows("inner diameter in mm", 2.0, 12.0, [](double v) -> FactBody {
        return fact::IntubationNoted{{}, millimetres(v)};
    });
}

void TestBodyRules::boundsNumbers()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, verdict);
    QCOMPARE(verdictOf(body), verdict);
}

void TestBodyRules::boundsADoseByItsDrug()
{
    for (const DrugKind kind : kDrugKinds) {
        const auto given = [kind](double milligrams) {
            return verdictOf(fact::DrugGiven{{kind, milligrams}});
        };
        QCOMPARE(given(0.0), QByteArray{"out of range"});
        QCOMPARE(given(-1.0), QByteArray{"out of range"});
        QCOMPARE(given(1e-3), QByteArray{"fine"});
        QCOMPARE(given(mostMilligrams(kind)), QByteArray{"fine"});
        QCOMPARE(given(1.001 * mostMilligrams(kind)), QByteArray{"out of range"});
        QCOMPARE(given(std::numeric_limits<double>::quiet_NaN()), QByteArray{"not finite"});
    }
}

void TestBodyRules::refusesAStateThatNoBodyComesTo_data()
{
    QTest::addColumn<SpoilBody>("spoil");
    const auto row = [](const char* name, SpoilBody spoil) { QTest::newRow(name) << spoil; };
    row("steps", [](BodyState& s) { s.steps = -1; });
    row("oxygen", [](BodyState& s) { s.gas.lungs[1].oxygen_ml = -1.0; });
    row("carbon dioxide", [](BodyState& s) { s.gas.lungs[0].carbonDioxide_ml = 1e5; });
    row("nitrogen", [](BodyState& s) { s.gas.lungs[0].nitrogen_ml = 1e5; });
    row("airway", [](BodyState& s) { s.gas.airway[kAirwayCells - 1].oxygen = 2.1; });
    row("exhaled airway", [](BodyState& s) { s.gas.airway[0].carbonDioxide = -0.1; });
    row("inhaled", [](BodyState& s) { s.gas.inhaled_ml = -1.0; });
    row("open share", [](BodyState& s) { s.gas.openShare = 1.1; });
    row("arterial oxygen", [](BodyState& s) { s.blood.arterialOxygen_mlPerL = -1.0; });
    row("venous oxygen", [](BodyState& s) { s.blood.venousOxygen_mlPerL = 1e4; });
    row("slow oxygen", [](BodyState& s) { s.blood.restingOxygen_mlPerL = -1.0; });
    row("arterial tension", [](BodyState& s) { s.blood.arterialCarbonDioxide_mmHg = -1.0; });
    row("tissue tension", [](BodyState& s) { s.blood.tissueCarbonDioxide_mmHg = 1e6; });
    row("lung's tension", [](BodyState& s) { s.blood.lungCarbonDioxide_mmHg[1] = 1e6; });
    row("constriction", [](BodyState& s) { s.blood.constriction[1] = 1.1; });
    row("place in the line", [](BodyState& s) { s.capnograph.next = std::int64_t(kSampleLine); });
    row("place before the line", [](BodyState& s) { s.capnograph.next = -1; });
    row("line", [](BodyState& s) { s.capnograph.line[kSampleLine - 1] = -1.0; });
    row("end-tidal", [](BodyState& s) { s.capnograph.endTidal_mmHg = 1e6; });
    row("capnograph's rate", [](BodyState& s) { s.capnograph.rate_perS = -0.1; });
    row("since a breath", [](BodyState& s) { s.capnograph.sinceBreath_s = -1.0; });
    row("stomach", [](BodyState& s) { s.capnograph.stomachPhase = 1.1; });
    row("oximeter", [](BodyState& s) { s.oximeter.shown = 1.1; });
    row("way to the finger", [](BodyState& s) { s.oximeter.way[kWayToFinger - 1] = -0.1; });
    row("oximeter's steps", [](BodyState& s) { s.oximeter.steps = -1; });
    row("heart rate", [](BodyState& s) { s.circulation.heartRate_perS = -1.0; });
    row("pressure", [](BodyState& s) { s.circulation.mean_mmHg = 1e4; });
    row("pulse", [](BodyState& s) { s.circulation.pulse_mmHg = -1.0; });
    row("harm", [](BodyState& s) { s.circulation.harm = -1.0; });
    row("lowest", [](BodyState& s) { s.capnograph.lowest_mmHg = -1.0; });
    row("rate near 0", [](BodyState& s) { s.circulation.heartRate_perS = 1e-9; });
    row("beat", [](BodyState& s) { s.circulation.beat = 1.0; });
    row("before a beat", [](BodyState& s) { s.circulation.beat = -1e-9; });
    row("drug", [](BodyState& s) { s.drugs[3].effect_mgPerL = -1.0; });
    row("drug in a vein", [](BodyState& s) { s.drugs[6].vein_mg = -1.0; });
    row("spasm", [](BodyState& s) { s.spasm = 1.1; });
}

void TestBodyRules::refusesAStateThatNoBodyComesTo()
{
    QFETCH(const SpoilBody, spoil);
    const auto isRefused = [](const BodyState& state) {
        return verdictOf(fact::BodyCheckpoint{{}, state}) != "fine"
               || verdictOf(fact::CapnographCheckpoint{{}, state.capnograph}) != "fine";
    };
    BodyState state = test::livedBody();
    QVERIFY(!isRefused(state));
    spoil(state);
    QVERIFY(isRefused(state));
}

void TestBodyRules::acceptsABodyInApnoea_data()
{
    QTest::addColumn<PatientBuild>("build");
    QTest::addColumn<double>("oxygen");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<bool>("dies");
    const PatientBuild heavy{metres(1.75), 150.0, 45.0, Sex::Male};
    const PatientBuild lightest{metres(0.40), 1.0, 0.0, Sex::Male};
    QTest::newRow("newborn") << test::kNewborn << 0.21 << 600.0 << true;
    QTest::newRow("lightest") << lightest << 0.21 << 600.0 << true;
    QTest::newRow("150 kg") << heavy << 0.21 << 600.0 << true;
    QTest::newRow("lean adult") << test::kLeanAdult << 0.21 << 600.0 << true;
    QTest::newRow("long, in oxygen") << test::kLeanAdult << 1.0 << 1200.0 << false;
}

// The host would else refuse its own checkpoint.
void TestBodyRules::acceptsABodyInApnoea()
{
    constexpr double kCheckEvery_s = 10.0; // as checkpoints are made
    // Tissues without oxygen make no carbon dioxide.
    constexpr double kWhenDying_mmHg = 50.0;
    constexpr double kInOxygen_mmHg = 70.0;
    QFETCH(const PatientBuild, build);
    QFETCH(const double, oxygen);
    QFETCH(const double, seconds);
    QFETCH(const bool, dies);
    test::Bed bed{build};
    bed.holdMask(oxygen);
    bed.run(60.0);
    bed.stopBreathing();
    for (double passed_s = 0.0; passed_s < seconds; passed_s += kCheckEvery_s) {
        bed.run(kCheckEvery_s);
        const BodyState& state = bed.body.state();
        QCOMPARE(verdictOf(fact::BodyCheckpoint{{}, state}), QByteArray{"fine"});
        QCOMPARE(verdictOf(fact::CapnographCheckpoint{{}, state.capnograph}), QByteArray{"fine"});
    }
    QCOMPARE(bed.body.state().circulation.arrested, dies);
    const double carbonDioxide_mmHg = bed.body.state().blood.tissueCarbonDioxide_mmHg;
    QVERIFY2(carbonDioxide_mmHg > (dies ? kWhenDying_mmHg : kInOxygen_mmHg),
             qPrintable(QString::number(carbonDioxide_mmHg)));
}

CARINA_TEST(TestBodyRules)

} // namespace carina::body_rules_test

#include "tst_body_rules.moc"
