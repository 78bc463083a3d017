#include "apps/lab/summary/breath_estimate.h"

#include <algorithm>
#include <vector>

namespace carina::lab
{
namespace
{

/// Upward crossing of `level` between samples i and i+1, by linear interpolation.
struct Crossing {
    std::size_t after = 0; ///< index of the first sample above
    double time_s = 0.0;
};

std::vector<Crossing> upwardCrossings(std::span<const VolumeSample> samples, double level)
{
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double below = samples[i].volume_ml - level;
        const double above = samples[i + 1].volume_ml - level;
        if (below >= 0.0 || above < 0.0)
            continue;
        const double t0 = toSeconds(samples[i].time - samples.front().time);
        const double t1 = toSeconds(samples[i + 1].time - samples.front().time);
        crossings.push_back({i + 1, t0 + (t1 - t0) * below / (below - above)});
    }
    return crossings;
}

} // namespace

std::optional<BreathEstimate> estimateBreathing(std::span<const VolumeSample> samples)
{
    if (samples.size() < 2)
        return std::nullopt;
    const auto byVolume = [](const VolumeSample& a, const VolumeSample& b) {
        return a.volume_ml < b.volume_ml;
    };
    const auto [least, most] = std::minmax_element(samples.begin(), samples.end(), byVolume);
    const double middle = 0.5 * (least->volume_ml + most->volume_ml);
    const std::vector<Crossing> crossings = upwardCrossings(samples, middle);
    if (crossings.size() < 2 || most->volume_ml <= least->volume_ml)
        return std::nullopt;

    // Frames fall anywhere in a breath and miss its turning points by chance; over all breaths the
    // least is missed.
    const auto seen =
        samples.subspan(crossings.front().after, crossings.back().after - crossings.front().after);
    const auto [low, high] = std::minmax_element(seen.begin(), seen.end(), byVolume);
    const auto breaths = static_cast<int>(crossings.size()) - 1;
    const double lasted_s = crossings.back().time_s - crossings.front().time_s;
    return BreathEstimate{hertz(breaths / lasted_s), millilitres(high->volume_ml - low->volume_ml),
                          breaths};
}

} // namespace carina::lab
