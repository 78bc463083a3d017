#include "engine/lungs/ventilation.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

/// 0 to 1 along half a period of a cosine.
double halfSine(double share) { return 0.5 * (1.0 - std::cos(std::numbers::pi * share)); }

std::int64_t steps(double seconds, double step)
{
    return std::max<std::int64_t>(1, std::llround(seconds / step));
}

} // namespace

double muscleShare(double phase, double inspiratoryFraction)
{
    CARINA_EXPECTS(phase >= 0.0 && phase < 1.0);
    CARINA_EXPECTS(inspiratoryFraction >= 0.1 && inspiratoryFraction <= 0.9);
    const double rise = kRiseShare * inspiratoryFraction;
    const double fall = std::min(kFallShare * inspiratoryFraction, 1.0 - inspiratoryFraction);
    if (phase < rise)
        return halfSine(phase / rise);
    if (phase <= inspiratoryFraction)
        return 1.0;
    return 1.0 - halfSine(std::min(1.0, (phase - inspiratoryFraction) / fall));
}

Pressure effortFor(const RespiratorySystem& system, Volume tidalVolume)
{
    // Both lungs of a healthy patient are alike but for their size; the right one speaks for both.
    const LungMechanics& lung = system.lungs[0];
    const LungMechanics& other = system.lungs[1];
    const double share = lung.wall.si / (lung.wall.si + other.wall.si);
    const Volume taken = share * tidalVolume;
    const Pressure elastic =
        lung.curve.pressureAt(lung.wallVolume + taken) - lung.curve.pressureAt(lung.wallVolume);
    const Pressure loop = std::tanh(0.5 * (taken / lung.limbVolume)) * lung.limbSpread;
    return elastic + Pressure{taken.si / lung.wall.si} + loop;
}

double arrivedShare(const RespiratorySystem& system, const BreathingPattern& pattern)
{
    double compliance = 0.0;
    double bronchi = 0.0;
    for (const LungMechanics& lung : system.lungs) {
        compliance +=
            1.0 / (1.0 / lung.curve.complianceAt(lung.wallVolume).si + 1.0 / lung.wall.si);
        bronchi += lung.bronchi.si;
    }
    const double tau = (system.upperLaminar.si + 1.0 / bronchi) * compliance;
    const double inspiration = pattern.inspiratoryFraction / pattern.rate.si;
    const double rise = kRiseShare * inspiration;
    const double lag = std::numbers::pi * tau / rise; // w tau
    const double behind =
        (1.0 + std::exp(-rise / tau)) * lag * lag / (2.0 * (1.0 + lag * lag)); // as it is reached
    return 1.0 - behind * std::exp(-(inspiration - rise) / tau);
}

VentilatorTiming ventilatorTiming(const VentilatorSettings& settings,
                                  const BreathingPattern& pattern, double step)
{
    CARINA_EXPECTS(pattern.rate.si > 0.0);
    CARINA_EXPECTS(settings.pauseShare >= 0.0 && settings.pauseShare < 1.0);
    const double breath = 1.0 / pattern.rate.si;
    const double inspiration = pattern.inspiratoryFraction * breath;
    return {steps((1.0 - settings.pauseShare) * inspiration, step), steps(inspiration, step),
            steps(breath, step)};
}

AirwayOpening ventilatorOpening(const VentilatorSettings& settings, const VentilatorTiming& timing,
                                Volume tidalVolume, const VentilatorState& state, double step)
{
    if (state.sinceBreath >= timing.inspiration)
        return AirwayOpening::at(settings.peep);
    if (settings.mode == VentilationMode::PressureControl) {
        const double since = static_cast<double>(state.sinceBreath) * step;
        const double risen = std::min(1.0, since / kPressureRise);
        return AirwayOpening::at(settings.peep + risen * settings.drivingPressure);
    }
    const bool flows = state.sinceBreath < timing.flow;
    const double seconds = static_cast<double>(timing.flow) * step;
    return AirwayOpening::driven({flows ? tidalVolume.si / seconds : 0.0},
                                 std::max(settings.pressureLimit, settings.peep));
}

} // namespace carina
