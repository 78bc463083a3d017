#include "engine/physiology/capnograph.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <vector>

namespace carina::capnogram_test
{

namespace
{

using test::Bed;

constexpr double kBreath_s = 5.0; // a bag at 12 per minute

Bed ventilated(const LungConditions& conditions = {})
{
    Bed bed{test::kLeanAdult};
    bed.stopBreathing();
    bed.intubate(TubeSeat::Trachea, 0.5);
    bed.squeezeBag(12.0, 500.0);
    bed.letLungsSuffer(conditions);
    bed.run(60.0);
    return bed;
}

/// One breath of the curve, from where carbon dioxide first rises.
std::vector<double> breathOf(Bed& bed)
{
    bed.runWhile(2.0 * kBreath_s, [&] { return bed.exhaled_mmHg() > 0.5; });
    bed.runWhile(2.0 * kBreath_s, [&] { return bed.exhaled_mmHg() < 0.5; });
    std::vector<double> curve;
    bed.runWhile(kBreath_s, [&] {
        curve.push_back(bed.exhaled_mmHg());
        return true;
    });
    return curve;
}

double highestOf(const std::vector<double>& curve) { return std::ranges::max(curve); }

/// Seconds in which the curve rises from a tenth to nine tenths of its highest value.
double riseTime_s(const std::vector<double>& curve)
{
    const double highest = highestOf(curve);
    const auto first = [&](double share) {
        const auto found =
            std::ranges::find_if(curve, [&](double value) { return value >= share * highest; });
        return double(found - curve.begin()) * kBodyStep;
    };
    return first(0.9) - first(0.1);
}

} // namespace

/// The capnograph's curve, as the tube and the lungs make it.
class TestCapnogram : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasFourPhases();
    void isLateByTheSampleLine();
    void risesLikeASharksFinInObstruction_data();
    void risesLikeASharksFinInObstruction();
    void isLowAndSlantedPastAKink();
    void isLowerWithALeak();
    void fadesFromTheStomachWithinSevenBreaths();
    void countsQuietBreaths_data();
    void countsQuietBreaths();
    void hasNothingWithoutMaskAndTube();
    void forgetsAfterApnoea();
    void isFlatInApnoea_data();
    void isFlatInApnoea();
    void keepsThePlateauOfASlowBreath();
};

// Baseline without carbon dioxide, a steep rise, a plateau that hardly slopes, and a steep fall.
void TestCapnogram::hasFourPhases()
{
    Bed bed = ventilated();
    const std::vector<double> curve = breathOf(bed);
    const double highest = highestOf(curve);
    QVERIFY2(highest > 35.0 && highest < 45.0, qPrintable(QString::number(highest)));
    QVERIFY2(riseTime_s(curve) < 0.6, qPrintable(QString::number(riseTime_s(curve))));
    const auto onPlateau =
        std::ranges::count_if(curve, [&](double value) { return value > 0.9 * highest; });
    QVERIFY2(double(onPlateau) * kBodyStep > 0.3 * kBreath_s,
             qPrintable(QString::number(onPlateau)));
    const auto atBaseline = std::ranges::count_if(curve, [](double value) { return value < 1.0; });
    QVERIFY2(double(atBaseline) * kBodyStep > 0.2 * kBreath_s,
             qPrintable(QString::number(atBaseline)));
    QVERIFY(std::ranges::all_of(curve, [](double value) { return value >= 0.0; }));
}

// The line holds 1.5 s, the sensor needs another tenth.
void TestCapnogram::isLateByTheSampleLine()
{
    constexpr double kLate_s = 0.4;
    Bed bed = ventilated();
    bed.runWhile(2.0 * kBreath_s, [&] { return bed.body.state().capnograph.connector_mmHg > 0.5; });
    bed.runWhile(2.0 * kBreath_s,
                 [&] { return bed.body.state().capnograph.connector_mmHg < 20.0; });
    VERIFY_WITHIN(bed.runWhile(5.0, [&] { return bed.exhaled_mmHg() < 20.0; }), 1.6, kLate_s);
}

void TestCapnogram::risesLikeASharksFinInObstruction_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("asthma") << int(ConditionKind::Asthma);
    QTest::newRow("COPD") << int(ConditionKind::Copd);
}

void TestCapnogram::risesLikeASharksFinInObstruction()
{
    QFETCH(const int, kind);
    Bed healthy = ventilated();
    Bed ill = ventilated({{ConditionKind(kind), 0.7, ConditionSide::Both}});
    const double quick_s = riseTime_s(breathOf(healthy));
    const double slow_s = riseTime_s(breathOf(ill));
    QVERIFY2(slow_s > 2.0 * quick_s, qPrintable(QString::number(slow_s)));
}

void TestCapnogram::isLowAndSlantedPastAKink()
{
    Bed open = ventilated();
    Bed kinked = ventilated();
    kinked.care.tube.obstruction = 0.7;
    kinked.apply();
    kinked.run(20.0);
    const std::vector<double> usual = breathOf(open);
    const std::vector<double> flat = breathOf(kinked);
    QVERIFY(highestOf(flat) < 0.85 * highestOf(usual));
    QVERIFY(highestOf(flat) > 0.3 * highestOf(usual));
    QVERIFY2(riseTime_s(flat) > 1.3 * riseTime_s(usual),
             qPrintable(QString::number(riseTime_s(flat))));
}

void TestCapnogram::isLowerWithALeak()
{
    Bed tight = ventilated();
    Bed leaking = ventilated();
    leaking.care.tube.leak = 0.4;
    leaking.apply();
    leaking.run(20.0);
    const double share = highestOf(breathOf(leaking)) / highestOf(breathOf(tight));
    QVERIFY2(share > 0.4 && share < 0.8, qPrintable(QString::number(share)));
}

