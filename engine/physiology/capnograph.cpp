#include "engine/physiology/capnograph.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

/// Carbon dioxide of the stomach's gas at the connector.
double fromStomach(CapnographState& state, double rate_perS, double seconds)
{
    state.stomachPhase += rate_perS * seconds;
    if (state.stomachPhase >= 1.0) {
        state.stomachPhase -= std::floor(state.stomachPhase);
        state.stomach_mmHg *= std::exp(-1.0 / kStomachBreaths);
    }
    if (rate_perS == 0.0 || state.stomachPhase < kStomachInspiration)
        return 0.0;
    const double through = (state.stomachPhase - kStomachInspiration) / (1.0 - kStomachInspiration);
    return std::exp(-1.0 / kStomachBreaths) * state.stomach_mmHg
           * std::sin(std::numbers::pi * through);
}

void atConnector(CapnographState& state, const SampledGas& gas, double seconds)
{
    const bool isStill = gas.moved_ml >= 0.0 && gas.moved_ml < 2.0 * gas.uptake_ml;
    const double share = isStill ? 0.0 : 1.0 - std::exp(-std::abs(gas.moved_ml) / gas.connector_ml);
    const double arriving = gas.moved_ml < 0.0 ? gas.passing * gas.exhaled_mmHg : 0.0;
    state.connector_mmHg += share * (arriving - state.connector_mmHg);
    const double wash = isStill && state.sinceBreath_s >= kHeldTime ? kApnoeaTime : kWashTime;
    state.connector_mmHg -= seconds / wash * state.connector_mmHg;
}

void countBreaths(CapnographState& state, double seconds)
{
    state.sinceBreath_s += seconds;
    state.lowest_mmHg = std::min(state.lowest_mmHg, state.sensor_mmHg);
    if (!state.inBreath && state.sensor_mmHg > state.lowest_mmHg + kBreathAt_mmHg) {
        if (state.hasBreath && state.sinceBreath_s < kNoBreathTime)
            state.rate_perS = 1.0 / state.sinceBreath_s;
        state.inBreath = true;
        state.sinceBreath_s = 0.0;
        state.highest_mmHg = 0.0;
    }
    if (state.inBreath) {
        state.highest_mmHg = std::max(state.highest_mmHg, state.sensor_mmHg);
        if (state.sensor_mmHg < 0.5 * state.highest_mmHg) {
            state.inBreath = false;
            state.hasBreath = true;
            state.endTidal_mmHg = state.highest_mmHg;
            state.lowest_mmHg = state.sensor_mmHg;
        }
    }
    if (state.sinceBreath_s >= kNoBreathTime)
        state.rate_perS = state.endTidal_mmHg = 0.0;
}

} // namespace

void sample(CapnographState& state, const SampledGas& gas, double seconds)
{
    if (gas.stomachRate_perS)
        state.connector_mmHg = fromStomach(state, *gas.stomachRate_perS, seconds);
    else
        atConnector(state, gas, seconds);
    double& place = state.line[static_cast<std::size_t>(state.next)];
    state.sensor_mmHg += seconds / kSensorTime * (place - state.sensor_mmHg);
    place = state.connector_mmHg;
    state.next = (state.next + 1) % static_cast<std::int64_t>(kSampleLine);
    countBreaths(state, seconds);
}

} // namespace carina
