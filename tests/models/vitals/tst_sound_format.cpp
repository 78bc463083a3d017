#include "models/vitals/sound_format.h"
#include "models/vitals/sound_output.h"
#include "tests/support/test_class.h"

#include <array>
#include <cstring>

namespace carina::sound_format_test
{
namespace
{

constexpr std::array kSamples{0.0F, 0.5F, -1.0F, 1.5F};

QAudioFormat formatOf(QAudioFormat::SampleFormat samples, int channels)
{
    QAudioFormat format;
    format.setSampleRate(48000);
    format.setSampleFormat(samples);
    format.setChannelCount(channels);
    return format;
}

template <class Number> Number numberAt(const QByteArray& bytes, std::size_t place)
{
    Number number{};
    std::memcpy(&number, bytes.constData() + place * sizeof number, sizeof number);
    return number;
}

} // namespace

class TestSoundFormat : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writesFloatsIntoBothChannels()
    {
        const QByteArray bytes = soundBytes(kSamples, formatOf(QAudioFormat::Float, 2));
        QCOMPARE(bytes.size(), qsizetype(4 * 2 * 4));
        for (std::size_t i = 0; i < kSamples.size(); ++i) {
            QCOMPARE(numberAt<float>(bytes, 2 * i), kSamples[i]);
            QCOMPARE(numberAt<float>(bytes, 2 * i + 1), kSamples[i]);
        }
    }

    void writesWholeNumbersWithinTheirRange()
    {
        const QByteArray bytes = soundBytes(kSamples, formatOf(QAudioFormat::Int16, 1));
        QCOMPARE(bytes.size(), qsizetype(4 * 2));
        QCOMPARE(numberAt<qint16>(bytes, 0), qint16{0});
        QCOMPARE(numberAt<qint16>(bytes, 1), qint16{16384});
        QCOMPARE(numberAt<qint16>(bytes, 2), qint16{-32767});
        QCOMPARE(numberAt<qint16>(bytes, 3), qint16{32767});
    }

    void findsNoFormatForNoDevice() { QVERIFY(!playableFormat(QAudioDevice{})); }

    // On a computer without an audio device, as most that test, and on one with it.
    void playsOrSaysWhyNot()
    {
        int asked = 0;
        SoundOutput output{[&asked](std::span<float> samples) {
            ++asked;
            std::fill(samples.begin(), samples.end(), 0.0F);
        }};
        const bool hasDevice = !QMediaDevices::defaultAudioOutput().isNull();
        if (hasDevice && output.obstacle().isEmpty())
            QTRY_VERIFY(asked > 0);
        else
            QVERIFY(output.obstacle().startsWith(QStringLiteral("No sound: ")));
    }
};

CARINA_SCREEN_TEST(TestSoundFormat)

} // namespace carina::sound_format_test

#include "tst_sound_format.moc"
