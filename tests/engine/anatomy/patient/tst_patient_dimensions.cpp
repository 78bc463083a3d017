#include "engine/anatomy/patient/patient_dimensions.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>

namespace carina::patient_dimensions_test
{

class TestPatientDimensions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void teethToCarinaFollowsHeight_data();
    void teethToCarinaFollowsHeight();
    void airwayIsMadeToAMeasuredLength();
    void windpipeOfAnAdultIsAsPublished_data();
    void windpipeOfAnAdultIsAsPublished();
    void lungsFollowTheUsualWeight();
    void airwaysOfAChildGrowWithHeight();
    void boysAndGirlsAreAlikeUntilGirlsStop();
    void bronchiPartAsMeasured();
    void lobesHaveTheSharesOfPeople();
    void fatMakesTheBodyHeavyAndTheLungsSmall();
    void tubeFitsTheAge_data();
    void tubeFitsTheAge();
    void refusesWhomTheFormulasDoNotReach_data();
    void refusesWhomTheFormulasDoNotReach();
};

namespace
{

constexpr double kMillimetre = 1e-3;
constexpr std::array kPatients{BuiltinPatient::Adult, BuiltinPatient::TwelveYears};

PatientDimensions of(double age, double height_cm, Sex sex = Sex::Male,
                     Habitus habitus = Habitus::Normal)
{
    return dimensionsFor({age, millimetres(10.0 * height_cm), sex, habitus}).value();
}

} // namespace

void TestPatientDimensions::teethToCarinaFollowsHeight_data()
{
    QTest::addColumn<double>("age");
    QTest::addColumn<double>("height_cm");
    QTest::addColumn<bool>("female");
    QTest::addColumn<double>("metres");
    // 0.12 h + 5.2 cm; men 11.413 + 0.072 h, women 13.555 + 0.056 h.
    QTest::newRow("child of 150 cm") << 12.0 << 150.0 << false << 0.232;
    QTest::newRow("child of 120 cm") << 7.0 << 120.0 << true << 0.196;
    QTest::newRow("man of 175 cm") << 30.0 << 175.0 << false << 0.24013;
    QTest::newRow("woman of 162 cm") << 30.0 << 162.0 << true << 0.22627;
    QTest::newRow("boy of 16, halfway") << 16.0 << 170.0 << false << 0.5 * (0.256 + 0.23653);
}

void TestPatientDimensions::teethToCarinaFollowsHeight()
{
    QFETCH(double, age);
    QFETCH(double, height_cm);
    QFETCH(bool, female);
    QFETCH(double, metres);
    const PatientDimensions d = of(age, height_cm, female ? Sex::Female : Sex::Male);
    QVERIFY(std::abs(d.teethToCarina.si - metres) < 1e-9);
}

/// All lengths from the teeth to the main bronchi by one factor; the diameters and the rest stay.
void TestPatientDimensions::airwayIsMadeToAMeasuredLength()
{
    for (const BuiltinPatient patient : kPatients) {
        PatientParameters who = parametersOf(patient);
        const PatientDimensions usual = dimensionsFor(who).value();
        for (const double scale : {0.851, 0.95, 1.0, 1.149}) {
            who.teethToCarina = scale * usual.teethToCarina;
            const PatientDimensions made = dimensionsFor(who).value();
            QVERIFY(std::abs(made.teethToCarina / usual.teethToCarina - scale) < 1e-12);
            QVERIFY(std::abs(made.cordsToCarina / usual.cordsToCarina - scale) < 1e-12);
            QVERIFY(std::abs(made.tracheaLength / usual.tracheaLength - scale) < 1e-12);
            QVERIFY(std::abs(made.leftBronchus.length / usual.leftBronchus.length - scale) < 1e-12);
            QCOMPARE(made.tracheaSagittal, usual.tracheaSagittal);
            QCOMPARE(made.functionalResidualCapacity, usual.functionalResidualCapacity);
        }
        const LengthRange range = teethToCarinaRange(who).value();
        for (const Length beyond :
             {range.least - millimetres(0.1), range.most + millimetres(0.1)}) {
            who.teethToCarina = beyond;
            QCOMPARE(dimensionsFor(who).error().code, Errc::OutOfRange);
        }
        for (const Length end : {range.least, range.most}) {
            who.teethToCarina = end;
            QVERIFY(dimensionsFor(who).has_value());
        }
    }
}

