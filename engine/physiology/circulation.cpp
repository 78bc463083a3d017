#include "engine/physiology/circulation.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// 0 up to `from`, 1 from `to` on, straight between; also falling.
double ramp(double value, double from, double to)
{
    return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

void follow(double& value, double target, double timeConstant, double seconds)
{
    value += std::min(1.0, seconds / timeConstant) * (target - value);
}

void beAlarmed(CirculationState& state, const CirculatoryLoad& load, double seconds)
{
    constexpr double kRise = 12.0;
    constexpr double kFade = 120.0;
    constexpr double kAccustoming = 120.0;
    constexpr double kDulled = 0.85;
    follow(state.accustomed, load.tubeStimulus, kAccustoming, seconds);
    const double tube = std::max(0.0, load.tubeStimulus - state.accustomed);
    const double target = std::max(load.bladeStimulus, tube) * (1.0 - kDulled * load.analgesia);
    follow(state.alarm, target, target > state.alarm ? kRise : kFade, seconds);
}

double venousReturn(double tension) { return 1.0 - 0.6 * std::min(1.4, tension); }

void takeHarm(CirculationState& state, const BodyFigures& body, double saturation, double seconds)
{
    constexpr double kTime = 120.0;
    constexpr double kHealing = 300.0;
    const double rate =
        ramp(saturation, 0.6, 0.0) + ramp(state.mean_mmHg / body.mean_mmHg, 0.4, 0.0);
    state.harm += rate > 0.0 ? seconds / kTime * rate : -seconds / kHealing * state.harm;
    state.arrested = state.arrested || state.harm >= 1.0;
}

void stop(CirculationState& state, double seconds)
{
    constexpr double kFilling_mmHg = 7.0; // mean pressure of a circulation at rest
    constexpr double kFall = 4.0;
    state.heartRate_perS = 0.0;
    state.beat = 0.0;
    follow(state.mean_mmHg, kFilling_mmHg, kFall, seconds);
    follow(state.pulse_mmHg, 0.0, 0.3, seconds);
}

} // namespace

CirculationState quietCirculation(const BodyFigures& body)
{
    CirculationState state;
    state.heartRate_perS = body.heartRate_perMin / 60.0;
    state.mean_mmHg = body.mean_mmHg;
    state.pulse_mmHg = body.pulse_mmHg;
    return state;
}

double cardiacOutput_mlPerS(const CirculationState& state, const BodyFigures& body)
{
    const double rate = 60.0 * state.heartRate_perS / body.heartRate_perMin;
    const double stroke = state.pulse_mmHg / body.pulse_mmHg;
    return std::min(rate, 0.5 + 0.5 * rate) * std::min(stroke, 1.0) * body.cardiacOutput_mlPerS;
}

void advance(CirculationState& state, const BodyFigures& body, const CirculatoryLoad& load,
             double seconds)
{
    constexpr double kRateTime = 5.0;
    constexpr double kPressureTime = 8.0;
    takeHarm(state, body, load.saturation, seconds);
    if (state.arrested)
        return stop(state, seconds);
    beAlarmed(state, load, seconds);
    const double lack = ramp(load.saturation, 0.94, 0.80);
    const double failing = ramp(load.saturation, 0.68, 0.40);
    const double tension = std::min(1.0, load.tension);
    const double rate = (1.0 + kAlarmRate * state.alarm) * (1.0 + 0.25 * lack)
                        * (1.0 + 0.7 * tension) * (1.0 - 0.75 * failing) * load.rateByDrugs;
    const double filling = venousReturn(load.tension);
    const double pressure = (1.0 + kAlarmPressure * state.alarm) * (1.0 + 0.1 * lack)
                            * (1.0 - 0.6 * failing) * filling * load.pressureByDrugs;
    follow(state.heartRate_perS, rate * body.heartRate_perMin / 60.0, kRateTime, seconds);
    follow(state.mean_mmHg, pressure * body.mean_mmHg, kPressureTime, seconds);
    follow(state.pulse_mmHg, filling * (1.0 - 0.3 * failing) * body.pulse_mmHg, kPressureTime,
           seconds);
    state.beat += state.heartRate_perS * seconds;
    state.beat -= std::floor(state.beat);
}

} // namespace carina
