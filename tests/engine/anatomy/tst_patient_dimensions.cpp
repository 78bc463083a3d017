#include "engine/anatomy/patient_dimensions.h"

#include <QTest>
#include <array>
#include <cmath>

using namespace carina;

class TestPatientDimensions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void teethToCarinaFollowsHeight();
    void breathingFollowsWeightAndRate();
    void airwaysOfAChildGrowWithHeight();
    void bronchiPartAsMeasured();
};

namespace
{

constexpr double kMillimetre = 1e-3;
constexpr std::array kPatients{BuiltinPatient::Adult, BuiltinPatient::TwelveYears};

} // namespace

void TestPatientDimensions::teethToCarinaFollowsHeight()
{
    // 0.12 h + 5.2 cm: 26.2 cm at 175 cm and 23.2 cm at 150 cm.
    QVERIFY(std::abs(dimensionsOf(BuiltinPatient::Adult).teethToCarina.si - 0.262) < 1e-12);
    QVERIFY(std::abs(dimensionsOf(BuiltinPatient::TwelveYears).teethToCarina.si - 0.232) < 1e-12);
}

void TestPatientDimensions::breathingFollowsWeightAndRate()
{
    for (const BuiltinPatient patient : kPatients) {
        const PatientDimensions d = dimensionsOf(patient);
        const double mlPerKilogram = inMillilitres(d.tidalVolume) / d.weightInKilograms;
        QVERIFY(std::abs(mlPerKilogram - 7.0) < 0.05);
        const double residual = inMillilitres(d.functionalResidualCapacity) / d.weightInKilograms;
        QVERIFY(std::abs(residual - 30.0) < 0.05);
        const double inspired = 0.0125 * (inPerMinute(d.breathingRate) + 4.0) + 0.125;
        QVERIFY(std::abs(d.inspiratoryFraction - inspired) < 0.005);
        QCOMPARE(d.rightLungShare, 0.525);
    }
    QCOMPARE(inPerMinute(dimensionsOf(BuiltinPatient::Adult).breathingRate), 16.0);
    QCOMPARE(inPerMinute(dimensionsOf(BuiltinPatient::TwelveYears).breathingRate), 19.0);
}

void TestPatientDimensions::airwaysOfAChildGrowWithHeight()
{
    const PatientDimensions adult = dimensionsOf(BuiltinPatient::Adult);
    const PatientDimensions child = dimensionsOf(BuiltinPatient::TwelveYears);
    // Published exponents of length on height: 1.22 to 1.37.
    const double ratio = 150.0 / 175.0;
    for (const double share :
         {child.tracheaLength / adult.tracheaLength, child.cordsToCarina / adult.cordsToCarina,
          child.leftBronchus.length / adult.leftBronchus.length}) {
        QVERIFY(share < std::pow(ratio, 1.22));
        QVERIFY(share > std::pow(ratio, 1.37));
    }
    // Griscom and Wohl's table between 10 and 14 years: 11.6-13.0 by 11.8-13.3 mm.
    QVERIFY(child.tracheaSagittal.si > 11.6 * kMillimetre);
    QVERIFY(child.tracheaSagittal.si < 13.0 * kMillimetre);
    QVERIFY(child.tracheaCoronal.si > 11.8 * kMillimetre);
    QVERIFY(child.tracheaCoronal.si < 13.3 * kMillimetre);
}

void TestPatientDimensions::bronchiPartAsMeasured()
{
    for (const BuiltinPatient patient : kPatients) {
        const PatientDimensions d = dimensionsOf(patient);
        const double between =
            inDegrees(d.rightBronchus.fromTrachea) + inDegrees(d.leftBronchus.fromTrachea);
        QVERIFY(std::abs(between - 73.1) < 0.5); // interbronchial 73.1 (12.7) degrees
        QVERIFY(d.rightBronchus.diameter > d.leftBronchus.diameter);
        QVERIFY(d.leftBronchus.length / d.rightBronchus.length == 2.0);
    }
}

QTEST_APPLESS_MAIN(TestPatientDimensions)
#include "tst_patient_dimensions.moc"
