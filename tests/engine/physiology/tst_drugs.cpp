#include "engine/physiology/drug_effect.h"
#include "engine/physiology/drug_kinetics.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

#include <vector>

namespace carina::drugs_test
{

namespace
{

constexpr double kWeight_kg = 77.0;
constexpr double kMinute = 60.0; // s

/// Drugs in an adult with a normal circulation.
class Patient
{
public:
    void give(DrugKind kind, double mgPerKg) { inject(m_drugs, {kind, mgPerKg * kWeight_kg}); }

    void wait(double seconds)
    {
        const long steps = std::lround(seconds / kBodyStep);
        for (long i = 0; i < steps; ++i)
            spread(m_drugs, kWeight_kg, 1.0, kBodyStep);
    }

    /// @returns the seconds until it is no longer true, at most an hour and a half
    template <class GoesOn> double waitWhile(GoesOn goesOn)
    {
        constexpr double kLongest = 90.0 * kMinute;
        double seconds = 0.0;
        while (goesOn(effect()) && seconds < kLongest) {
            wait(1.0);
            seconds += 1.0;
        }
        return seconds;
    }

    [[nodiscard]] DrugEffect effect() const { return effectOf(m_drugs); }
    [[nodiscard]] const DrugsInBody& drugs() const { return m_drugs; }

private:
    DrugsInBody m_drugs{};
};

bool isAwake(const DrugEffect& effect) { return effect.hypnosis < 0.5; }
bool isAsleep(const DrugEffect& effect) { return effect.hypnosis >= 0.5; }
/// Conditions for an intubation.
bool isNotYetRelaxed(const DrugEffect& effect) { return effect.relaxation < 0.95; }
/// A quarter of the twitch has not come back.
bool isBlocked(const DrugEffect& effect) { return effect.relaxation > 0.75; }
bool isWeak(const DrugEffect& effect) { return effect.relaxation > 0.1; }

void expectWithin(double value, double least, double most)
{
    QVERIFY2(value >= least && value <= most, qPrintable(QString::number(value)));
}

} // namespace

/// Onset and duration of drugs, against what textbooks and product information give.
class TestDrugs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sendsToSleep_data();
    void sendsToSleep();
    void relaxes_data();
    void relaxes();
    void reverses_data();
    void reverses();
    void doesNotReverseWithTooLittle();
    void doesNotReverseSuxamethonium();
    void slowsTheBreathing();
    void leavesBreathingToKetamine();
    void movesThePressure();
    void anaesthetiseWhileTheyAct_data();
    void anaesthetiseWhileTheyAct();
    void doNotAnaesthetise_data();
    void doNotAnaesthetise();
    void conservesWhatIsNotEliminated();
    void arrivesAtTheSteadyState();
    void doesNothingWithoutDrugs();
};

void TestDrugs::sendsToSleep_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("mgPerKg");
    QTest::addColumn<double>("leastOnset_s");
    QTest::addColumn<double>("mostOnset_s");
    QTest::addColumn<double>("leastDuration_min");
    QTest::addColumn<double>("mostDuration_min");
    QTest::newRow("propofol 2") << int(DrugKind::Propofol) << 2.0 << 25.0 << 40.0 << 5.0 << 10.0;
    QTest::newRow("ketamine 1.5") << int(DrugKind::Ketamine) << 1.5 << 20.0 << 60.0 << 6.0 << 15.0;
}

void TestDrugs::sendsToSleep()
{
    QFETCH(const int, kind);
    QFETCH(const double, mgPerKg);
    QFETCH(const double, leastOnset_s);
    QFETCH(const double, mostOnset_s);
    QFETCH(const double, leastDuration_min);
    QFETCH(const double, mostDuration_min);
    Patient patient;
    patient.give(DrugKind(kind), mgPerKg);
    expectWithin(patient.waitWhile(isAwake), leastOnset_s, mostOnset_s);
    expectWithin(patient.waitWhile(isAsleep) / kMinute, leastDuration_min, mostDuration_min);
}

void TestDrugs::relaxes_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("mgPerKg");
    QTest::addColumn<double>("leastOnset_s");
    QTest::addColumn<double>("mostOnset_s");
    QTest::addColumn<double>("leastDuration_min");
    QTest::addColumn<double>("mostDuration_min");
    const int rocuronium = int(DrugKind::Rocuronium);
    const int suxamethonium = int(DrugKind::Suxamethonium);
    QTest::newRow("rocuronium 0.6") << rocuronium << 0.6 << 75.0 << 105.0 << 30.0 << 40.0;
    QTest::newRow("rocuronium 1.2") << rocuronium << 1.2 << 40.0 << 70.0 << 55.0 << 75.0;
    QTest::newRow("suxamethonium 1") << suxamethonium << 1.0 << 45.0 << 60.0 << 6.0 << 10.0;
    QTest::newRow("suxamethonium 1.5") << suxamethonium << 1.5 << 30.0 << 60.0 << 6.0 << 11.0;
}

