#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/core/units.h"
#include "engine/lungs/mechanics/breathing_pattern.h"
#include "engine/lungs/mechanics/pressure_volume_curve.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace carina
{

/// What the size of the lungs and airways is computed from.
struct PatientBuild {
    Length height = metres(1.75);
    double weightInKilograms = 77.0;
    double ageInYears = 30.0;
    Sex sex = Sex::Male;

    friend bool operator==(const PatientBuild&, const PatientBuild&) = default;
};

/// Of a patient made from figures.
[[nodiscard]] PatientBuild buildOf(const PatientDimensions& dimensions);

/// Volumes of both lungs together.
struct LungVolumes {
    Volume residual;
    Volume functionalResidual;
    Volume totalCapacity;
};

/// One lung and the side of the chest around it. The wall is a spring along a line: relaxed, the
/// pressure in the pleura is -wallRecoil + (V - wallVolume) / wall, where V counts the gas in the
/// lung and that in the pleura.
struct LungMechanics {
    PressureVolumeCurve curve; ///< mean of the two limbs
    Pressure limbSpread;       ///< of the inflation limb above the deflation limb at a volume
    Volume limbVolume; ///< gas moved after a reversal that takes 63 % of the way to the other limb
    Conductance bronchi; ///< carina to alveoli; 0 where nothing passes
    /// Of the bronchi by the pressures of breathing out: their resistance to gas that leaves, over
    /// that to gas that comes in, 1 or more.
    double compression = 1.0;
    Compliance wall;
    Volume wallVolume;
    Pressure wallRecoil;
    double drive = 1.0; ///< of the muscles' pressure, what this side gets
    Volume pleuralGas;  ///< held there whatever the pressures are
    Conductance valve;  ///< of a tear that lets gas from the airway into the pleura and not back
    Frequency relief;   ///< at which gas that came through the valve leaves again
    Frequency uptake;   ///< at which the blood takes up gas beyond `uptakeEnd`
    Volume uptakeEnd;
    Volume alveolarDeadSpace; ///< gas of the lung at rest that no blood meets

    friend bool operator==(const LungMechanics&, const LungMechanics&) = default;
};

/// Two lungs, the chest around them and the airway above the carina.
struct RespiratorySystem {
    std::array<LungMechanics, 2> lungs; ///< right, left
    Resistance upperLaminar;            ///< K1 of Rohrer: the pressure K1 Q + K2 Q |Q|
    double upperTurbulent = 0.0;        ///< K2, Pa s^2/m^6
    Compliance mediastinum;             ///< gas that gives way to the other side, per difference
    Volume mediastinumMost;             ///< the most that gives way
    Pressure mediastinalWeight;         ///< with which it leans towards the patient's left
    Volume anatomicalDeadSpace;
    double effort = 1.0; ///< of the muscles, as a share of what a healthy patient needs
    double sag = 0.0;    ///< of the inside of the lungs, as LungPose::gravity; 0 lying on the back

    friend bool operator==(const RespiratorySystem&, const RespiratorySystem&) = default;
};

/// Of the resting volume of someone who lies, what is left without the muscles: 25 of 30 ml/kg.
inline constexpr double kRelaxedRest = 25.0 / 30.0;

/// The least of a lung that gas in the pleura leaves open.
inline constexpr double kLeastOpenShare = 0.05;

[[nodiscard]] constexpr std::size_t lungIndex(Side side) { return side == Side::Right ? 0 : 1; }

/// 16, 30 and 80 ml per kilogram (Pulse RespiratoryMethodology), the weight beyond a body mass
/// index of 26 not counted: fat adds no lung.
[[nodiscard]] LungVolumes lungVolumesOf(const PatientBuild& build);

/// The healthy patient, lying on the back and breathing through the natural airway. Sources:
/// docs/mechanics.md.
/// @pre height and weight above 0, age not below 2.
[[nodiscard]] RespiratorySystem healthySystem(const PatientBuild& build);

/// A quiet breath of that patient: 7 ml/kg; 16 per minute from 18 years on and 19 at 12, on a line
/// between and beyond; inspiration's share 0.0125 (f + 4) + 0.125 (Pulse).
[[nodiscard]] BreathingPattern restingPattern(const PatientBuild& build);

/// The most that a breath of that patient may be set to: half of the inspiratory capacity from
/// rest, 25 ml/kg, three and a half quiet breaths. The share is ours.
[[nodiscard]] Volume largestTidalVolume(const PatientBuild& build);

/// What a ventilator meets in a patient who does not breathe: the resting volume falls to a share
/// of it along the wall's line, as in anaesthesia, and each lung has 0.4 of its compliance there
/// (Pulse, lung under a ventilator), which leaves the system 50 to 80 ml/cmH2O in an adult.
void relax(RespiratorySystem& system, double rest = kRelaxedRest);

/// Puts a tracheal tube of an inner diameter in place of the airway above the carina: Poiseuille's
/// flow for K1 (128 mu L / (pi d^4)), and for K2 the loss of turbulent flow in a smooth tube at 1
/// L/s (Blasius) with 1.5 velocity heads for connector and ends; 300 mm long. The tube halves the
/// anatomical dead space.
/// @pre the diameter is above 0.
void intubate(RespiratorySystem& system, Length innerDiameter);

/// Moves every figure of `system` by a share of its distance to `target`: 1 arrives.
void approach(RespiratorySystem& system, const RespiratorySystem& target, double share);

} // namespace carina
