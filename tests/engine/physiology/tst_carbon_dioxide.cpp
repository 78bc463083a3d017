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
};

void TestCarbonDioxide::risesInApnoea_data()
{
    QTest::addColumn<PatientBuild>("build");
    QTest::newRow("12 years") << test::kTwelve;
    QTest::newRow("lean adult") << test::kLeanAdult;
}

// 8 to 15 mmHg in the first minute, in arterial blood and in the first breath that follows; then 3
// to 4 in each minute (Eger and Severinghaus, Anesthesiology 1961;22:419). Fresh gas of the first
// breath dilutes what it shows.
void TestCarbonDioxide::risesInApnoea()
{
    constexpr double kDiluted = 0.8;
    QFETCH(const PatientBuild, build);
    const Rise first = riseInApnoea(build, 60.0);
    expectWithin(first.arterial_mmHg, 8.0, 15.0);
    expectWithin(first.endTidal_mmHg, 8.0, 15.0);
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

CARINA_TEST(TestCarbonDioxide)

} // namespace carina::carbon_dioxide_test

#include "tst_carbon_dioxide.moc"