// From the injection to 5 % of the muscles' strength, and to 25 %.
void TestDrugs::relaxes()
{
    QFETCH(const int, kind);
    QFETCH(const double, mgPerKg);
    QFETCH(const double, leastOnset_s);
    QFETCH(const double, mostOnset_s);
    QFETCH(const double, leastDuration_min);
    QFETCH(const double, mostDuration_min);
    Patient patient;
    patient.give(DrugKind(kind), mgPerKg);
    const double onset_s = patient.waitWhile(isNotYetRelaxed);
    expectWithin(onset_s, leastOnset_s, mostOnset_s);
    expectWithin((onset_s + patient.waitWhile(isBlocked)) / kMinute, leastDuration_min,
                 mostDuration_min);
}

void TestDrugs::reverses_data()
{
    QTest::addColumn<double>("rocuronium");
    QTest::addColumn<double>("after_min");
    QTest::addColumn<double>("sugammadex");
    QTest::newRow("at once") << 1.2 << 3.0 << 16.0;
    QTest::newRow("deep") << 0.6 << 15.0 << 4.0;
    QTest::newRow("returning") << 0.6 << 35.0 << 2.0;
}

// Sugammadex brings the strength back in two to three minutes, and it does not go again.
void TestDrugs::reverses()
{
    QFETCH(const double, rocuronium);
    QFETCH(const double, after_min);
    QFETCH(const double, sugammadex);
    Patient patient;
    patient.give(DrugKind::Rocuronium, rocuronium);
    patient.wait(after_min * kMinute);
    QVERIFY(patient.effect().relaxation > 0.7);
    patient.give(DrugKind::Sugammadex, sugammadex);
    expectWithin(patient.waitWhile(isWeak), 30.0, 180.0);
    patient.wait(20.0 * kMinute);
    QVERIFY(patient.effect().relaxation < 0.1);
}

void TestDrugs::doesNotReverseWithTooLittle()
{
    Patient patient;
    patient.give(DrugKind::Rocuronium, 1.2);
    patient.wait(3.0 * kMinute);
    patient.give(DrugKind::Sugammadex, 1.0);
    patient.wait(5.0 * kMinute);
    QVERIFY(patient.effect().relaxation > 0.95);
}

void TestDrugs::doesNotReverseSuxamethonium()
{
    Patient patient;
    patient.give(DrugKind::Suxamethonium, 1.5);
    patient.wait(kMinute);
    patient.give(DrugKind::Sugammadex, 16.0);
    patient.wait(2.0 * kMinute);
    QVERIFY(patient.effect().relaxation > 0.95);
}

// Fentanyl alone leaves some breathing, propofol leaves little, both together none for a while;
// relaxants leave none at all.
void TestDrugs::slowsTheBreathing()
{
    Patient opioid;
    opioid.give(DrugKind::Fentanyl, 3e-3);
    opioid.wait(3.0 * kMinute);
    expectWithin(opioid.effect().breathing, 0.1, 0.7);
    Patient hypnotic;
    hypnotic.give(DrugKind::Propofol, 2.0);
    hypnotic.wait(90.0);
    expectWithin(hypnotic.effect().breathing, 0.0, 0.3);
    Patient both;
    both.give(DrugKind::Fentanyl, 3e-3);
    both.give(DrugKind::Propofol, 2.0);
    both.wait(2.0 * kMinute);
    QCOMPARE(both.effect().breathing, 0.0);
    both.wait(15.0 * kMinute);
    QVERIFY(both.effect().breathing > 0.5);
    Patient relaxed;
    relaxed.give(DrugKind::Suxamethonium, 1.0);
    relaxed.wait(90.0);
    QCOMPARE(relaxed.effect().breathing, 0.0);
    QVERIFY(relaxed.effect().tone < 0.05);
    QVERIFY(isAwake(relaxed.effect()));
}

void TestDrugs::leavesBreathingToKetamine()
{
    Patient patient;
    patient.give(DrugKind::Ketamine, 1.5);
    patient.wait(90.0);
    QVERIFY(isAsleep(patient.effect()));
    QCOMPARE(patient.effect().breathing, 1.0);
    QVERIFY(patient.effect().pressure > 1.05);
}

