#pragma once

#include <QAudioDevice>
#include <QAudioFormat>
#include <QByteArray>

#include <optional>
#include <span>

namespace carina
{

/// How samples at kSoundRate can be given to a device: as float or else as 16 bit, in two channels
/// or one. @returns nothing where the device plays none of these
[[nodiscard]] std::optional<QAudioFormat> playableFormat(const QAudioDevice& device);

/// The bytes of samples from -1 to 1, the same in each channel.
/// @pre the format is of 16 bit or float
[[nodiscard]] QByteArray soundBytes(std::span<const float> samples, const QAudioFormat& format);

} // namespace carina
