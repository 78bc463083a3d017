#include "tests/engine/lungs/mechanics/within.h"
#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::circulation_test
{

namespace
{

using test::Bed;

struct Response {
    double heartRate; ///< over that before the blade
    double pressure;
};

/// Laryngoscopy of a minute in an adult who sleeps and is relaxed.
Response responseAfter(double fentanyl_mg)
{
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.body.give({DrugKind::Fentanyl, fentanyl_mg});
    bed.run(150.0);
    bed.body.give({DrugKind::Propofol, 154.0});
    bed.body.give({DrugKind::Rocuronium, 92.0});
    bed.squeezeBag(12.0, 500.0);
    bed.run(90.0);
    const Response before{bed.heartRate_perMin(), bed.mean_mmHg()};
    bed.care.bladeInMouth = true;
    bed.apply();
    Response most{0.0, 0.0};
    bed.runWhile(60.0, [&] {
        most.heartRate = std::max(most.heartRate, bed.heartRate_perMin());
        most.pressure = std::max(most.pressure, bed.mean_mmHg());
        return true;
    });
    return {most.heartRate / before.heartRate, most.pressure / before.pressure};
}

} // namespace

/// Heart rate and blood pressure.
class TestCirculation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isNormalForTheAge_data();
    void isNormalForTheAge();
    void answersLaryngoscopy();
    void isDulledByFentanyl();
    void calmsDownWithinMinutes();
    void quickensThenFailsInHypoxia();
    void recoversFromAShortHypoxia();
    void fallsUnderTension();
};

// Heart rate within the tenth to ninetieth centile of Fleming (Lancet 2011;377:1011), systolic
// pressure within the range that APLS gives.
void TestCirculation::isNormalForTheAge_data()
{
    QTest::addColumn<PatientBuild>("build");
    QTest::addColumn<double>("leastRate");
    QTest::addColumn<double>("mostRate");
    QTest::addColumn<double>("leastSystolic");
    QTest::addColumn<double>("mostSystolic");
    QTest::newRow("newborn") << test::kNewborn << 107.0 << 148.0 << 60.0 << 90.0;
    QTest::newRow("infant") << test::kInfant << 103.0 << 140.0 << 80.0 << 100.0;
    QTest::newRow("12 years") << test::kTwelve << 66.0 << 98.0 << 90.0 << 120.0;
    QTest::newRow("lean adult") << test::kLeanAdult << 60.0 << 90.0 << 100.0 << 135.0;
}

void TestCirculation::isNormalForTheAge()
{
    QFETCH(const PatientBuild, build);
    QFETCH(const double, leastRate);
    QFETCH(const double, mostRate);
    QFETCH(const double, leastSystolic);
    QFETCH(const double, mostSystolic);
    Bed bed{build};
    bed.run(60.0);
    const Vitals vitals = bed.body.vitals();
    QVERIFY(bed.heartRate_perMin() >= leastRate && bed.heartRate_perMin() <= mostRate);
    QVERIFY(inMmHg(vitals.systolic) >= leastSystolic && inMmHg(vitals.systolic) <= mostSystolic);
    QVERIFY(vitals.diastolic < vitals.mean && vitals.mean < vitals.systolic);
    VERIFY_WITHIN(inMmHg(vitals.mean),
                  inMmHg(vitals.diastolic)
                      + (vitals.systolic - vitals.diastolic).si / 3.0 / kPascalsPerMmHg,
                  1e-9);
}

void TestCirculation::answersLaryngoscopy()
{
    const Response response = responseAfter(0.0);
    QVERIFY2(response.heartRate > 1.18 && response.heartRate < 1.32,
             qPrintable(QString::number(response.heartRate)));
    QVERIFY2(response.pressure > 1.18 && response.pressure < 1.36,
             qPrintable(QString::number(response.pressure)));
}

// 3 ug/kg leave less than half of the rise.
void TestCirculation::isDulledByFentanyl()
{
    const Response response = responseAfter(0.231);
    QVERIFY2(response.heartRate < 1.12, qPrintable(QString::number(response.heartRate)));
    QVERIFY2(response.pressure < 1.12, qPrintable(QString::number(response.pressure)));
}

void TestCirculation::calmsDownWithinMinutes()
{
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.run(30.0);
    const double quiet = bed.heartRate_perMin();
    bed.care.bladeInMouth = true;
    bed.apply();
    bed.run(45.0);
    QVERIFY(bed.heartRate_perMin() > 1.18 * quiet);
    bed.care.bladeInMouth = false;
    bed.apply();
    bed.run(60.0);
    QVERIFY(bed.heartRate_perMin() > 1.1 * quiet);
    bed.run(360.0);
    QVERIFY(bed.heartRate_perMin() < 1.05 * quiet);
}

void TestCirculation::quickensThenFailsInHypoxia()
{
    Bed bed{test::kLeanAdult};
    bed.run(30.0);
    const double quiet = bed.heartRate_perMin();
    bed.stopBreathing();
    bed.runWhile(300.0, [&] { return bed.saturation() > 0.72; });
    QVERIFY2(bed.heartRate_perMin() > 1.15 * quiet,
             qPrintable(QString::number(bed.heartRate_perMin())));
    bed.runWhile(300.0, [&] { return bed.saturation() > 0.45; });
    QVERIFY2(bed.heartRate_perMin() < 0.7 * quiet,
             qPrintable(QString::number(bed.heartRate_perMin())));
    QVERIFY(!bed.body.state().circulation.arrested);
    const double late_s =
        bed.runWhile(900.0, [&] { return !bed.body.state().circulation.arrested; });
    QVERIFY2(late_s > 60.0 && late_s < 600.0, qPrintable(QString::number(late_s)));
}

void TestCirculation::recoversFromAShortHypoxia()
{
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.stopBreathing();
    bed.care.gas.maskHeld = false;
    bed.apply();
    bed.runWhile(600.0, [&] { return bed.saturation() > 0.55; });
    bed.holdMask(1.0);
    bed.squeezeBag(15.0, 500.0);
    bed.run(180.0);
    QVERIFY(bed.saturation() > 0.98);
    QVERIFY(bed.heartRate_perMin() > 65.0 && bed.mean_mmHg() > 80.0);
}

// Hypotension and a fast heart within minutes of ventilation.
void TestCirculation::fallsUnderTension()
{
    Bed bed{test::kLeanAdult};
    bed.stopBreathing();
    bed.intubate(TubeSeat::Trachea, 1.0);
    bed.squeezeBag(14.0, 500.0);
    bed.run(400.0); // used to the tube
    const double rate = bed.heartRate_perMin();
    const double mean = bed.mean_mmHg();
    bed.letLungsSuffer({{ConditionKind::TensionPneumothorax, 0.8, ConditionSide::Left}});
    bed.run(180.0);
    QVERIFY2(bed.mean_mmHg() < 0.75 * mean, qPrintable(QString::number(bed.mean_mmHg())));
    QVERIFY2(bed.heartRate_perMin() > 1.25 * rate,
             qPrintable(QString::number(bed.heartRate_perMin())));
    bed.letLungsSuffer({});
    bed.run(120.0);
    QVERIFY2(bed.mean_mmHg() > 0.9 * mean, qPrintable(QString::number(bed.mean_mmHg())));
}

CARINA_TEST(TestCirculation)

} // namespace carina::circulation_test

#include "tst_circulation.moc"
