#include "evaluation/waveforms/waveform_model.h"

#include "tests/evaluation/waveforms/synthetic_breaths.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <cmath>

namespace carina::waveform_model_test
{

using namespace test;

namespace
{

Result<WaveformModel> modelled(const RecordedWaveform& waveform, double flow_lPerS = kFlow_lPerS)
{
    return modelOf(waveform, breathParts(waveform), litresPerSecond(flow_lPerS));
}

bool near(double actual, double expected, double tolerance)
{
    return std::abs(actual - expected) <= tolerance;
}

QString textOf(const WaveformModel& model)
{
    const ExpiratoryValve valve = model.valve.value_or(ExpiratoryValve{});
    return QStringLiteral("%1 breaths, R %2, C %3, rms %4, one lung %5, valve %6, %7")
        .arg(model.breaths.size())
        .arg(inCmH2OSecondsPerLitre(model.median.resistance))
        .arg(inLitresPerCmH2O(model.median.compliance))
        .arg(inCmH2O(model.rms))
        .arg(inCmH2O(model.rmsOneLung))
        .arg(inCmH2O(valve.pressure))
        .arg(inCmH2OSecondsPerLitre(valve.resistance));
}

} // namespace

class TestWaveformModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheLungFromRecordedFlow();
    void findsLungAndValveFromPressureAlone();
    void findsTheTimeConstantWhateverTheFlow();
    void findsTheLungThroughNoise();
    void followsALungThatStiffens();
    void reportsThatThereIsNoBreath();
    void followsTheRecordedTestLung_data();
    void followsTheRecordedTestLung();
};

void TestWaveformModel::findsTheLungFromRecordedFlow()
{
    SyntheticBreaths breaths;
    breaths.valve = breaths.baseline;
    breaths.sample(12.0, 0.0);
    for (int i = 0; i < 4; ++i)
        breaths.breathe(0.8, 2.5);
    breaths.waveform.flow_lPerS = breaths.flow_lPerS;
    const auto model = modelled(breaths.waveform, 0.0);
    QVERIFY(model && !model->valve);
    QCOMPARE(model->breaths.size(), std::size_t{4});
    // The sum of samples stands for an exponential.
    QVERIFY2(near(inCmH2OSecondsPerLitre(model->median.resistance), 8.0, 0.02)
                 && near(inLitresPerCmH2O(model->median.compliance), 0.03, 0.0001)
                 && inCmH2O(model->rms) < 0.05,
             qPrintable(textOf(*model)));
}

void TestWaveformModel::findsLungAndValveFromPressureAlone()
{
    const auto model = modelled(someBreaths(4).waveform);
    QVERIFY(model && model->valve);
    QVERIFY2(near(inCmH2OSecondsPerLitre(model->median.resistance), 8.0, 1e-6)
                 && near(inLitresPerCmH2O(model->median.compliance), 0.03, 1e-8)
                 && near(inCmH2O(model->median.baseline), 12.0, 1e-6),
             qPrintable(textOf(*model)));
    QVERIFY2(near(inCmH2O(model->valve->pressure), 14.0, 0.5)
                 && near(inCmH2OSecondsPerLitre(model->valve->resistance), 10.0, 1.0),
             qPrintable(textOf(*model)));
    QVERIFY2(inCmH2O(model->rms) < 0.6, qPrintable(textOf(*model)));
    QCOMPARE(model->unfit, 0);
}

/// Twice the flow: half the resistance, twice the compliance, the same pressures.
void TestWaveformModel::findsTheTimeConstantWhateverTheFlow()
{
    const RecordedWaveform waveform = someBreaths(4).waveform;
    const auto once = modelled(waveform);
    const auto twice = modelled(waveform, 2.0 * kFlow_lPerS);
    QVERIFY(near(inCmH2OSecondsPerLitre(twice->median.resistance), 4.0, 1e-6));
    QVERIFY(near(inLitresPerCmH2O(twice->median.compliance), 0.06, 1e-8));
    QVERIFY(near(inCmH2O(twice->rms), inCmH2O(once->rms), 1e-6));
}

void TestWaveformModel::findsTheLungThroughNoise()
{
    const auto model = modelled(someBreaths(6, 0.3).waveform);
    QVERIFY(model.has_value());
    QVERIFY2(near(inCmH2OSecondsPerLitre(model->median.resistance), 8.0, 0.5)
                 && near(inLitresPerCmH2O(model->median.compliance), 0.03, 0.001),
             qPrintable(textOf(*model)));
}

/// One lung cannot do for all breaths then, and each breath's own still does.
void TestWaveformModel::followsALungThatStiffens()
{
    SyntheticBreaths breaths;
    breaths.sample(12.0, 0.0);
    for (int i = 0; i < 12; ++i) {
        breaths.breathe(0.8, 1.5);
        breaths.compliance *= 0.9;
    }
    const auto model = modelled(breaths.waveform);
    QVERIFY(model.has_value());
    QVERIFY2(inCmH2O(model->rms) < 0.7 && inCmH2O(model->rmsOneLung) > 2.0,
             qPrintable(textOf(*model)));
    QVERIFY(near(inLitresPerCmH2O(model->breaths.back().lung.compliance), 0.03 * std::pow(0.9, 11),
                 1e-8));
}

void TestWaveformModel::reportsThatThereIsNoBreath()
{
    SyntheticBreaths breaths;
    breaths.open(3.0);
    QCOMPARE(modelled(breaths.waveform).error().code, Errc::NothingRecognised);
    QCOMPARE(modelled(RecordedWaveform{100.0, {12.0}, {}}).error().code, Errc::NothingRecognised);
}

void TestWaveformModel::followsTheRecordedTestLung_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("breaths");
    QTest::addColumn<double>("rms_cmH2O");
    QTest::newRow("slow") << QStringLiteral("low_rate") << 12 << 2.0;
    QTest::newRow("disconnected") << QStringLiteral("lung_disconnect") << 10 << 2.5;
    QTest::newRow("stiff") << QStringLiteral("noncompliant") << 51 << 4.0;
}

/// Of swings of 25 to 30 cmH2O.
void TestWaveformModel::followsTheRecordedTestLung()
{
    QFETCH(const QString, file);
    QFETCH(const int, breaths);
    QFETCH(const double, rms_cmH2O);
    const auto path = carina::test::testData("waveforms/testlung/" + file.toStdString() + ".csv");
    if (!path)
        QSKIP("no recorded waveforms here");
    const auto waveform = readWaveform(QString::fromStdString(path->string()));
    QVERIFY(waveform.has_value());
    const auto model = modelled(*waveform);
    QVERIFY(model.has_value());
    QCOMPARE(int(model->breaths.size()), breaths);
    QCOMPARE(model->unfit, 0);
    QVERIFY2(inCmH2O(model->rms) < rms_cmH2O, qPrintable(textOf(*model)));
}

CARINA_TEST(TestWaveformModel)

} // namespace carina::waveform_model_test

#include "tst_waveform_model.moc"
