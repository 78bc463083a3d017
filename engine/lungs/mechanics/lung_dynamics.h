#pragma once

#include "engine/lungs/mechanics/respiratory_system.h"

#include <array>

namespace carina
{

/// The state variables of one lung.
struct LungContent {
    Volume gas;        ///< in the lung
    double limb = 0.5; ///< position between the limbs of the hysteresis: 0 inflation, 1 deflation
    Volume trapped;    ///< in the pleural space, entered through the valve

    friend bool operator==(const LungContent&, const LungContent&) = default;
};

using ChestContent = std::array<LungContent, 2>; ///< right, left

/// Boundary condition at the airway opening: a given pressure, or a given flow as long as the
/// pressure that it needs stays within a limit.
struct AirwayOpening {
    bool drivesFlow = false;
    Pressure pressure; ///< given, or the limit
    VolumeFlow flow;   ///< into the patient

    [[nodiscard]] static AirwayOpening at(Pressure pressure) { return {false, pressure, {}}; }
    [[nodiscard]] static AirwayOpening driven(VolumeFlow flow, Pressure limit)
    {
        return {true, limit, flow};
    }

    friend bool operator==(const AirwayOpening&, const AirwayOpening&) = default;
};

/// Pressures and flows at one moment, computed from the contents; arrays are right, left.
struct ChestMoment {
    std::array<Pressure, 2> alveolar;
    std::array<Pressure, 2> pleural;
    std::array<VolumeFlow, 2> intoLung;
    std::array<VolumeFlow, 2> intoPleura; ///< through the valve
    std::array<VolumeFlow, 2> uptake;     ///< absorbed by the blood
    VolumeFlow airwayFlow;                ///< into the patient: the sum of intoLung and intoPleura
    Pressure opening;
    Pressure carina;
    Volume mediastinum; ///< volume that the right side gains at the expense of the left
};

/// Bronchi begin to close where the gas is below this share of the lung's span above its floor.
inline constexpr double kClosingShare = 0.05;
/// What the closing volume leaves of the conductance to gas that leaves, at least.
inline constexpr double kLeastOpenToLeaving = 0.02;
/// A bronchial conductance below this counts as 0, before it becomes numerically too small: 1e-18
/// is a nanolitre per minute at 100 cmH2O.
inline constexpr Conductance kShut{1e-18};

/// The lungs at rest: in equilibrium with the room's pressure, midway between the limbs, wall and
/// muscles relaxed, no flow.
/// @returns the gas of each lung, to 1 nl.
[[nodiscard]] ChestContent restingContent(const RespiratorySystem& system);

/// The equation of motion at one moment, solved in closed form. In each side of the chest
///
///     alveolar = pleural + recoil(gas, limb),
///     pleural = wall(gas + gas in the pleura -+ mediastinum) - drive muscle.
///
/// The mediastinum gives way to the difference of the pleural pressures and to its own weight. Gas
/// flows from the opening to the carina, with the pressure loss K1 Q + K2 Q |Q| (Rohrer), and from
/// there through the bronchi of each lung. Bronchial conductance is divided by the compression
/// where gas leaves, less below the closing volume, and falls in proportion to the gas below
/// kClosingShare. Gas that entered
/// through a tear closes the lung in proportion, down to kLeastOpenShare once it is as much as the
/// lung holds at rest.
///
/// @param muscle pressure of the inspiratory muscles, positive in inspiration
[[nodiscard]] ChestMoment chestMoment(const RespiratorySystem& system, const ChestContent& content,
                                      Pressure muscle, const AirwayOpening& opening);

/// Contents after `seconds`: one step of the classical Runge-Kutta method of fourth order, with the
/// muscle's pressure at the beginning, middle and end of the step. While gas flows, the limb
/// approaches that of the flow's direction exponentially with the gas moved, so that small breaths
/// have small hysteresis loops and a full one follows both limbs.
[[nodiscard]] ChestContent advanced(const RespiratorySystem& system, const ChestContent& content,
                                    const std::array<Pressure, 3>& muscle,
                                    const AirwayOpening& opening, double seconds);

} // namespace carina
