#pragma once

#include "engine/audio/gain_ramp.h"
#include "engine/audio/tone_pulse.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace carina
{

/// How soon somebody has to act, as IEC 60601-1-8 has it.
enum class AlarmPriority : std::uint8_t {
    Low,    ///< awareness
    Medium, ///< prompt response
    High,   ///< immediate response
};

/// The pulses of an alarm, repeated after a pause.
struct AlarmBurst {
    struct Pulse {
        double begin_s = 0.0; ///< since the begin of the burst
        TonePulse tone{};
    };
    std::vector<Pulse> pulses;
    double period_s = 0.0; ///< from a burst's begin to that of the next
};

/// The burst of a priority within tables 3 and 4 of IEC 60601-1-8:2006: ten pulses in two groups of
/// three and two (high), three (medium), two (low). The melodies are those of its general alarm,
/// C4 at high and medium and E4 C4 at low priority. Spacings, pauses and harmonics within the
/// standard's ranges are of ours.
[[nodiscard]] const AlarmBurst& alarmBurst(AlarmPriority priority);

/// The sound of an alarm while it lasts.
class AlarmSound
{
public:
    /// From the next sample on. Another priority begins its burst once the present one has faded.
    void set(std::optional<AlarmPriority> priority) { m_wanted = priority; }

    [[nodiscard]] double next();

private:
    static constexpr double kFade_s = 0.01;

    void change();

    std::optional<AlarmPriority> m_wanted;
    std::optional<AlarmPriority> m_sounding;
    std::size_t m_sample = 0; ///< of the burst
    GainRamp m_gate{0.0, kFade_s};
};

} // namespace carina