void TestDrugs::movesThePressure()
{
    Patient propofol;
    propofol.give(DrugKind::Propofol, 2.0);
    propofol.wait(120.0);
    expectWithin(propofol.effect().pressure, 0.65, 0.85);
    Patient ephedrine;
    ephedrine.give(DrugKind::Ephedrine, 10.0 / kWeight_kg);
    ephedrine.wait(180.0);
    expectWithin(ephedrine.effect().pressure, 1.1, 1.3);
    expectWithin(ephedrine.effect().heartRate, 1.05, 1.3);
}

void TestDrugs::anaesthetiseWhileTheyAct_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("mgPerKg");
    QTest::newRow("propofol") << int(DrugKind::Propofol) << 2.0;
    QTest::newRow("ketamine") << int(DrugKind::Ketamine) << 1.5;
    QTest::newRow("rocuronium") << int(DrugKind::Rocuronium) << 0.6;
    QTest::newRow("suxamethonium") << int(DrugKind::Suxamethonium) << 1.0;
}

/// Neither before they have come to where they act, nor once they have worn off.
void TestDrugs::anaesthetiseWhileTheyAct()
{
    QFETCH(const int, kind);
    QFETCH(const double, mgPerKg);
    Patient patient;
    patient.give(DrugKind(kind), mgPerKg);
    QVERIFY(!isAnaesthetised(patient.effect()));
    patient.wait(2.0 * kMinute);
    QVERIFY(isAnaesthetised(patient.effect()));
    patient.wait(180.0 * kMinute);
    QVERIFY(amountsOf(patient.drugs(), DrugKind(kind)).effect_mgPerL > 0.0);
    QVERIFY(!isAnaesthetised(patient.effect()));
}

void TestDrugs::doNotAnaesthetise_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("mgPerKg");
    QTest::newRow("fentanyl") << int(DrugKind::Fentanyl) << 0.003;
    QTest::newRow("sugammadex") << int(DrugKind::Sugammadex) << 4.0;
    QTest::newRow("ephedrine") << int(DrugKind::Ephedrine) << 0.2;
}

void TestDrugs::doNotAnaesthetise()
{
    QFETCH(const int, kind);
    QFETCH(const double, mgPerKg);
    Patient patient;
    patient.give(DrugKind(kind), mgPerKg);
    patient.wait(2.0 * kMinute);
    QVERIFY(!isAnaesthetised(patient.effect()));
}

// What is in the compartments and what was eliminated add up to the dose.
void TestDrugs::conservesWhatIsNotEliminated()
{
    constexpr double kDrug_mg = 1e-9;
    DrugsInBody drugs{};
    inject(drugs, {DrugKind::Fentanyl, 0.2});
    double eliminated_mg = 0.0;
    const DrugAmounts& fentanyl = amountsOf(drugs, DrugKind::Fentanyl);
    for (int step = 0; step < 50 * 600; ++step) {
        eliminated_mg +=
            kBodyStep / kMinute * kineticsOf(DrugKind::Fentanyl).eliminated * fentanyl.central_mg;
        spread(drugs, kWeight_kg, 1.0, kBodyStep);
    }
    const double left_mg =
        fentanyl.vein_mg + fentanyl.central_mg + fentanyl.fast_mg + fentanyl.slow_mg;
    VERIFY_WITHIN(left_mg + eliminated_mg, 0.2, kDrug_mg);
    QVERIFY(eliminated_mg > 0.02);
}

// One compartment and an effect site have a closed form: with k the elimination and e the exchange
// with the effect site, the effect follows e / (e - k) (exp(-k t) - exp(-e t)), but for the vein's
// delay, which 20 minutes later matters as a shift of 12 s.
void TestDrugs::arrivesAtTheSteadyState()
{
    constexpr double kShare = 0.01;
    constexpr double kVein_min = 0.2;
    const DrugKinetics& kinetics = kineticsOf(DrugKind::Ephedrine);
    DrugsInBody drugs{};
    inject(drugs, {DrugKind::Ephedrine, 10.0});
    const double minutes = 20.0;
    for (int step = 0; step < 50 * 60 * 20; ++step)
        spread(drugs, kWeight_kg, 1.0, kBodyStep);
    const double k = kinetics.eliminated;
    const double e = kinetics.toEffect;
    const double since = minutes - kVein_min;
    const double expected = 10.0 / (kinetics.central_LPerKg * kWeight_kg) * e / (e - k)
                            * (std::exp(-k * since) - std::exp(-e * since));
    VERIFY_WITHIN(amountsOf(drugs, DrugKind::Ephedrine).effect_mgPerL / expected, 1.0, kShare);
}

void TestDrugs::doesNothingWithoutDrugs() { QVERIFY(effectOf(DrugsInBody{}) == DrugEffect{}); }

CARINA_TEST(TestDrugs)

} // namespace carina::drugs_test

#include "tst_drugs.moc"
