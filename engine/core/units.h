#pragma once

#include <compare>
#include <numbers>

namespace carina
{

/// A scalar with a dimension, stored in its SI unit. It is constructed from and read in a named
/// unit, so that each unit conversion is written once, here.
template <class Dimension> struct Quantity {
    double si = 0.0;

    friend constexpr auto operator<=>(const Quantity&, const Quantity&) = default;
    friend constexpr Quantity operator+(Quantity a, Quantity b) { return {a.si + b.si}; }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return {a.si - b.si}; }
    friend constexpr Quantity operator*(double k, Quantity a) { return {k * a.si}; }
    friend constexpr Quantity operator*(Quantity a, double k) { return {k * a.si}; }
    friend constexpr double operator/(Quantity a, Quantity b) { return a.si / b.si; }
};

using Length = Quantity<struct LengthDimension>;         ///< metres
using Angle = Quantity<struct AngleDimension>;           ///< radians
using Force = Quantity<struct ForceDimension>;           ///< newtons
using Volume = Quantity<struct VolumeDimension>;         ///< cubic metres
using Frequency = Quantity<struct FrequencyDimension>;   ///< per second
using Pressure = Quantity<struct PressureDimension>;     ///< gauge pressure: pascals above ambient
using VolumeFlow = Quantity<struct VolumeFlowDimension>; ///< cubic metres per second
using Compliance = Quantity<struct ComplianceDimension>; ///< cubic metres per pascal
using Conductance =
    Quantity<struct ConductanceDimension>;               ///< of gas: cubic metres per pascal second
using Resistance = Quantity<struct ResistanceDimension>; ///< to gas: pascal seconds per cubic metre

constexpr Length metres(double m) { return {m}; }
constexpr Length millimetres(double mm) { return {mm * 1e-3}; }
constexpr double inMillimetres(Length l) { return l.si * 1e3; }

constexpr Angle radians(double rad) { return {rad}; }
constexpr Angle degrees(double deg) { return {deg * (std::numbers::pi / 180.0)}; }
constexpr double inDegrees(Angle a) { return a.si * (180.0 / std::numbers::pi); }

constexpr Force newtons(double n) { return {n}; }
constexpr double inNewtons(Force f) { return f.si; }

constexpr Volume cubicMetres(double m3) { return {m3}; }
constexpr Volume litres(double l) { return {l * 1e-3}; }
constexpr double inLitres(Volume v) { return v.si * 1e3; }
constexpr Volume millilitres(double ml) { return {ml * 1e-6}; }
constexpr double inMillilitres(Volume v) { return v.si * 1e6; }

constexpr Frequency hertz(double hz) { return {hz}; }
constexpr Frequency perMinute(double perMin) { return {perMin / 60.0}; }
constexpr double inPerMinute(Frequency f) { return f.si * 60.0; }

inline constexpr double kPascalsPerCmH2O = 98.0665; ///< the conventional centimetre of water

constexpr Pressure cmH2O(double p) { return {p * kPascalsPerCmH2O}; }
constexpr double inCmH2O(Pressure p) { return p.si / kPascalsPerCmH2O; }

inline constexpr double kPascalsPerMmHg = 133.322387415; ///< the conventional millimetre of mercury

constexpr Pressure mmHg(double p) { return {p * kPascalsPerMmHg}; }
constexpr double inMmHg(Pressure p) { return p.si / kPascalsPerMmHg; }

constexpr VolumeFlow litresPerSecond(double q) { return {q * 1e-3}; }
constexpr VolumeFlow litresPerMinute(double q) { return litresPerSecond(q / 60.0); }
constexpr double inLitresPerMinute(VolumeFlow q) { return q.si * 6e4; }
constexpr double inLitresPerSecond(VolumeFlow q) { return q.si * 1e3; }

constexpr Compliance litresPerCmH2O(double c) { return {c * 1e-3 / kPascalsPerCmH2O}; }
constexpr double inLitresPerCmH2O(Compliance c) { return c.si * 1e3 * kPascalsPerCmH2O; }

/// The usual unit of airway resistance, cmH2O s/L.
constexpr Resistance cmH2OSecondsPerLitre(double r) { return {r * 1e3 * kPascalsPerCmH2O}; }
constexpr double inCmH2OSecondsPerLitre(Resistance r) { return r.si * 1e-3 / kPascalsPerCmH2O; }

} // namespace carina