void TestPatientDimensions::windpipeOfAnAdultIsAsPublished_data()
{
    QTest::addColumn<bool>("female");
    QTest::addColumn<double>("height_cm");
    QTest::addColumn<double>("cords_cm");
    QTest::addColumn<double>("trachea_cm");
    QTest::addColumn<double>("narrowest_mm");
    QTest::addColumn<double>("widest_mm");
    QTest::newRow("man") << false << 175.0 << 12.7 << 10.1 << 13.0 << 25.0;
    QTest::newRow("woman") << true << 162.0 << 12.0 << 9.4 << 10.0 << 21.0;
}

void TestPatientDimensions::windpipeOfAnAdultIsAsPublished()
{
    QFETCH(bool, female);
    QFETCH(double, height_cm);
    QFETCH(double, cords_cm);
    QFETCH(double, trachea_cm);
    QFETCH(double, narrowest_mm);
    QFETCH(double, widest_mm);
    const PatientDimensions d = of(40.0, height_cm, female ? Sex::Female : Sex::Male);
    QVERIFY(std::abs(d.cordsToCarina.si - 0.01 * cords_cm) < 1e-9);
    QVERIFY(std::abs(d.tracheaLength.si - 0.01 * trachea_cm) < 1e-9);
    for (const Length diameter : {d.tracheaCoronal, d.tracheaSagittal}) {
        QVERIFY(inMillimetres(diameter) > narrowest_mm);
        QVERIFY(inMillimetres(diameter) < widest_mm);
    }
    // Women's and men's MRI diameters are as 13.9 to 17.1 and 13.3 to 15.1.
    const PatientDimensions man = of(40.0, 175.0);
    if (female) {
        QVERIFY(std::abs(d.tracheaSagittal / man.tracheaSagittal - 13.9 / 17.1) < 0.01);
        QVERIFY(std::abs(d.tracheaCoronal / man.tracheaCoronal - 13.3 / 15.1) < 0.01);
    }
}

