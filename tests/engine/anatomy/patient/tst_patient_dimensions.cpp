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
    void infantsWindpipeIsAsPublished_data();
    void infantsWindpipeIsAsPublished();
    void infantsWeighAsInTheGrowthStandards_data();
    void infantsWeighAsInTheGrowthStandards();
    void infantsHoldTheGasThatWasMeasured_data();
    void infantsHoldTheGasThatWasMeasured();
    void nothingJumpsAtSchoolAge_data();
    void nothingJumpsAtSchoolAge();
    void tubeFitsTheAge_data();
    void tubeFitsTheAge();
    void refusesWhomTheFormulasDoNotReach_data();
    void refusesWhomTheFormulasDoNotReach();
    void takesTheHeightsThatItNames();
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
    QTest::newRow("woman") << true << 162.0 << 12.0 << 9.7 << 10.0 << 21.0;
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
    // Air of 18.9 (2.1) by 17.7 (1.9) mm in men and 15.5 (1.3) by 15.3 (1.2) in women (CT of 100,
    // Lee et al. 1988), 20.0 (2.3) by 19.0 (2.0) and 16.5 (2.2) by 15.5 (1.8) (radiographs of 808,
    // Breatnach et al. 1984).
    const Length walls = 2.0 * (d.tracheaLength / of(40.0, 175.0).tracheaLength) * kMansTracheaWall;
    const double sagittal = inMillimetres(d.tracheaSagittal - walls);
    const double coronal = inMillimetres(d.tracheaCoronal - walls);
    QVERIFY(std::abs(sagittal - (female ? 15.5 : 18.9)) < (female ? 1.3 : 2.1));
    QVERIFY(std::abs(sagittal - (female ? 16.5 : 20.0)) < (female ? 2.2 : 2.3));
    QVERIFY(std::abs(coronal - (female ? 15.3 : 17.7)) < (female ? 1.2 : 1.9));
    QVERIFY(std::abs(coronal - (female ? 15.5 : 19.0)) < (female ? 1.8 : 2.0));
    // Within the cricoid it is narrower.
    QVERIFY(d.upperTrachea.sagittal < d.tracheaSagittal);
    QVERIFY(d.upperTrachea.coronal < d.tracheaCoronal);
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
    // The air, in Griscom and Wohl's table between 10 and 14 years: 11.6-13.0 by 11.8-13.3 mm.
    const Length walls = 2.0 * (child.tracheaLength / adult.tracheaLength) * kMansTracheaWall;
    const Length sagittal = child.tracheaSagittal - walls;
    const Length coronal = child.tracheaCoronal - walls;
    QVERIFY(sagittal > millimetres(11.6) && sagittal < millimetres(13.0));
    QVERIFY(coronal > millimetres(11.8) && coronal < millimetres(13.3));
    QCOMPARE(child.upperTrachea.sagittal, child.tracheaSagittal);
    QCOMPARE(child.upperTrachea.coronal, child.tracheaCoronal);
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

void TestPatientDimensions::infantsWindpipeIsAsPublished_data()
{
    QTest::addColumn<double>("age");
    QTest::addColumn<double>("height_cm");
    QTest::addColumn<double>("cords_cm");
    QTest::addColumn<double>("tolerance_cm");
    // 5.04 cm in 34 infants below three months (Ann Otol Rhinol Laryngol 2001;110:268).
    QTest::newRow("6 weeks") << 1.5 / 12.0 << 54.0 << 5.04 << 0.4;
    // 5.3 + 0.05 cm a month in 56 children of up to three years (Anesth Analg 2013;117:460).
    QTest::newRow("1 year") << 1.0 << 75.0 << 5.9 << 0.4;
    QTest::newRow("2 years") << 2.0 << 87.0 << 6.5 << 0.4;
    QTest::newRow("3 years") << 3.0 << 96.0 << 7.1 << 0.5;
}

