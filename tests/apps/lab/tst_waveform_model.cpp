#include "apps/lab/waveform_model.h"

#include "tests/support/test_data.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

namespace carina::lab
{
namespace
{

constexpr double kRate_hz = 100.0;
constexpr double kFlow_lPerS = 0.5;
constexpr int kShut = 5; // samples

/// A ventilator and a lung P = P0 + R Q + V/C, breath by breath in closed form: a steady flow for a
/// time in, then out through a valve, V(t) = Ve + (V0 - Ve) e^(-t/tau) with tau = (R + Rv) C.
struct SyntheticBreaths {
    double baseline = 12.0;   // cmH2O
    double resistance = 8.0;  // cmH2O s/L
    double compliance = 0.03; // L/cmH2O
    double valve = 14.0;      // cmH2O
    double valveResistance = 10.0;
    double noise = 0.0;

    RecordedWaveform waveform{kRate_hz, {}, {}};
    std::vector<double> flow_lPerS{};
    std::mt19937 random{7};

    void sample(double pressure, double flow)
    {
        std::normal_distribution<double> error{0.0, 1.0};
        waveform.pressure_cmH2O.push_back(pressure + noise * error(random));
        flow_lPerS.push_back(flow);
    }
    /// Samples are of the middle of their time.
    void breathe(double inspired_s, double expired_s)
    {
        const double step = 1.0 / kRate_hz;
        for (int i = 0; i < std::lround(inspired_s * kRate_hz); ++i)
            sample(baseline + resistance * kFlow_lPerS
                       + (i + 0.5) * step * kFlow_lPerS / compliance,
                   kFlow_lPerS);
        const double full = inspired_s * kFlow_lPerS;
        const double left = (valve - baseline) * compliance;
        const double tau = (resistance + valveResistance) * compliance;
        for (int i = 0; i < std::lround(expired_s * kRate_hz); ++i) {
            const double flow = -(full - left) / tau * std::exp(-(i + 0.5) * step / tau);
            sample(valve - valveResistance * flow, flow);
        }
        // The valve shuts, and what is left leaks out unseen.
        for (int i = 0; i < kShut; ++i)
            sample(baseline, 0.0);
    }
    void open(double seconds)
    {
        for (int i = 0; i < std::lround(seconds * kRate_hz); ++i)
            sample(5.0, 0.0);
    }
};

SyntheticBreaths someBreaths(int count, double noise = 0.0)
{
    SyntheticBreaths breaths;
    breaths.noise = noise;
    breaths.sample(12.0, 0.0);
    for (int i = 0; i < count; ++i)
        breaths.breathe(0.8 + 0.02 * i, 1.5);
    return breaths;
}

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

QString written(const QTemporaryDir& folder, const QByteArray& text)
{
    const QString name = folder.filePath(QStringLiteral("waveform.csv"));
    QFile file{name};
    if (file.open(QIODevice::WriteOnly))
        file.write(text);
    return name;
}

} // namespace

class TestWaveformModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsPressureAndFlow();
    void readsAFileWithoutFlow();
    void refusesABrokenFile_data();
    void refusesABrokenFile();
    void tellsInspirationFromExpiration();
    void leavesOutAnOpenTube();
    void findsTheLungFromRecordedFlow();
    void findsLungAndValveFromPressureAlone();
    void findsTheTimeConstantWhateverTheFlow();
    void findsTheLungThroughNoise();
    void followsALungThatStiffens();
    void reportsThatThereIsNoBreath();
    void followsTheRecordedTestLung_data();
    void followsTheRecordedTestLung();
};

void TestWaveformModel::readsPressureAndFlow()
{
    const QTemporaryDir folder;
    const auto waveform = readWaveform(
        written(folder, "#samplerate,50\npressure,flow,true_pip\n10.5,30,20\n11,-6.0,20\n\n"));
    QVERIFY(waveform.has_value());
    QCOMPARE(waveform->rate_hz, 50.0);
    QCOMPARE(waveform->pressure_cmH2O, (std::vector<double>{10.5, 11.0}));
    QCOMPARE(waveform->flow_lPerS, (std::vector<double>{0.5, -0.1}));
}

