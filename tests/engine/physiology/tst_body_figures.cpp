#include "engine/physiology/body_figures.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

namespace carina::body_figures_test
{

class TestBodyFigures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void usesOxygenAsMeasured();
    void pumpsBloodByItsUse();
    void changesEvenlyWithAge();
    void hasTheFastestHeartAtOneMonth();
};

// Asleep. Lindahl 1989: 5.0 kg + 19.8 ml/min in children; Brody: 10 kg^0.75 awake.
void TestBodyFigures::usesOxygenAsMeasured()
{
    constexpr double kUse_mlPerMin = 1e-6;
    const auto asleep = [](const PatientBuild& build) {
        return 60.0 * kUseAsleep * bodyFiguresOf(build).oxygenUse_mlPerS;
    };
    VERIFY_WITHIN(asleep(test::kInfant), 5.0 * 9.3 + 19.8, kUse_mlPerMin);
    VERIFY_WITHIN(asleep(test::kFourYears), 5.0 * 16.5 + 19.8, kUse_mlPerMin);
    VERIFY_WITHIN(asleep(test::kLeanAdult), kUseAsleep * 10.0 * std::pow(77.0, 0.75),
                  kUse_mlPerMin);
    QVERIFY(kUseAsleep >= 0.75 && kUseAsleep <= 0.85);
}

void TestBodyFigures::pumpsBloodByItsUse()
{
    const BodyFigures adult = bodyFiguresOf(test::kLeanAdult);
    const double output_LPerMin = 0.06 * adult.cardiacOutput_mlPerS;
    QVERIFY(output_LPerMin > 4.5 && output_LPerMin < 6.5);
    QVERIFY(adult.bloodVolume_ml > 4800.0 && adult.bloodVolume_ml < 5800.0);
    const BodyFigures obese = bodyFiguresOf(test::kObese);
    QVERIFY(obese.bloodVolume_ml > adult.bloodVolume_ml);
    QVERIFY(obese.bloodVolume_ml / obese.weight_kg < adult.bloodVolume_ml / adult.weight_kg);
}

void TestBodyFigures::changesEvenlyWithAge()
{
    PatientBuild build = test::kTwelve;
    BodyFigures before = bodyFiguresOf(build);
    for (build.ageInYears = 12.1; build.ageInYears < 30.0; build.ageInYears += 0.1) {
        const BodyFigures now = bodyFiguresOf(build);
        QVERIFY(now.heartRate_perMin <= before.heartRate_perMin);
        QVERIFY(before.heartRate_perMin - now.heartRate_perMin < 0.5);
        QVERIFY(now.mean_mmHg >= before.mean_mmHg - 1e-9);
        QVERIFY(now.mean_mmHg - before.mean_mmHg < 0.5);
        before = now;
    }
}

// Medians of 143,346 children: 127 per minute at birth, most at one month, 145, and 113 at two
// years (Fleming, Lancet 2011;377:1011).
void TestBodyFigures::hasTheFastestHeartAtOneMonth()
{
    constexpr double kRate_perMin = 1.0;
    const auto rateAt = [](double years) {
        PatientBuild build = test::kNewborn;
        build.ageInYears = years;
        return bodyFiguresOf(build).heartRate_perMin;
    };
    constexpr double kMonth = 1.0 / 12.0;
    VERIFY_WITHIN(rateAt(0.0), 127.0, kRate_perMin);
    VERIFY_WITHIN(rateAt(kMonth), 145.0, kRate_perMin);
    VERIFY_WITHIN(rateAt(2.0), 113.0, kRate_perMin);
    for (double years = 0.0; years < 18.0; years += kMonth)
        QVERIFY(rateAt(years) <= rateAt(kMonth));
}

CARINA_TEST(TestBodyFigures)

} // namespace carina::body_figures_test

#include "tst_body_figures.moc"
