#pragma once

#include "engine/core/units.h"

#include <cstddef>
#include <optional>

namespace carina
{

/// The two tones of each heartbeat.
///
/// The first comes with the beat, and the second when ejection ends: 413 - 1.7 rate ms later, rate
/// in beats per minute (Weissler, Harris and Schoenfeld, Circulation 1968;37:149), and no less than
/// kLeastEjection_s. The first is lower and longer. Pitches and lengths are of ours; they lie where
/// small loudspeakers still sound.
class HeartTones
{
public:
    static constexpr double kFirst_hz = 70.0;
    static constexpr double kSecond_hz = 95.0;
    static constexpr double kFirst_s = 0.12;
    static constexpr double kSecond_s = 0.08;
    static constexpr double kLeastEjection_s = 0.14;

    /// How long the second tone comes after the first.
    [[nodiscard]] static double ejection_s(Frequency heartRate);

    /// A beat with the next sample. One before the last beat's tones are over is not heard.
    /// @pre heartRate is above 0
    void beat(Frequency heartRate);

    [[nodiscard]] double next();

private:
    std::optional<double> m_ejection_s; ///< of the beat that sounds
    std::size_t m_sample = 0;           ///< since it
};

} // namespace carina
