#pragma once

#include "engine/lungs/mechanics/respiratory_system.h"

#include <array>

namespace carina
{

/// What changes in one lung.
struct LungContent {
    Volume gas;        ///< in the lung
    double limb = 0.5; ///< where the lung is between its limbs: 0 inflation, 1 deflation
    Volume trapped;    ///< in the pleura, come through the valve

    friend bool operator==(const LungContent&, const LungContent&) = default;
};

using ChestContent = std::array<LungContent, 2>; ///< right, left

/// What holds at the airway opening: a pressure, or a flow driven in as far as the pressure for it
/// stays within a limit.
struct AirwayOpening {
    bool drivesFlow = false;
    Pressure pressure; ///< held, or the limit
    VolumeFlow flow;   ///< into the patient

    [[nodiscard]] static AirwayOpening at(Pressure pressure) { return {false, pressure, {}}; }
    [[nodiscard]] static AirwayOpening driven(VolumeFlow flow, Pressure limit)
    {
        return {true, limit, flow};
    }

    friend bool operator==(const AirwayOpening&, const AirwayOpening&) = default;
};

/// Pressures and flows that follow from contents at one moment; lungs right, left.
struct ChestMoment {
    std::array<Pressure, 2> alveolar;
    std::array<Pressure, 2> pleural;
    std::array<VolumeFlow, 2> intoLung;
    std::array<VolumeFlow, 2> intoPleura; ///< through the valve
    std::array<VolumeFlow, 2> uptake;     ///< into the blood
    VolumeFlow airwayFlow;                ///< in at the opening: the sum of the flows above
    Pressure opening;
    Pressure carina;
    Volume mediastinum; ///< given way by the right side to the left
};

/// Share of a lung's span, above its floor, at which its bronchi begin to close.
inline constexpr double kClosingShare = 0.05;
/// Bronchi that a condition closes more and more are shut below that, before it is too little to
/// reckon with: a nanolitre in a minute at 100 cmH2O.
inline constexpr Conductance kShut{1e-18};

/// The lungs at rest: each on its curve and between its limbs, wall and muscles relaxed, no flow.
/// @returns the gas of each lung, to 1 nl.
[[nodiscard]] ChestContent restingContent(const RespiratorySystem& system);

/// The equation of motion at one moment. In each side of the chest
///
///     alveolar = pleural + recoil(gas, limb),
///     pleural = wall(gas + gas in the pleura -+ mediastinum) - drive muscle,
///
/// the mediastinum gives way to the difference of the pleural pressures and to its own weight, and
/// gas flows from the
/// opening through K1 Q + K2 Q |Q| to the carina and on through each lung's bronchi, which conduct
/// less by their compression where gas leaves and close in proportion below kClosingShare. Gas that
/// came through a tear closes the lung in proportion, all but kLeastOpenShare when it is as much as
/// the lung holds at rest. All of it is solved in closed form.
[[nodiscard]] ChestMoment chestMoment(const RespiratorySystem& system, const ChestContent& content,
                                      Pressure muscle, const AirwayOpening& opening);

/// Contents a time later: one step of the classical Runge-Kutta method, the muscle's pressure given
/// at its beginning, middle and end. While gas flows the limb goes exponentially towards that of
/// the flow's direction with the gas moved, so that small breaths have small loops and a full one
/// runs along both limbs.
[[nodiscard]] ChestContent advanced(const RespiratorySystem& system, const ChestContent& content,
                                    const std::array<Pressure, 3>& muscle,
                                    const AirwayOpening& opening, double seconds);

} // namespace carina
