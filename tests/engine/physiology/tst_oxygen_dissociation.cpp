#include "engine/physiology/oxygen_dissociation.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

namespace carina::oxygen_dissociation_test
{

class TestOxygenDissociation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithMeasuredBlood_data();
    void agreesWithMeasuredBlood();
    void addsWhatIsDissolved();
    void findsThePressureOfAContent();
};

// Standard human blood at 37 degrees and pH 7.4: half saturated at 26.8 mmHg, and as in textbooks
// at the tensions of venous and arterial blood.
void TestOxygenDissociation::agreesWithMeasuredBlood_data()
{
    QTest::addColumn<double>("pressure_mmHg");
    QTest::addColumn<double>("saturation");
    QTest::newRow("26.8") << 26.8 << 0.5000;
    QTest::newRow("40") << 40.0 << 0.7500;
    QTest::newRow("100") << 100.0 << 0.9750;
    QTest::newRow("none") << 0.0 << 0.0;
}

void TestOxygenDissociation::agreesWithMeasuredBlood()
{
    constexpr double kSaturation = 0.0055; // Severinghaus, J Appl Physiol 1979;46:599
    QFETCH(const double, pressure_mmHg);
    QFETCH(const double, saturation);
    VERIFY_WITHIN(oxygenSaturation(pressure_mmHg), saturation, kSaturation);
}

// At 100 mmHg 150 g/L carry 1.36 ml/g times the saturation, and 3.1 ml/L are dissolved.
void TestOxygenDissociation::addsWhatIsDissolved()
{
    constexpr double kContent_mlPerL = 1e-9;
    VERIFY_WITHIN(oxygenContent_mlPerL(100.0, 150.0), 204.0 * oxygenSaturation(100.0) + 3.1,
                  kContent_mlPerL);
}

void TestOxygenDissociation::findsThePressureOfAContent()
{
    constexpr double kPressure_mmHg = 1e-5;
    for (const double pressure : {5.0, 30.0, 90.0, 400.0, 700.0})
        VERIFY_WITHIN(oxygenPressureOf(oxygenContent_mlPerL(pressure, 120.0), 120.0), pressure,
                      kPressure_mmHg);
}

CARINA_TEST(TestOxygenDissociation)

} // namespace carina::oxygen_dissociation_test

#include "tst_oxygen_dissociation.moc"
