#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/patient/patient_build.h"
#include "engine/core/units.h"
#include "engine/lungs/mechanics/breathing_pattern.h"
#include "engine/lungs/mechanics/pressure_volume_curve.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace carina
{

/// One lung and the side of the chest around it. The wall has a linear pressure-volume curve: with
/// relaxed muscles the pleural pressure is -wallRecoil + (V - wallVolume) / wall, where V is the
/// gas in the lung and in the pleural space.
struct LungMechanics {
    PressureVolumeCurve curve; ///< midway between the two limbs
    Pressure limbSpread;       ///< hysteresis: inflation limb less deflation limb, at equal volume
    /// Gas moved after a reversal of flow that takes the lung 63 % of the way to the other limb.
    Volume limbVolume;
    Conductance bronchi; ///< from carina to alveoli; 0 where nothing passes
    /// Dynamic compression of the bronchi: their resistance to gas that leaves, over that to gas
    /// that enters; 1 or more.
    double compression = 1.0;
    /// Below this volume of gas the bronchi narrow in proportion to the gas above the curve's floor
    /// while gas leaves; 0: they do not.
    Volume closing;
    Compliance wall;
    Volume wallVolume; ///< gas at which the pleural pressure is -wallRecoil
    Pressure wallRecoil;
    double drive = 1.0; ///< share of the muscles' pressure that acts on this side
    Volume pleuralGas;  ///< constant, independent of pressure
    Conductance valve;  ///< of a one-way tear from the airway into the pleural space
    Frequency relief;   ///< rate constant at which gas that entered through the valve leaves again
    Frequency uptake;   ///< rate constant at which the blood absorbs gas beyond `uptakeEnd`
    Volume uptakeEnd;
    Volume alveolarDeadSpace; ///< gas in ventilated alveoli without blood flow, at rest

    friend bool operator==(const LungMechanics&, const LungMechanics&) = default;
};

/// Both lungs, the chest around them and the airway above the carina.
struct RespiratorySystem {
    std::array<LungMechanics, 2> lungs; ///< right, left
    Resistance upperLaminar;            ///< K1 of Rohrer's equation: pressure loss K1 Q + K2 Q |Q|
    double upperTurbulent = 0.0;        ///< K2, Pa s^2/m^6
    Compliance mediastinum;     ///< volume that gives way per difference of the pleural pressures
    Volume mediastinumMost;     ///< limit of this volume
    Pressure mediastinalWeight; ///< acts towards the patient's left
    Volume anatomicalDeadSpace;
    double effort = 1.0; ///< of exhausted muscles, as a share of that of quiet breathing in health
    double strength = 1.0; ///< of the muscles, as a share of kGreatestInspiratoryPressure
    /// Duration of inspiration over that of expiration in spontaneous breathing, as a multiple of
    /// what is set.
    double inspiratoryRatio = 1.0;
    double sag = 0.0; ///< of the inside of the lungs, as LungPose::gravity; 0 supine

    friend bool operator==(const RespiratorySystem&, const RespiratorySystem&) = default;
};

/// Resting volume of a supine patient with relaxed muscles, as a share of that awake: 25 of 30
/// ml/kg.
inline constexpr double kRelaxedRest = 25.0 / 30.0;

/// The least share of a lung that gas in the pleural space leaves open.
inline constexpr double kLeastOpenShare = 0.05;

[[nodiscard]] constexpr std::size_t lungIndex(Side side) { return side == Side::Right ? 0 : 1; }

/// The healthy patient, supine, breathing through the natural airway. Sources: docs/mechanics.md.
/// @pre height and weight above 0, age not below 0.
[[nodiscard]] RespiratorySystem healthySystem(const PatientBuild& build);

/// Quiet breathing of this patient, for every program and experiment: 7 ml per kilogram of the
/// usual weight at any age (Pulse; Respir Physiol 1981, PubMed 7330494); a rate f of 44 per minute
/// at birth and 26 at 2 years (Fleming, Lancet 2011;377:1011), 19 at 12 and 16 from 18 on (Pulse),
/// on straight lines between; an inspiratory fraction of 0.0125 (f + 4) + 0.125 (Pulse), at most a
/// half, which it has at 2 years.
[[nodiscard]] BreathingPattern restingPattern(const PatientBuild& build);

/// The largest tidal volume that may be set for this patient: half of the inspiratory capacity,
/// which is 25 ml/kg or three and a half quiet breaths in a lean patient, 21 ml/kg in a newborn.
/// The share of one half is our choice.
[[nodiscard]] Volume largestTidalVolume(const PatientBuild& build);

/// Relaxes the muscles, as in anaesthesia with a ventilator: the resting volume falls to the share
/// `rest`, along the line of the wall, and each lung has 0.4 of its compliance there (Pulse, lung
/// under a ventilator). The system then has 50 to 80 ml/cmH2O in an adult.
void relax(RespiratorySystem& system, double rest = kRelaxedRest);

/// Replaces the airway above the carina by a tracheal tube of 300 mm: K1 by Poiseuille's law, 128
/// mu L / (pi d^4); K2 by the turbulent loss in a smooth tube at 1 L/s (Blasius) and 1.5 velocity
/// heads for connector and ends. The tube halves the anatomical dead space.
/// @pre the diameter is above 0.
void intubate(RespiratorySystem& system, Length innerDiameter);

/// Moves every parameter of `system` by `share` of its distance to `target`; 1 makes them equal.
void approach(RespiratorySystem& system, const RespiratorySystem& target, double share);

} // namespace carina