/// The diameters of the air are 0.0070 h + 0.05 and 0.0065 h + 0.18 cm (Griscom et al., 34 children
/// up to six years), within two walls of less than a millimetre and a quarter.
void TestPatientDimensions::infantsWindpipeIsAsPublished()
{
    QFETCH(double, age);
    QFETCH(double, height_cm);
    QFETCH(double, cords_cm);
    QFETCH(double, tolerance_cm);
    const PatientDimensions d = of(age, height_cm);
    QVERIFY(std::abs(100.0 * d.cordsToCarina.si - cords_cm) < tolerance_cm);
    // The trachea's first ring lies 0.92 cm below the cords in the youngest of them.
    const double toTrachea_cm = 100.0 * (d.cordsToCarina - d.tracheaLength).si;
    QVERIFY(toTrachea_cm > 0.8 && toTrachea_cm < 1.5);
    const double sagittal = inMillimetres(d.tracheaSagittal) - (0.070 * height_cm + 0.5);
    const double coronal = inMillimetres(d.tracheaCoronal) - (0.065 * height_cm + 1.8);
    QVERIFY2(sagittal > 1.2 && sagittal < 2.4, qPrintable(QString::number(sagittal)));
    QVERIFY2(coronal > 1.2 && coronal < 2.4, qPrintable(QString::number(coronal)));
}

void TestPatientDimensions::infantsWeighAsInTheGrowthStandards_data()
{
    QTest::addColumn<double>("months");
    QTest::addColumn<double>("height_cm");
    QTest::addColumn<double>("weight_kg");
    // Medians of boys and girls (WHO growth standards).
    QTest::newRow("newborn") << 0.0 << 49.5 << 3.25;
    QTest::newRow("3 months") << 3.0 << 60.6 << 6.1;
    QTest::newRow("6 months") << 6.0 << 66.7 << 7.6;
    QTest::newRow("1 year") << 12.0 << 74.9 << 9.3;
    QTest::newRow("2 years") << 24.0 << 87.1 << 11.85;
    QTest::newRow("4 years") << 48.0 << 103.0 << 16.2;
}

void TestPatientDimensions::infantsWeighAsInTheGrowthStandards()
{
    constexpr double kTolerance = 0.03;
    QFETCH(double, months);
    QFETCH(double, height_cm);
    QFETCH(double, weight_kg);
    const double made_kg = of(months / 12.0, height_cm).weightInKilograms;
    QVERIFY2(std::abs(made_kg / weight_kg - 1.0) < kTolerance,
             qPrintable(QString::number(made_kg)));
}

void TestPatientDimensions::infantsHoldTheGasThatWasMeasured_data()
{
    QTest::addColumn<double>("months");
    QTest::addColumn<double>("length_cm");
    QTest::addColumn<double>("least_ml");
    QTest::addColumn<double>("usual_ml");
    QTest::addColumn<double>("most_ml");
    // Helium dilution by length, with 95 % of healthy infants (Eur Respir J 1995;8:492).
    QTest::newRow("50 cm") << 0.0 << 50.0 << 51.0 << 72.0 << 102.0;
    QTest::newRow("60 cm") << 2.5 << 60.0 << 81.0 << 114.0 << 161.0;
    QTest::newRow("70 cm") << 7.5 << 70.0 << 119.0 << 168.0 << 237.0;
    QTest::newRow("80 cm") << 16.0 << 80.0 << 166.0 << 236.0 << 333.0;
    QTest::newRow("90 cm") << 29.0 << 90.0 << 226.0 << 318.0 << 448.0;
}

void TestPatientDimensions::infantsHoldTheGasThatWasMeasured()
{
    constexpr double kTolerance = 0.12;
    QFETCH(double, months);
    QFETCH(double, length_cm);
    QFETCH(double, least_ml);
    QFETCH(double, usual_ml);
    QFETCH(double, most_ml);
    const double made_ml = inMillilitres(of(months / 12.0, length_cm).functionalResidualCapacity);
    QVERIFY(made_ml > least_ml && made_ml < most_ml);
    QVERIFY2(std::abs(made_ml / usual_ml - 1.0) < kTolerance, qPrintable(QString::number(made_ml)));
}

void TestPatientDimensions::nothingJumpsAtSchoolAge_data()
{
    QTest::addColumn<double>("height_cm");
    for (const double height_cm : {100.0, 116.0, 130.0})
        QTest::addRow("%.0f cm", height_cm) << height_cm;
}

