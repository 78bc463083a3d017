#pragma once

#include "engine/core/units.h"

namespace carina
{

/// How much gas one lung holds at a pressure across it (alveolar less pleural), at rest: the
/// sigmoid of Venegas et al. (J Appl Physiol 1998;84:389),
///
///     V(P) = floor + span / (1 + exp(-(P - centre) / width))
///
/// with the compliance (V - floor)(floor + span - V) / (span width), greatest at the centre.
///
/// Within kStraightShare of the span from either asymptote the curve goes on as its tangent, so
/// that every volume has a pressure and a step of an integrator that goes too far comes back.
struct PressureVolumeCurve {
    Volume floor;    ///< what is left when the lung is squeezed
    Volume span;     ///< from there to the most it can hold
    Pressure centre; ///< at the middle of the span
    Pressure width;  ///< over which the exponential falls to 1/e

    /// The curve between two asymptotes that passes `volume` at `pressure` with a compliance.
    /// @pre floor < volume < ceiling, compliance above 0.
    [[nodiscard]] static PressureVolumeCurve through(Volume floor, Volume ceiling, Volume volume,
                                                     Pressure pressure, Compliance compliance);

    [[nodiscard]] Pressure pressureAt(Volume volume) const;
    [[nodiscard]] Volume volumeAt(Pressure pressure) const;
    [[nodiscard]] Compliance complianceAt(Volume volume) const;

    friend bool operator==(const PressureVolumeCurve&, const PressureVolumeCurve&) = default;
};

/// Share of the span at either end of it where the curve is straight.
inline constexpr double kStraightShare = 0.01;

} // namespace carina
