#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

namespace carina::carbon_dioxide_test
{

namespace
{

using test::Bed;

struct Rise {
    double arterial_mmHg;
    double endTidal_mmHg; ///< of the first breath after the apnoea
};

Rise riseInApnoea(const PatientBuild& build, double seconds)
{
    const auto arterial = [](const Bed& bed) {
        return bed.body.state().blood.arterialCarbonDioxide_mmHg;
    };
    Bed bed{build};
    bed.holdMask(1.0);
    bed.run(120.0);
    const Rise before{arterial(bed), bed.endTidal_mmHg()};
    bed.stopBreathing();
    bed.run(seconds);
    const double after = arterial(bed);
    bed.squeezeBag(12.0, inMillilitres(restingPattern(build).tidalVolume));
    bed.runWhile(20.0, [&] { return bed.endTidal_mmHg() == 0.0; }); // until the first is over
    return {after - before.arterial_mmHg, bed.endTidal_mmHg() - before.endTidal_mmHg};
}

void expectWithin(double value, double least, double most)
{
    QVERIFY2(value >= least && value <= most, qPrintable(QString::number(value)));
}

} // namespace

/// Carbon dioxide that stays behind.
class TestCarbonDioxide : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void risesInApnoea_data();
    void risesInApnoea();
    void fallsWithLargeBreaths();
    void isMadeOfNoMoreOxygenThanTheBloodHeldAtAnArrest();
};

void TestCarbonDioxide::risesInApnoea_data()
{
    QTest::addColumn<PatientBuild>("build");
    QTest::newRow("12 years") << test::kTwelve;
    QTest::newRow("lean adult") << test::kLeanAdult;
}

// 8 to 15 mmHg in the first minute in arterial blood, then 3 to 4 in each minute (Eger and
// Severinghaus, Anesthesiology 1961;22:419). So does the first breath that follows, whose fresh gas
// dilutes what it shows.
void TestCarbonDioxide::risesInApnoea()
{
    constexpr double kDiluted = 0.8;
    QFETCH(const PatientBuild, build);
    const Rise first = riseInApnoea(build, 60.0);
    expectWithin(first.arterial_mmHg, 8.0, 15.0);
    expectWithin(first.endTidal_mmHg, kDiluted * 8.0, 15.0);
    const Rise later = riseInApnoea(build, 240.0);
    expectWithin((later.arterial_mmHg - first.arterial_mmHg) / 3.0, 3.0, 4.0);
    expectWithin((later.endTidal_mmHg - first.endTidal_mmHg) / 3.0, kDiluted * 3.0, 4.0);
}

// Twice the alveolar ventilation halves the tension in the end.
void TestCarbonDioxide::fallsWithLargeBreaths()
{
    Bed bed{test::kLeanAdult};
    bed.stopBreathing();
    bed.intubate(TubeSeat::Trachea, 1.0);
    bed.squeezeBag(12.0, 450.0);
    bed.run(240.0);
    const double usual = bed.endTidal_mmHg();
    bed.squeezeBag(24.0, 450.0);
    bed.run(600.0);
    QVERIFY2(bed.endTidal_mmHg() < 0.75 * usual,
             qPrintable(QString::number(bed.endTidal_mmHg() / usual)));
    QVERIFY(bed.endTidal_mmHg() > 0.45 * usual);
}

// Whoever has no circulation makes carbon dioxide of the oxygen that is left in the blood; without
// an end it would rise by 4 mmHg a minute.
void TestCarbonDioxide::isMadeOfNoMoreOxygenThanTheBloodHeldAtAnArrest()
{
    constexpr double kWithoutOxygen_mmHg = 0.1; // in half an hour
    Bed bed{test::kLeanAdult};
    bed.stopBreathing();
    bed.runWhile(1200.0, [&] { return !bed.body.state().circulation.arrested; });
    QVERIFY(bed.body.state().circulation.arrested);
    const BloodGas& blood = bed.body.state().blood;
    const BodyFigures body = bodyFiguresOf(test::kLeanAdult);
    const double atArrest = blood.tissueCarbonDioxide_mmHg;
    const double left_ml = 1e-3 * blood.restingOxygen_mlPerL * body.bloodVolume_ml;
    bed.run(300.0);
    const double later = blood.tissueCarbonDioxide_mmHg;
    const double made_mlPerMmHg = body.carbonDioxide_mlPerS * 600.0 / 40.0; // for each mmHg
    const double most = left_ml * body.carbonDioxide_mlPerS / body.oxygenUse_mlPerS;
    QVERIFY2(later >= atArrest && (later - atArrest) * made_mlPerMmHg <= most,
             qPrintable(QString::number(later - atArrest)));
    bed.run(1800.0);
    expectWithin(blood.tissueCarbonDioxide_mmHg - later, 0.0, kWithoutOxygen_mmHg);
}

CARINA_TEST(TestCarbonDioxide)

} // namespace carina::carbon_dioxide_test

#include "tst_carbon_dioxide.moc"
