#include "engine/session/respiration/respiration_rules.h"

#include "engine/session/facts/fact_rules.h"
#include "tests/support/test_class.h"

#include <functional>
#include <limits>

namespace carina::respiration_rules_test
{

/// Which facts about respiration no patient can have, and no fold can take.
class TestRespirationRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void boundsNumbers_data();
    void boundsNumbers();
    void refusesATubeInBothBronchi();
    void refusesADiseaseTwiceOnALung();
    void allowsNoTubeAndNoEffort();
    void refusesAPressureLimitThatIsNotAbovePeep();
    void boundsABreathByThePatient();
};

} // namespace carina::respiration_rules_test

namespace carina::respiration_rules_test
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
    rows("height in mm", 400.0, 2300.0,
         build([](PatientBuild& b, double v) { b.height = millimetres(v); }));
    rows("weight in kg", 1.0, 300.0,
         build([](PatientBuild& b, double v) { b.weightInKilograms = v; }));
    rows("age in years", 0.0, 120.0, build([](PatientBuild& b, double v) { b.ageInYears = v; }));
    rows("severity", 0.0, 1.0, [](double v) -> FactBody {
        return fact::LungConditionsSet{{{ConditionKind::Ards, v, ConditionSide::Both}}};
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
    rows("pressure limit in cmH2O", 5.0, 100.0, ventilator([](VentilatorSettings& s, double v) {
             s.peep = {};
             s.pressureLimit = cmH2O(v);
         }));
    rows("pause", 0.0, 0.8, ventilator([](VentilatorSettings& s, double v) { s.pauseShare = v; }));
    rows("trigger in L/s", 0.0, 0.5,
         ventilator([](VentilatorSettings& s, double v) { s.trigger = litresPerSecond(v); }));
    rows("own rate per minute", 4.0, 60.0,
         ventilator([](VentilatorSettings& s, double v) { s.ownRate = perMinute(v); }));
    rows("own effort", 0.0, 2.0,
         ventilator([](VentilatorSettings& s, double v) { s.ownEffort = v; }));
    rows("tube in mm", 2.0, 12.0, [](double v) -> FactBody {
        return fact::TubePlaced{{TubeSeat::Oesophagus, millimetres(v)}};
    });
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
        return fact::LungConditionsSet{{{ConditionKind::MainstemIntubation, 0.5, side}}};
    };
    QCOMPARE(verdictOf(tubeIn(ConditionSide::Both)), QByteArray{"out of range"});
    QCOMPARE(verdictOf(tubeIn(ConditionSide::Left)), QByteArray{"fine"});
}

void TestRespirationRules::refusesADiseaseTwiceOnALung()
{
    using enum ConditionSide;
    const auto verdict = [](const LungConditions& all) {
        return verdictOf(fact::LungConditionsSet{all});
    };
    const LungCondition right{ConditionKind::Atelectasis, 0.5, Right};
    QCOMPARE(verdict({}), QByteArray{"fine"});
    QCOMPARE(verdict({right, {ConditionKind::Atelectasis, 0.5, Left}}), QByteArray{"fine"});
    QCOMPARE(verdict({right, {ConditionKind::Copd, 0.5, Both}}), QByteArray{"fine"});
    QCOMPARE(verdict({right, {ConditionKind::Atelectasis, 0.7, Both}}), QByteArray{"out of range"});
    QCOMPARE(verdict({right, {ConditionKind::Copd, 1.5, Both}}), QByteArray{"out of range"});
    QCOMPARE(verdict({LungCondition{}}), QByteArray{"out of range"});
}

void TestRespirationRules::allowsNoTubeAndNoEffort()
{
    QCOMPARE(verdictOf(fact::TubePlaced{}), QByteArray{"fine"});
    QCOMPARE(verdictOf(fact::TubePlaced{{TubeSeat::None, millimetres(7.0)}}), QByteArray{"fine"});
    QCOMPARE(verdictOf(fact::TubePlaced{{TubeSeat::Trachea, {}}}), QByteArray{"out of range"});
    QCOMPARE(verdictOf(fact::VentilatorSet{}), QByteArray{"fine"}); // own rate 0
    QCOMPARE(verdictOf(fact::ManikinBreathed{}), QByteArray{"fine"});
}

void TestRespirationRules::refusesAPressureLimitThatIsNotAbovePeep()
{
    const auto limited = [](double limit_cmH2O) {
        fact::VentilatorSet fact;
        fact.settings.peep = cmH2O(12.0);
        fact.settings.pressureLimit = cmH2O(limit_cmH2O);
        return verdictOf(fact);
    };
    QCOMPARE(limited(12.0), QByteArray{"out of range"});
    QCOMPARE(limited(11.0), QByteArray{"out of range"});
    QCOMPARE(limited(12.001), QByteArray{"fine"});
}

/// Half of an inspiratory capacity of 50 ml/kg: 1 L of a child of 40 kg, 1.925 L of an adult.
void TestRespirationRules::boundsABreathByThePatient()
{
    const PatientBuild child{metres(1.5), 40.0, 12.0, Sex::Female};
    QVERIFY(checkTidalVolume(child, millilitres(999.9)));
    QVERIFY(checkTidalVolume(PatientBuild{}, millilitres(1924.9)));
    QCOMPARE(checkTidalVolume(PatientBuild{}, millilitres(1925.1)).error().code, Errc::OutOfRange);
    const Result<void> tooMuch = checkTidalVolume(child, millilitres(2000.0));
    QCOMPARE(tooMuch.error().code, Errc::OutOfRange);
    QCOMPARE(tooMuch.error().detail,
             std::string{"tidal volume of this patient 2000 ml (10 to 1000)"});
    QCOMPARE(checkTidalVolume(child, millilitres(9.0)).error().code, Errc::OutOfRange);
    QCOMPARE(checkTidalVolume(child, Volume{kInfinity}).error().code, Errc::NotFinite);
}

CARINA_TEST(TestRespirationRules)

} // namespace carina::respiration_rules_test

#include "tst_respiration_rules.moc"
