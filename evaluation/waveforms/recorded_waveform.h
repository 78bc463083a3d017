#pragma once

#include "engine/core/result.h"

#include <QString>

#include <vector>

namespace carina
{

/// Pressure at the airway opening and, if recorded, flow, at a constant sample rate.
struct RecordedWaveform {
    double rate_hz = 0.0;
    std::vector<double> pressure_cmH2O;
    std::vector<double> flow_lPerS; ///< into the patient; empty where none was recorded
};

/// Reads a line "#samplerate,HZ", a line of column names with "pressure" (cmH2O) and "flow"
/// (L/min), and a line for each sample. Either all flow fields have a value or none has.
/// @returns FileNotFound, FileMalformed; the detail is a sentence that names the file, and the
/// line.
[[nodiscard]] Result<RecordedWaveform> readWaveform(const QString& file);

/// The phase of breathing at a sample.
enum class BreathPart : unsigned char { Inspiration, Expiration, Disconnected };

/// Finds the phases of a ventilator with constant inspiratory flow and expiration at a set
/// pressure. Inspiration starts with a rise of more than kSwitchRise within kSwitchTime, from a
/// pressure below kRisesBelow, and ends with such a fall, from a pressure above kFallsAbove, both
/// as fractions between the least and the greatest pressure. A pressure below kOpenShare of the
/// median end-expiratory pressure means a disconnected tube; so do the kSwitchTime after it, and
/// the time between two such samples within kReconnection.
[[nodiscard]] std::vector<BreathPart> breathParts(const RecordedWaveform& waveform);

inline constexpr double kSwitchTime = 0.06; ///< s
inline constexpr double kSwitchRise = 4.0;  ///< cmH2O
inline constexpr double kRisesBelow = 0.4;  ///< of the height
inline constexpr double kFallsAbove = 0.25; ///< of the height
inline constexpr double kOpenShare = 0.6;
inline constexpr double kReconnection = 2.0; ///< s

/// A breath as sample indices: start of inspiration, start of expiration, and one past the last
/// sample.
struct RecordedBreath {
    std::size_t begin = 0;
    std::size_t expiration = 0;
    std::size_t end = 0;
};

/// The complete breaths, without a disconnection: start, inspiration and expiration recorded.
[[nodiscard]] std::vector<RecordedBreath> breathsOf(const std::vector<BreathPart>& parts);

} // namespace carina
