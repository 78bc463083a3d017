#include "engine/physiology/oximeter.h"

#include <cmath>

namespace carina
{

OximeterState settledAt(double saturation)
{
    OximeterState state;
    state.way.fill(saturation);
    state.shown = saturation;
    return state;
}

void watch(OximeterState& state, double saturation, double seconds)
{
    const auto perSample = std::llround(kFingerSampleEvery / seconds);
    const auto place = static_cast<std::size_t>(state.steps / perSample) % kWayToFinger;
    state.shown += seconds / kAveraging * (state.way[place] - state.shown);
    ++state.steps;
    if (state.steps % perSample == 0)
        state.way[place] = saturation;
}

} // namespace carina
