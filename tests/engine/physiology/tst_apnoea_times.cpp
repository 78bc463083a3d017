#include "tests/engine/lungs/mechanics/within.h"
#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

namespace carina::apnoea_times_test
{

namespace
{

using test::Bed;

constexpr double kPreoxygenation_s = 240.0;

/// Breathes oxygen by a mask, which is taken away as the breathing stops.
void preoxygenate(Bed& bed)
{
    bed.holdMask(1.0);
    bed.run(kPreoxygenation_s);
    bed.care.gas.maskHeld = false;
}

double oxygenShare(const Bed& bed)
{
    const LungGas& lung = bed.body.state().gas.lungs[0];
    return lung.oxygen_ml / (lung.oxygen_ml + lung.carbonDioxide_ml + lung.nitrogen_ml);
}

double secondsTo(Bed& bed, double saturation)
{
    return bed.runWhile(900.0, [&] { return bed.saturation() > saturation; });
}

} // namespace

/// How long patients stay saturated without breathing.
class TestApnoeaTimes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lastsAsPublished_data();
    void lastsAsPublished();
    void fallsOffACliff_data();
    void fallsOffACliff();
    void isShortOnRoomAir_data();
    void isShortOnRoomAir();
    void fillsTheLungsWithOxygen();
    void lastsLongerWithOxygenAtTheMouth();
};

// Seconds to an arterial saturation of 90 %, one standard deviation either way: Patel et al., Can J
// Anaesth 1994;41:771 (children), Berthoud et al., Br J Anaesth 1991;67:464 (adults).
void TestApnoeaTimes::lastsAsPublished_data()
{
    QTest::addColumn<PatientBuild>("build");
    QTest::addColumn<double>("published");
    QTest::addColumn<double>("deviation_s");
    QTest::newRow("infant") << test::kInfant << 96.5 << 12.7;
    QTest::newRow("4 years") << test::kFourYears << 160.0 << 31.0;
    QTest::newRow("12 years") << test::kTwelve << 382.0 << 80.0;
    QTest::newRow("lean adult") << test::kLeanAdult << 595.0 << 142.0;
    QTest::newRow("obese adult") << test::kObese << 196.0 << 80.0;
}

void TestApnoeaTimes::lastsAsPublished()
{
    QFETCH(const PatientBuild, build);
    QFETCH(const double, published);
    QFETCH(const double, deviation_s);
    Bed bed{build};
    preoxygenate(bed);
    QVERIFY(bed.saturation() > 0.99);
    bed.stopBreathing();
    const double time_s = secondsTo(bed, 0.90);
    qInfo("90 %% after %.0f s", time_s);
    VERIFY_WITHIN(time_s, published, deviation_s);
}

void TestApnoeaTimes::fallsOffACliff_data()
{
    QTest::addColumn<PatientBuild>("build");
    QTest::newRow("12 years") << test::kTwelve;
    QTest::newRow("lean adult") << test::kLeanAdult;
    QTest::newRow("obese adult") << test::kObese;
}

void TestApnoeaTimes::fallsOffACliff()
{
    constexpr double kAbout40_s = 15.0;
    QFETCH(const PatientBuild, build);
    Bed bed{build};
    preoxygenate(bed);
    bed.stopBreathing();
    secondsTo(bed, 0.90);
    const double time_s = secondsTo(bed, 0.70);
    qInfo("70 %% %.0f s after 90 %%", time_s);
    VERIFY_WITHIN(time_s, 40.0, kAbout40_s);
}

void TestApnoeaTimes::isShortOnRoomAir_data()
{
    QTest::addColumn<PatientBuild>("build");
    QTest::newRow("12 years") << test::kTwelve;
    QTest::newRow("lean adult") << test::kLeanAdult;
}

void TestApnoeaTimes::isShortOnRoomAir()
{
    QFETCH(const PatientBuild, build);
    Bed bed{build};
    bed.run(60.0);
    QVERIFY(bed.saturation() > 0.96);
    bed.stopBreathing();
    const double time_s = secondsTo(bed, 0.90);
    qInfo("90 %% after %.0f s", time_s);
    QVERIFY2(time_s > 20.0 && time_s < 60.0, qPrintable(QString::number(time_s)));
}

// What Benumof et al. assume of a tight mask (Anesthesiology 1997;87:979).
void TestApnoeaTimes::fillsTheLungsWithOxygen()
{
    constexpr double kShare = 0.01;
    Bed bed{test::kLeanAdult};
    preoxygenate(bed);
    VERIFY_WITHIN(oxygenShare(bed), 0.87, kShare);
}

// Apnoeic oxygenation: what the blood takes up is replaced by what is at the mouth.
void TestApnoeaTimes::lastsLongerWithOxygenAtTheMouth()
{
    Bed bed{test::kLeanAdult};
    preoxygenate(bed);
    bed.care.gas.maskHeld = true;
    bed.stopBreathing();
    bed.run(700.0);
    QVERIFY2(bed.saturation() > 0.97, qPrintable(QString::number(bed.saturation())));
}

CARINA_TEST(TestApnoeaTimes)

} // namespace carina::apnoea_times_test

#include "tst_apnoea_times.moc"
