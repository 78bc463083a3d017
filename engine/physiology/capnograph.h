#pragma once

#include "engine/physiology/body_state.h"

#include <optional>

namespace carina
{

/// What passes the place where the capnograph takes its sample, at the mask or the tube's
/// connector, in one step.
struct SampledGas {
    double moved_ml = 0.0;     ///< towards the patient if positive
    double uptake_ml = 0.0;    ///< that the blood takes up at rest
    double exhaled_mmHg = 0.0; ///< carbon dioxide of gas that leaves the patient
    double passing = 1.0;      ///< share of exhaled gas in what is sampled
    double connector_ml = 1.0; ///< volume that is mixed there
    /// Breaths that are blown into the stomach, per second; nothing where the tube is not there.
    std::optional<double> stomachRate_perS;
};

/// A sidestream capnograph: the sample travels kSampleLine steps, and the sensor follows it with a
/// time constant of kSensorTime. Where nothing moves, what is drawn off is replaced by fresh gas,
/// at first from the airway's own gas behind it, with a time constant of kWashTime; kHeldTime after
/// the last breath's rise that is drawn off too, and the rest goes with kApnoeaTime. An inflow of
/// up to twice the uptake counts as none. A breath begins where the curve rises by kBreathAt above
/// its lowest value and ends where it falls below half of its highest, which is then the end-tidal
/// value. kNoBreathTime after the last beginning rate and end-tidal value are 0.
///
/// An oesophageal tube brings what earlier breaths left in the stomach: the n-th breath has A0
/// exp(-n / kStomachBreaths) and the shape of a hump. The form is ours; that the gas is low and
/// gone after a few breaths is from Linko et al. (Acta Anaesthesiol Scand 1983;27:199).
void sample(CapnographState& state, const SampledGas& gas, double seconds);

inline constexpr double kSensorTime = 0.1; ///< s; with a delay of 1.5 s, ours
inline constexpr double kWashTime = 30.0;  ///< s, ours
inline constexpr double kHeldTime = 8.0;   ///< s, the longest plateau; ours
/// s: what 200 ml/min of a sidestream draw off of a connector of 17 ml.
inline constexpr double kApnoeaTime = 5.0;
inline constexpr double kBreathAt_mmHg = 3.0; ///< ours
inline constexpr double kNoBreathTime = 20.0; ///< s, as alarms of apnoea are set
inline constexpr double kStomachBreaths = 1.5;
/// Share of a breath in which it is blown into the stomach: as from a bag, 1:2.
inline constexpr double kStomachInspiration = 1.0 / 3.0;
/// A0: carbon dioxide in the stomach at first (0 to 15 are reported; the value is ours).
inline constexpr double kStomachAtFirst_mmHg = 12.0;

} // namespace carina