void TestWaveformModel::readsAFileWithoutFlow()
{
    const QTemporaryDir folder;
    const auto waveform =
        readWaveform(written(folder, "#samplerate,100\r\npressure,flow\r\n10.5,\r\n11,\r\n"));
    QVERIFY(waveform.has_value());
    QCOMPARE(waveform->pressure_cmH2O.size(), std::size_t{2});
    QVERIFY(waveform->flow_lPerS.empty());
}

void TestWaveformModel::refusesABrokenFile_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("named");
    const auto row = [](const char* name, const char* text, const char* named) {
        QTest::newRow(name) << QByteArray{text} << QByteArray{named};
    };
    row("empty", "", "#samplerate,HZ");
    row("no rate", "pressure,flow\n1,2\n", "#samplerate,HZ");
    row("no pressure", "#samplerate,50\nflow\n1\n", "pressure,flow");
    row("slow", "#samplerate,9\npressure,flow\n1,2\n", "below 10 Hz");
    row("rate no number", "#samplerate,fast\npressure,flow\n1,2\n", "below 10 Hz");
    row("word", "#samplerate,50\npressure,flow\n1,2\nhigh,2\n", "line 4: \"high\"");
    row("not finite", "#samplerate,50\npressure,flow\nnan,2\n", "line 3: \"nan\"");
    row("flow no number", "#samplerate,50\npressure,flow\n1,x\n", "line 3: \"x\"");
    row("flow at times", "#samplerate,50\npressure,flow\n1,2\n1,\n", "some lines only");
    row("no samples", "#samplerate,50\npressure,flow\n", "no samples");
}

void TestWaveformModel::refusesABrokenFile()
{
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, named);
    const QTemporaryDir folder;
    const auto waveform = readWaveform(written(folder, text));
    QVERIFY(!waveform);
    QCOMPARE(waveform.error().code, Errc::FileMalformed);
    const QByteArray detail = QByteArray::fromStdString(waveform.error().detail);
    QVERIFY2(detail.contains(named) && detail.contains("waveform.csv"), detail.constData());
    QCOMPARE(readWaveform(folder.filePath(QStringLiteral("none"))).error().code,
             Errc::FileNotFound);
}

/// Each of ten breaths is found at its very samples.
void TestWaveformModel::tellsInspirationFromExpiration()
{
    const SyntheticBreaths breaths = someBreaths(10, 0.3);
    const auto found = breathsOf(breathParts(breaths.waveform));
    QCOMPARE(found.size(), std::size_t{10});
    std::size_t begin = 1;
    for (std::size_t i = 0; i < found.size(); ++i) {
        QCOMPARE(found[i].begin, begin);
        QCOMPARE(found[i].expiration, begin + 80 + 2 * i);
        begin += 80 + 2 * i + 150 + kShut;
        QCOMPARE(found[i].end, begin);
    }
}

void TestWaveformModel::leavesOutAnOpenTube()
{
    SyntheticBreaths breaths = someBreaths(10);
    const std::size_t closed = breaths.waveform.pressure_cmH2O.size();
    breaths.open(1.0);
    breaths.sample(30.0, 0.0); // touched
    breaths.open(1.0);
    const std::size_t again = breaths.waveform.pressure_cmH2O.size();
    for (int i = 0; i < 3; ++i)
        breaths.breathe(0.8, 1.5);
    const auto parts = breathParts(breaths.waveform);
    for (std::size_t i = 0; i < parts.size(); ++i)
        QCOMPARE(parts[i] == BreathPart::Disconnected, i >= closed && i < again + 6); // 60 ms
    // The breath before the opening is cut short, that after it has no beginning.
    QCOMPARE(breathsOf(parts).size(), std::size_t{9 + 2});
}

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
    const auto path = test::testData("waveforms/testlung/" + file.toStdString() + ".csv");
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

} // namespace carina::lab

QTEST_GUILESS_MAIN(carina::lab::TestWaveformModel)
#include "tst_waveform_model.moc"
