#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"

#include <array>

namespace carina
{

/// A volume as a function of one amplitude s:
///
///     V(s) = c0 + c1 s + c2 s^2 + c3 s^3
struct VolumeCubic {
    std::array<double, 4> c{}; ///< m^3

    [[nodiscard]] Volume at(double s) const;
};

/// A closed interval of amplitudes.
struct AmplitudeRange {
    double least = 0.0;
    double greatest = 0.0;
};

/// The amplitude within a range at which the cubic equals `volume`, exact to rounding; of several
/// solutions the one nearest to `nearest`.
///
/// @returns VolumeUnreachable where no amplitude within the range gives this volume; NotFinite for
///          NaN or inf.
/// @pre the range is finite and its least is not above its greatest.
[[nodiscard]] Result<double> amplitudeFor(const VolumeCubic& cubic, Volume volume, double nearest,
                                          const AmplitudeRange& range);

} // namespace carina