void TestPatientDimensions::lungsFollowTheUsualWeight()
{
    for (const BuiltinPatient patient : kPatients) {
        const PatientDimensions d = dimensionsOf(patient);
        const double residual = inMillilitres(d.functionalResidualCapacity) / d.weightInKilograms;
        QVERIFY(std::abs(residual - 30.0) < 0.05);
        QCOMPARE(d.rightLungShare, 0.525);
    }
    QVERIFY(std::abs(dimensionsOf(BuiltinPatient::Adult).weightInKilograms - 77.0) < 1e-9);
    QVERIFY(std::abs(dimensionsOf(BuiltinPatient::TwelveYears).weightInKilograms - 40.0) < 1e-9);
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

void TestPatientDimensions::boysAndGirlsAreAlikeUntilGirlsStop()
{
    const PatientDimensions boy = of(12.0, 150.0);
    const PatientDimensions girl = of(12.0, 150.0, Sex::Female);
    QCOMPARE(girl.cordsToCarina, boy.cordsToCarina);
    QCOMPARE(girl.tracheaCoronal, boy.tracheaCoronal);
    QCOMPARE(girl.teethToCarina, boy.teethToCarina);
    // At fourteen a girl has the windpipe of a woman of her height, a boy that of a child.
    QCOMPARE(of(14.0, 160.0, Sex::Female).tracheaCoronal,
             of(30.0, 160.0, Sex::Female).tracheaCoronal);
    QVERIFY(of(14.0, 160.0).tracheaCoronal < of(30.0, 160.0).tracheaCoronal);
    QCOMPARE(of(18.0, 160.0).tracheaCoronal, of(30.0, 160.0).tracheaCoronal);
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

void TestPatientDimensions::lobesHaveTheSharesOfPeople()
{
    // CT of 32 people: 17.9, 9.3, 26.5, 23.1, 23.2 %.
    const std::array published{0.179, 0.093, 0.265, 0.231, 0.232};
    const LobeShares lobes = dimensionsOf(BuiltinPatient::TwelveYears).lobes;
    const std::array shares{lobes.rightUpper, lobes.rightMiddle, lobes.rightLower, lobes.leftUpper,
                            lobes.leftLower};
    double sum = 0.0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        QVERIFY(std::abs(shares[i] - published[i]) < 0.03);
        sum += shares[i];
    }
    QVERIFY(std::abs(sum - 1.0) < 1e-12);
    QVERIFY(std::abs(shares[0] + shares[1] + shares[2] - 0.525) < 1e-12);
}

void TestPatientDimensions::fatMakesTheBodyHeavyAndTheLungsSmall()
{
    const PatientDimensions normal = of(40.0, 175.0);
    const PatientDimensions obese = of(40.0, 175.0, Sex::Male, Habitus::Obese);
    const PatientDimensions slim = of(40.0, 175.0, Sex::Male, Habitus::Slim);
    QVERIFY(std::abs(obese.weightInKilograms - 127.0) < 0.5);
    QVERIFY(
        std::abs(inMillilitres(obese.functionalResidualCapacity) / obese.weightInKilograms - 11.0)
        < 0.05);
    QVERIFY(slim.weightInKilograms < normal.weightInKilograms);
    QCOMPARE(slim.functionalResidualCapacity, normal.functionalResidualCapacity);
    QVERIFY(slim.fatLayer < normal.fatLayer && normal.fatLayer < obese.fatLayer);
    QVERIFY(of(12.0, 150.0).fatLayer < normal.fatLayer);
    QCOMPARE(obese.tracheaLength, normal.tracheaLength);
}

void TestPatientDimensions::tubeFitsTheAge_data()
{
    QTest::addColumn<double>("age");
    QTest::addColumn<bool>("female");
    QTest::addColumn<double>("inner_mm");
    QTest::newRow("6 years: 5.0") << 6.0 << false << 5.0;
    QTest::newRow("12 years: 6.5") << 12.0 << false << 6.5;
    QTest::newRow("girl of 12") << 12.0 << true << 6.5;
    QTest::newRow("man") << 30.0 << false << 8.0;
    QTest::newRow("woman") << 30.0 << true << 7.0;
}

void TestPatientDimensions::tubeFitsTheAge()
{
    QFETCH(double, age);
    QFETCH(bool, female);
    QFETCH(double, inner_mm);
    const PatientDimensions d = of(age, 150.0, female ? Sex::Female : Sex::Male);
    QVERIFY(std::abs(inMillimetres(d.tubeInnerDiameter) - inner_mm) < 1e-9);
}

void TestPatientDimensions::refusesWhomTheFormulasDoNotReach_data()
{
    QTest::addColumn<double>("age");
    QTest::addColumn<double>("height_cm");
    QTest::addColumn<bool>("good");
    QTest::newRow("an infant") << 5.9 << 110.0 << false;
    QTest::newRow("six years") << 6.0 << 110.0 << true;
    QTest::newRow("ninety years") << 90.0 << 170.0 << true;
    QTest::newRow("older") << 90.1 << 170.0 << false;
    QTest::newRow("no age") << std::nan("") << 170.0 << false;
    QTest::newRow("too small") << 30.0 << 99.9 << false;
    QTest::newRow("one metre") << 30.0 << 100.0 << true;
    QTest::newRow("2.1 metres") << 30.0 << 210.0 << true;
    QTest::newRow("too tall") << 30.0 << 210.1 << false;
    QTest::newRow("no height") << 30.0 << std::nan("") << false;
}

void TestPatientDimensions::refusesWhomTheFormulasDoNotReach()
{
    QFETCH(double, age);
    QFETCH(double, height_cm);
    QFETCH(bool, good);
    const auto d = dimensionsFor({age, metres(height_cm / 100.0), Sex::Male, Habitus::Normal});
    QCOMPARE(d.has_value(), good);
    if (!good)
        QVERIFY(d.error().code == Errc::OutOfRange);
}

CARINA_TEST(TestPatientDimensions)

} // namespace carina::patient_dimensions_test

#include "tst_patient_dimensions.moc"
