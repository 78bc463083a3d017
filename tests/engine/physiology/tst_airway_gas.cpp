#include "engine/physiology/airway_gas.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

namespace carina::airway_gas_test
{

namespace
{

constexpr GasShares kAlveolar{0.15, 0.05};
constexpr double kDeadSpace_ml = 150.0;
constexpr double kRest_ml = 1000.0; // of each lung

AirwayGas filled()
{
    AirwayGas gas;
    fill(gas, {kRest_ml, kRest_ml}, kAlveolar);
    return gas;
}

GasMove towards(double volume_ml)
{
    GasMove how;
    how.volume_ml = {volume_ml, volume_ml};
    how.passable_ml = {1e3, 1e3};
    how.deadSpace_ml = kDeadSpace_ml;
    return how;
}

/// Breathes in or out, in steps of 5 ml at each lung.
void breathe(AirwayGas& gas, double from_ml, double to_ml)
{
    const double step = to_ml > from_ml ? 5.0 : -5.0;
    for (double volume = from_ml; (to_ml - volume) * step > 0.0; volume += step)
        move(gas, towards(volume + step));
}

double carbonDioxide_ml(const AirwayGas& gas)
{
    double sum = 0.0;
    for (const LungGas& lung : gas.lungs)
        sum += lung.carbonDioxide_ml;
    for (const GasShares& cell : gas.airway)
        sum += kDeadSpace_ml / double(kAirwayCells) * cell.carbonDioxide;
    return sum;
}

} // namespace

/// Gas on its way between mouth and lungs.
class TestAirwayGas : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void losesNothingWhileItInhales();
    void exhalesTheDeadSpaceFirst();
    void drawsInWhatTheBloodTakesUp();
    void passesNothingWhereBronchiAreShut();
};

void TestAirwayGas::losesNothingWhileItInhales()
{
    constexpr double kGas_ml = 1e-9;
    AirwayGas gas = filled();
    const double before = carbonDioxide_ml(gas);
    breathe(gas, 1000.0, 1040.0); // less than the dead space: room air stays in it
    VERIFY_WITHIN(totalOf(gas.lungs[0]), 1040.0, kGas_ml);
    VERIFY_WITHIN(carbonDioxide_ml(gas), before, 1.0); // it has a smeared front
}

// After a breath of room air: none of the lungs' gas comes before most of the dead space has left,
// and half of it as the dead space has left.
void TestAirwayGas::exhalesTheDeadSpaceFirst()
{
    AirwayGas gas = filled();
    breathe(gas, kRest_ml, 1250.0);
    const double end = sharesOf(gas.lungs[0]).carbonDioxide;
    QVERIFY(gas.airway.back().carbonDioxide < 0.001);
    breathe(gas, 1250.0, 1250.0 - 35.0);
    QVERIFY(gas.airway.front().carbonDioxide < 0.1 * end);
    breathe(gas, 1250.0 - 35.0, 1250.0 - 75.0);
    const double half = gas.airway.front().carbonDioxide / end;
    QVERIFY2(half > 0.35 && half < 0.65, qPrintable(QString::number(half)));
    breathe(gas, 1250.0 - 75.0, 1250.0 - 150.0);
    QVERIFY(gas.airway.front().carbonDioxide > 0.99 * end);
}

void TestAirwayGas::drawsInWhatTheBloodTakesUp()
{
    constexpr double kGas_ml = 1e-9;
    AirwayGas gas = filled();
    gas.lungs[1].oxygen_ml -= 4.0;
    VERIFY_WITHIN(move(gas, towards(kRest_ml)), 4.0, kGas_ml);
    VERIFY_WITHIN(totalOf(gas.lungs[1]), kRest_ml, kGas_ml);
}

void TestAirwayGas::passesNothingWhereBronchiAreShut()
{
    AirwayGas gas = filled();
    gas.lungs[1].oxygen_ml -= 4.0;
    GasMove how = towards(kRest_ml);
    how.passable_ml[1] = 0.0;
    QCOMPARE(move(gas, how), 0.0);
    QVERIFY(totalOf(gas.lungs[1]) < kRest_ml - 3.9);
}

CARINA_TEST(TestAirwayGas)

} // namespace carina::airway_gas_test

#include "tst_airway_gas.moc"