/// An hour before it, a child has the figures of that age.
void TestPatientDimensions::nothingJumpsAtSchoolAge()
{
    constexpr double kHour_years = 1.0 / (24.0 * 365.0);
    constexpr double kTolerance = 1e-3;
    QFETCH(double, height_cm);
    for (const Habitus habitus : {Habitus::Slim, Habitus::Normal, Habitus::Obese}) {
        const PatientDimensions before = of(6.0 - kHour_years, height_cm, Sex::Male, habitus);
        const PatientDimensions at = of(6.0, height_cm, Sex::Male, habitus);
        for (const double ratio :
             {before.cordsToCarina / at.cordsToCarina, before.tracheaLength / at.tracheaLength,
              before.tracheaSagittal / at.tracheaSagittal,
              before.tracheaCoronal / at.tracheaCoronal, before.teethToCarina / at.teethToCarina,
              before.rightBronchus.length / at.rightBronchus.length,
              before.weightInKilograms / at.weightInKilograms,
              before.functionalResidualCapacity / at.functionalResidualCapacity,
              before.fatLayer / at.fatLayer})
            QVERIFY2(std::abs(ratio - 1.0) < kTolerance, qPrintable(QString::number(ratio)));
    }
}

void TestPatientDimensions::tubeFitsTheAge_data()
{
    QTest::addColumn<double>("age");
    QTest::addColumn<bool>("female");
    QTest::addColumn<double>("inner_mm");
    // Cuffed tubes of infants (Weiss et al. 2009).
    QTest::newRow("newborn: 3.0") << 0.0 << false << 3.0;
    QTest::newRow("7 months: 3.0") << 7.0 / 12.0 << true << 3.0;
    QTest::newRow("8 months: 3.5") << 8.0 / 12.0 << true << 3.5;
    QTest::newRow("1 year: 3.5") << 1.0 << false << 3.5;
    QTest::newRow("2 years: 4.0") << 2.0 << false << 4.0;
    QTest::newRow("4 years: 4.5") << 4.0 << true << 4.5;
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
    const LengthRange heights = heightRange(age);
    const PatientDimensions d =
        of(age, 50.0 * (heights.least.si + heights.most.si), female ? Sex::Female : Sex::Male);
    QVERIFY(std::abs(inMillimetres(d.tubeInnerDiameter) - inner_mm) < 1e-9);
}

void TestPatientDimensions::refusesWhomTheFormulasDoNotReach_data()
{
    QTest::addColumn<double>("age");
    QTest::addColumn<double>("height_cm");
    QTest::addColumn<bool>("good");
    QTest::newRow("before birth") << -0.01 << 50.0 << false;
    QTest::newRow("newborn") << 0.0 << 50.0 << true;
    QTest::newRow("newborn, too small") << 0.0 << 44.9 << false;
    QTest::newRow("newborn, too long") << 0.0 << 60.1 << false;
    QTest::newRow("one year") << 1.0 << 75.0 << true;
    QTest::newRow("one year, as tall as a man") << 1.0 << 175.0 << false;
    QTest::newRow("nearly six years") << 5.9 << 110.0 << true;
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

/// What is named as a limit is taken, and a centimetre beyond it is not.
void TestPatientDimensions::takesTheHeightsThatItNames()
{
    const auto isTaken = [](double age, int height_cm) {
        return dimensionsFor({age, metres(height_cm / 100.0), Sex::Female, Habitus::Normal})
            .has_value();
    };
    for (int months = 0; months <= 72; ++months) {
        const double age = months / 12.0;
        const LengthRange heights = heightRange(age);
        const int least_cm = int(std::lround(100.0 * heights.least.si));
        const int most_cm = int(std::lround(100.0 * heights.most.si));
        const QByteArray month = QByteArray::number(months);
        QVERIFY2(isTaken(age, least_cm) && !isTaken(age, least_cm - 1), month);
        QVERIFY2(isTaken(age, most_cm) && !isTaken(age, most_cm + 1), month);
        const std::string refusal =
            dimensionsFor({age, metres(3.0), Sex::Female, Habitus::Normal}).error().detail;
        const std::string named =
            std::to_string(least_cm) + " to " + std::to_string(most_cm) + " cm";
        QVERIFY2(refusal.find(named) != std::string::npos, refusal.c_str());
    }
    // On the line from 45 cm at birth to 65 cm at one year.
    QCOMPARE(std::lround(100.0 * heightRange(2.0 / 12.0).least.si), 49L);
    QCOMPARE(std::lround(100.0 * heightRange(0.25).least.si), 50L);
}

CARINA_TEST(TestPatientDimensions)

} // namespace carina::patient_dimensions_test

#include "tst_patient_dimensions.moc"
