#include "evaluation/waveforms/recorded_waveform.h"

#include "tests/evaluation/waveforms/synthetic_breaths.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

namespace carina::recorded_waveform_test
{

using namespace test;

namespace
{

QString written(const QTemporaryDir& folder, const QByteArray& text)
{
    const QString name = folder.filePath(QStringLiteral("waveform.csv"));
    QFile file{name};
    if (file.open(QIODevice::WriteOnly))
        file.write(text);
    return name;
}

} // namespace

class TestRecordedWaveform : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsPressureAndFlow();
    void readsAFileWithoutFlow();
    void refusesABrokenFile_data();
    void refusesABrokenFile();
    void tellsInspirationFromExpiration();
    void leavesOutAnOpenTube();
};

void TestRecordedWaveform::readsPressureAndFlow()
{
    const QTemporaryDir folder;
    const auto waveform = readWaveform(
        written(folder, "#samplerate,50\npressure,flow,true_pip\n10.5,30,20\n11,-6.0,20\n\n"));
    QVERIFY(waveform.has_value());
    QCOMPARE(waveform->rate_hz, 50.0);
    QCOMPARE(waveform->pressure_cmH2O, (std::vector<double>{10.5, 11.0}));
    QCOMPARE(waveform->flow_lPerS, (std::vector<double>{0.5, -0.1}));
}

void TestRecordedWaveform::readsAFileWithoutFlow()
{
    const QTemporaryDir folder;
    const auto waveform =
        readWaveform(written(folder, "#samplerate,100\r\npressure,flow\r\n10.5,\r\n11,\r\n"));
    QVERIFY(waveform.has_value());
    QCOMPARE(waveform->pressure_cmH2O.size(), std::size_t{2});
    QVERIFY(waveform->flow_lPerS.empty());
}

void TestRecordedWaveform::refusesABrokenFile_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("named");
    const auto row = [](const char* name, const char* text, const char* named) {
        QTest::newRow(name) << QByteArray{text} << QByteArray{named};
    };
    row("blank", "\n", "#samplerate,HZ");
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

void TestRecordedWaveform::refusesABrokenFile()
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
    QCOMPARE(readWaveform(written(folder, {})).error().code, Errc::FileEmpty);
}

/// Each of ten breaths is found at its very samples.
void TestRecordedWaveform::tellsInspirationFromExpiration()
{
    const SyntheticBreaths breaths = someBreaths(10, 0.3);
    const auto found = breathsOf(breathParts(breaths.waveform));
    QCOMPARE(found.size(), std::size_t{10});
    std::size_t begin = 1;
    for (std::size_t i = 0; i < found.size(); ++i) {
        QCOMPARE(found[i].begin, begin);
        QCOMPARE(found[i].expiration, begin + 80 + 2 * i);
        begin += 80 + 2 * i + 150 + kShutSamples;
        QCOMPARE(found[i].end, begin);
    }
}

void TestRecordedWaveform::leavesOutAnOpenTube()
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

CARINA_TEST(TestRecordedWaveform)

} // namespace carina::recorded_waveform_test

#include "tst_recorded_waveform.moc"
