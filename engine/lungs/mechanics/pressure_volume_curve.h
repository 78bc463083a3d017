#pragma once

#include "engine/core/units.h"

namespace carina
{

/// Static pressure-volume curve of one lung: its gas as a function of the transpulmonary pressure
/// (alveolar less pleural), the sigmoid of Venegas et al. (J Appl Physiol 1998;84:389)
///
///     V(P) = floor + span / (1 + exp(-(P - centre) / width))
///
/// with the compliance (V - floor)(floor + span - V) / (span width), greatest at the centre.
///
/// Within kStraightShare of the span from either asymptote the curve continues as its tangent, so
/// that every volume has a pressure and an integration step that overshoots can recover.
struct PressureVolumeCurve {
    Volume floor;    ///< lower asymptote: gas left when the lung is squeezed
    Volume span;     ///< upper asymptote (capacity) less lower asymptote
    Pressure centre; ///< at the inflection point, where V = floor + span / 2
    Pressure width;  ///< pressure scale of the exponential

    /// The curve with these asymptotes that passes through `volume` at `pressure` with this
    /// compliance.
    /// @pre floor < volume < ceiling, compliance above 0.
    [[nodiscard]] static PressureVolumeCurve through(Volume floor, Volume ceiling, Volume volume,
                                                     Pressure pressure, Compliance compliance);

    [[nodiscard]] Pressure pressureAt(Volume volume) const;
    [[nodiscard]] Volume volumeAt(Pressure pressure) const;
    [[nodiscard]] Compliance complianceAt(Volume volume) const;

    friend bool operator==(const PressureVolumeCurve&, const PressureVolumeCurve&) = default;
};

/// Share of the span at either end where the curve is its tangent.
inline constexpr double kStraightShare = 0.01;

} // namespace carina
