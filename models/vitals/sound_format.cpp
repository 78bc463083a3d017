#include "models/vitals/sound_format.h"

#include "engine/audio/sampling.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

template <class Number> void append(QByteArray& bytes, Number value, int times)
{
    for (int i = 0; i < times; ++i)
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

qint16 in16Bit(float sample)
{
    constexpr float kMost = std::numeric_limits<qint16>::max();
    return static_cast<qint16>(std::lround(kMost * std::clamp(sample, -1.0F, 1.0F)));
}

} // namespace

std::optional<QAudioFormat> playableFormat(const QAudioDevice& device)
{
    QAudioFormat format;
    format.setSampleRate(static_cast<int>(kSoundRate));
    for (const QAudioFormat::SampleFormat samples : {QAudioFormat::Float, QAudioFormat::Int16})
        for (const int channels : {2, 1}) {
            format.setSampleFormat(samples);
            format.setChannelCount(channels);
            if (device.isFormatSupported(format))
                return format;
        }
    return std::nullopt;
}

QByteArray soundBytes(std::span<const float> samples, const QAudioFormat& format)
{
    const bool isFloat = format.sampleFormat() == QAudioFormat::Float;
    CARINA_EXPECTS(isFloat || format.sampleFormat() == QAudioFormat::Int16);
    QByteArray bytes;
    bytes.reserve(qsizetype(samples.size()) * format.bytesPerFrame());
    for (const float sample : samples) {
        if (isFloat)
            append(bytes, sample, format.channelCount());
        else
            append(bytes, in16Bit(sample), format.channelCount());
    }
    return bytes;
}

} // namespace carina