// Amplitude of the n-th breath: A0 exp(-n / 1.5), never above 15 mmHg, and no breath by the
// seventh. No oxygen reaches the lungs.
void TestCapnogram::fadesFromTheStomachWithinSevenBreaths()
{
    constexpr double kRatio = 0.02;
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.run(120.0);
    bed.stopBreathing();
    bed.intubate(TubeSeat::Oesophagus, 1.0);
    bed.care.stomachBreaths = perMinute(12.0);
    bed.apply();
    bed.run(3.0); // the last exhaled gas of the lungs has left the line
    std::vector<double> amplitudes;
    for (int breath = 0; breath < 7; ++breath) {
        double highest = 0.0;
        bed.runWhile(kBreath_s, [&] {
            highest = std::max(highest, bed.exhaled_mmHg());
            return true;
        });
        amplitudes.push_back(highest);
    }
    const double first = std::exp(-1.0 / 1.5); // of A0
    QVERIFY(amplitudes.front() < first * 15.0 && amplitudes.front() > 1.0);
    for (std::size_t i = 2; i < amplitudes.size(); ++i)
        VERIFY_WITHIN(amplitudes[i] / amplitudes[i - 1], std::exp(-1.0 / 1.5), kRatio);
    QVERIFY(amplitudes.back() < 0.5);
    const double oxygen_ml = bed.body.state().gas.lungs[0].oxygen_ml;
    bed.run(60.0);
    QVERIFY(bed.body.state().gas.lungs[0].oxygen_ml < oxygen_ml - 50.0);
    QCOMPARE(bed.body.vitals().capnographRate.si, 0.0);
    QCOMPARE(bed.endTidal_mmHg(), 0.0);
}

void TestCapnogram::countsQuietBreaths_data()
{
    QTest::addColumn<PatientBuild>("build");
    QTest::newRow("newborn") << test::kNewborn;
    QTest::newRow("infant") << test::kInfant;
    QTest::newRow("12 years") << test::kTwelve;
    QTest::newRow("lean adult") << test::kLeanAdult;
    QTest::newRow("obese adult") << test::kObese;
}

// 35 to 45 mmHg in quiet breathing at any age, at once and for long.
void TestCapnogram::countsQuietBreaths()
{
    constexpr double kRate_perMin = 0.5;
    QFETCH(const PatientBuild, build);
    Bed bed{build};
    bed.holdMask(0.21);
    for (const double seconds : {60.0, 540.0}) {
        bed.run(seconds);
        QVERIFY2(bed.endTidal_mmHg() > 35.0 && bed.endTidal_mmHg() < 45.0,
                 qPrintable(QString::number(bed.endTidal_mmHg())));
        VERIFY_WITHIN(inPerMinute(bed.body.vitals().capnographRate),
                      inPerMinute(restingPattern(build).rate), kRate_perMin);
    }
}

void TestCapnogram::hasNothingWithoutMaskAndTube()
{
    Bed bed{test::kLeanAdult};
    bed.run(30.0);
    QVERIFY(!bed.body.vitals().exhaledCO2);
    QVERIFY(!bed.body.vitals().endTidalCO2);
    QCOMPARE(bed.body.vitals().capnographRate.si, 0.0);
    bed.holdMask(1.0);
    bed.run(30.0);
    QVERIFY(bed.body.vitals().exhaledCO2.has_value());
    QVERIFY(bed.endTidal_mmHg() > 30.0);
}

void TestCapnogram::forgetsAfterApnoea()
{
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.run(60.0);
    bed.stopBreathing();
    bed.run(15.0);
    QVERIFY(bed.endTidal_mmHg() > 30.0); // still that of the last breath
    bed.run(15.0);
    QCOMPARE(bed.endTidal_mmHg(), 0.0);
    QCOMPARE(bed.body.vitals().capnographRate.si, 0.0);
}

void TestCapnogram::isFlatInApnoea_data()
{
    QTest::addColumn<bool>("isVentilated");
    QTest::newRow("beneath a mask") << false;
    QTest::newRow("through a tube") << true;
}

// The alarm is about a curve without breaths: a line near zero, that holds no plateau.
void TestCapnogram::isFlatInApnoea()
{
    constexpr double kFlat_mmHg = 5.0;
    QFETCH(const bool, isVentilated);
    Bed bed = isVentilated ? ventilated() : Bed{test::kLeanAdult};
    if (!isVentilated)
        bed.holdMask(1.0);
    bed.run(60.0);
    bed.stopBreathing();
    bed.squeezeBag(0.0, 0.0);
    bed.run(kNoBreathTime + 1.0);
    QVERIFY2(bed.exhaled_mmHg() < kFlat_mmHg, qPrintable(QString::number(bed.exhaled_mmHg())));
}

// At 6 breaths a minute, with a long pause behind each.
void TestCapnogram::keepsThePlateauOfASlowBreath()
{
    constexpr double kPlateau_mmHg = 25.0;
    Bed bed = ventilated();
    bed.squeezeBag(6.0, 700.0);
    bed.run(60.0);
    double onPlateau_s = 0.0;
    bed.runWhile(10.0, [&] {
        onPlateau_s += bed.exhaled_mmHg() > kPlateau_mmHg ? kBodyStep : 0.0;
        return true;
    });
    QVERIFY2(onPlateau_s > 5.0, qPrintable(QString::number(onPlateau_s)));
}

CARINA_TEST(TestCapnogram)

} // namespace carina::capnogram_test

#include "tst_capnogram.moc"
