#include "engine/session/respiration/introduced_patient.h"

#include "engine/session/respiration/respiration_timeline.h"
#include "tests/support/test_class.h"

namespace carina::introduced_patient_test
{

class TestIntroducedPatient : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void breathesQuietlyAsEveryExperimentDoes_data();
    void breathesQuietlyAsEveryExperimentDoes();
    void startsAsTheBuiltInChild();
};

void TestIntroducedPatient::breathesQuietlyAsEveryExperimentDoes_data()
{
    QTest::addColumn<double>("years");
    QTest::addColumn<double>("height_m");
    QTest::addColumn<int>("habitus");
    QTest::newRow("6 years") << 6.0 << 1.16 << int(Habitus::Normal);
    QTest::newRow("12 years") << 12.0 << 1.50 << int(Habitus::Normal);
    QTest::newRow("16 years") << 16.0 << 1.70 << int(Habitus::Normal);
    QTest::newRow("adult") << 30.0 << 1.75 << int(Habitus::Normal);
    QTest::newRow("slim") << 30.0 << 1.75 << int(Habitus::Slim);
    QTest::newRow("obese") << 30.0 << 1.75 << int(Habitus::Obese);
    QTest::newRow("80 years") << 80.0 << 1.70 << int(Habitus::Normal);
}

/// What the programs of a session fold is what the experiments of the lab breathe.
void TestIntroducedPatient::breathesQuietlyAsEveryExperimentDoes()
{
    QFETCH(const double, years);
    QFETCH(const double, height_m);
    QFETCH(const int, habitus);
    const PatientBuild build =
        buildOf(dimensionsFor({years, metres(height_m), Sex::Female, Habitus(habitus)}).value());
    RespirationTimeline timeline;
    for (const FactBody& body : introducedPatient(build)) {
        if (const auto* told = std::get_if<fact::PatientBuildSet>(&body))
            timeline.setBuild({}, told->build);
        else if (const auto* rate = std::get_if<fact::BreathingRateSet>(&body))
            timeline.setRate({}, rate->rate);
        else if (const auto* volume = std::get_if<fact::TidalVolumeSet>(&body))
            timeline.setTidalVolume({}, volume->tidalVolume);
        else
            timeline.setInspiratoryFraction({},
                                            std::get<fact::InspiratoryFractionSet>(body).fraction);
    }
    const RespiratorySettings told = timeline.settingsAt({});
    QVERIFY(told.build == build);
    QVERIFY(told.pattern == restingPattern(build));
}

void TestIntroducedPatient::startsAsTheBuiltInChild()
{
    const BreathingPattern quiet =
        restingPattern(buildOf(dimensionsOf(BuiltinPatient::TwelveYears)));
    QVERIFY(std::abs(inPerMinute(BreathingPattern{}.rate - quiet.rate)) < 1e-9);
    QVERIFY(std::abs(inMillilitres(BreathingPattern{}.tidalVolume - quiet.tidalVolume)) < 1e-9);
    QVERIFY(std::abs(BreathingPattern{}.inspiratoryFraction - quiet.inspiratoryFraction) < 1e-12);
}

CARINA_TEST(TestIntroducedPatient)

} // namespace carina::introduced_patient_test

#include "tst_introduced_patient.moc"
