#include "apps/lab/summary/drift_between.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace carina::lab
{
namespace
{

/// Frames of the owner further apart than this are not interpolated between.
constexpr Duration kLongestGap = std::chrono::milliseconds{100};

struct Statistics {
    double mean = 0.0, p95 = 0.0, largest = 0.0;
};

Statistics statisticsOf(std::vector<double> values)
{
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    const std::size_t rank = (values.size() * 95 + 99) / 100 - 1; // nearest-rank percentile
    return {sum / double(values.size()), values[rank], values.back()};
}

double shareBetween(auto before, auto after, auto at)
{
    return after > before ? toSeconds(at - before) / toSeconds(after - before) : 0.0;
}

/// Two neighbouring frames of the owner around a time told by `timeOf`, or null.
std::pair<const LoggedFrame*, const LoggedFrame*> around(std::span<const LoggedFrame> owner,
                                                         auto at, auto timeOf)
{
    const auto after = std::ranges::upper_bound(owner, at, {}, timeOf);
    if (after == owner.begin() || after == owner.end())
        return {nullptr, nullptr};
    const auto before = std::prev(after);
    if (timeOf(*after) - timeOf(*before) > kLongestGap)
        return {nullptr, nullptr};
    return {&*before, &*after};
}

} // namespace

DriftSummary driftBetween(std::span<const LoggedFrame> owner, std::span<const LoggedFrame> viewer,
                          LoggedPose pose)
{
    std::vector<double> angles_deg;
    std::vector<double> distances_mm;
    std::vector<double> clocks_ms;
    for (const LoggedFrame& seen : viewer) {
        const auto [s0, s1] = around(owner, seen.session, [](const auto& f) { return f.session; });
        const std::optional<RigidTransform>& X_AF = seen.*pose;
        if (s0 && X_AF && s0->*pose && s1->*pose) {
            const RigidTransform X_AO = interpolate(
                *(s0->*pose), *(s1->*pose), shareBetween(s0->session, s1->session, seen.session));
            angles_deg.push_back(inDegrees(angleBetween(X_AO.rotation(), X_AF->rotation())));
            distances_mm.push_back(
                inMillimetres(metres((X_AO.translation() - X_AF->translation()).norm())));
        }
        const auto [l0, l1] = around(owner, seen.local, [](const auto& f) { return f.local; });
        if (l0) {
            const double share = shareBetween(l0->local, l1->local, seen.local);
            const Duration session = l0->session - seen.session
                                     + fromSeconds(share * toSeconds(l1->session - l0->session));
            clocks_ms.push_back(1e3 * std::abs(toSeconds(session)));
        }
    }
    const Statistics angle = statisticsOf(angles_deg);
    const Statistics distance = statisticsOf(distances_mm);
    const Statistics clock = statisticsOf(clocks_ms);
    return {.instants = static_cast<int>(angles_deg.size()),
            .mean_deg = angle.mean,
            .p95_deg = angle.p95,
            .largest_deg = angle.largest,
            .mean_mm = distance.mean,
            .p95_mm = distance.p95,
            .largest_mm = distance.largest,
            .clockInstants = static_cast<int>(clocks_ms.size()),
            .clockMean_ms = clock.mean,
            .clockLargest_ms = clock.largest};
}

} // namespace carina::lab
