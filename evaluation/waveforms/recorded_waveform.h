#pragma once

#include "engine/core/result.h"

#include <QString>

#include <vector>

namespace carina
{

/// Pressure at the airway opening, and flow where it was recorded, at a steady rate.
struct RecordedWaveform {
    double rate_hz = 0.0;
    std::vector<double> pressure_cmH2O;
    std::vector<double> flow_lPerS; ///< into the patient; empty where none was recorded
};

/// Reads a line "#samplerate,HZ", a line of column names with "pressure" (cmH2O) and "flow"
/// (L/min), and a line for each sample. Fields of flow are all there or all empty.
/// @returns FileNotFound, FileMalformed; the detail is a sentence that names the file, and the
/// line.
[[nodiscard]] Result<RecordedWaveform> readWaveform(const QString& file);

/// What went on at a sample.
enum class BreathPart : unsigned char { Inspiration, Expiration, Disconnected };

/// Tells inspiration from expiration of a ventilator that drives a steady flow into the lung and
/// lets it out at a pressure: inspiration begins with a rise of kSwitchRise within kSwitchTime and
/// ends with such a fall, from heights between the least and the greatest pressure where these may
/// begin. A pressure below kOpenShare of the median of what expirations end at is that of an open
/// tube; so are the kSwitchTime after it, and what lies between two of them within kReconnection.
[[nodiscard]] std::vector<BreathPart> breathParts(const RecordedWaveform& waveform);

inline constexpr double kSwitchTime = 0.06; ///< s
inline constexpr double kSwitchRise = 4.0;  ///< cmH2O
inline constexpr double kRisesBelow = 0.4;  ///< of the height
inline constexpr double kFallsAbove = 0.25; ///< of the height
inline constexpr double kOpenShare = 0.6;
inline constexpr double kReconnection = 2.0; ///< s

/// A breath by its samples: from its inspiration on, from its expiration on, and one past its last.
struct RecordedBreath {
    std::size_t begin = 0;
    std::size_t expiration = 0;
    std::size_t end = 0;
};

/// The breaths with a beginning, an inspiration and an expiration, all of them connected.
[[nodiscard]] std::vector<RecordedBreath> breathsOf(const std::vector<BreathPart>& parts);

} // namespace carina
