#pragma once

#include "engine/core/units.h"

#include <cstddef>
#include <optional>

namespace carina
{

/// The pitch of the oximeter's tone at a saturation from 0 to 1.
///
/// Makers differ: none of those measured by Santamore and Cleaver (J Clin Monit Comput 2004;18:89)
/// has the pitch of another. Steps that are heard as equal are equal ratios of frequency. The scale
/// is of ours: 880 Hz at 100 %, an octave lower for each 20 %, and no lower below 50 %.
[[nodiscard]] Frequency oximeterPitch(double saturation);

/// One tone for each pulse that the oximeter finds.
class OximeterTone
{
public:
    static constexpr double kRise_s = 0.01;
    static constexpr double kPlateau_s = 0.07;
    static constexpr double kFall_s = 0.04;

    /// Begins a tone with the next sample. One that still sounds is finished first, in place of it:
    /// no heart beats as fast.
    void pulse(double saturation);

    [[nodiscard]] double next();

private:
    std::optional<Frequency> m_pitch; ///< of the tone that sounds
    std::size_t m_sample = 0;         ///< of the tone
};

} // namespace carina
