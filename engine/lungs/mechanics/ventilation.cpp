#include "engine/lungs/mechanics/ventilation.h"

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

/// The muscle pressure that holds a volume without flow and hysteresis.
Pressure elasticEffort(const RespiratorySystem& system, Volume volume)
{
    double compliance = 0.0;
    for (const LungMechanics& lung : system.lungs)
        compliance +=
            1.0 / (1.0 / lung.curve.complianceAt(lung.wallVolume).si + 1.0 / lung.wall.si);
    return {volume.si / compliance};
}

Volume gasIn(const ChestContent& content) { return content[0].gas + content[1].gas; }

/// Tidal volume of steady breathing.
Volume breathed(const RespiratorySystem& system, ChestContent content,
                const BreathingPattern& pattern, Pressure effort)
{
    constexpr int kBreaths = 4; // by then
    constexpr double kStep_s = 0.01;
    const auto perBreath = std::llround(std::ceil(1.0 / (pattern.rate.si * kStep_s)));
    const auto muscleAt = [&](double phase) {
        return (phase < 1.0 ? muscleShare(phase, pattern.inspiratoryFraction) : 0.0) * effort;
    };
    Volume least;
    Volume most;
    for (int breath = 0; breath < kBreaths; ++breath) {
        least = most = gasIn(content);
        for (long i = 0; i < perBreath; ++i) {
            const double whole = double(perBreath);
            content = advanced(system, content,
                               {muscleAt(double(i) / whole), muscleAt((double(i) + 0.5) / whole),
                                muscleAt((double(i) + 1.0) / whole)},
                               AirwayOpening::at({}), 1.0 / (pattern.rate.si * whole));
            least = std::min(least, gasIn(content));
            most = std::max(most, gasIn(content));
        }
    }
    return most - least;
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

double coughShare(double seconds)
{
    CARINA_EXPECTS(seconds >= 0.0);
    const double within = std::fmod(seconds, kCoughEvery);
    return within < kCoughBurst ? std::sin(std::numbers::pi * within / kCoughBurst) : 0.0;
}

double meanMuscleShare(double inspiratoryFraction)
{
    const double fall = std::min(kFallShare * inspiratoryFraction, 1.0 - inspiratoryFraction);
    return (1.0 - 0.5 * kRiseShare) * inspiratoryFraction + 0.5 * fall;
}

Pressure effortFor(const RespiratorySystem& system, const BreathingPattern& pattern)
{
    constexpr int kMostTries = 8;
    constexpr double kNear = 1e-3; // of the volume
    const ChestContent rest = restingContent(system);
    Pressure effort = elasticEffort(system, pattern.tidalVolume);
    Pressure before;
    Volume gained; // with that
    for (int tried = 0; tried < kMostTries; ++tried) {
        const Volume now = breathed(system, rest, pattern, effort);
        const Volume missing = pattern.tidalVolume - now;
        if (std::abs(missing.si) <= kNear * pattern.tidalVolume.si || now <= gained)
            break;
        const Compliance compliance{(now - gained).si / (effort - before).si};
        before = effort;
        gained = now;
        effort = std::max(0.5 * before, before + Pressure{missing.si / compliance.si});
    }
    return effort;
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
