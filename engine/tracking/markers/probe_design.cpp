#include "engine/tracking/markers/probe_design.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace carina
{
namespace
{

constexpr int kMostMarkers = 20;
constexpr int kCoarse = 160; ///< directions, while searching
constexpr double kMissingShare = 100.0;
constexpr double kMissingSpacing = 10.0;
constexpr Angle kGoodRotation = degrees(0.03);
constexpr Length kGoodPosition = millimetres(0.1);
constexpr double kFirstStep = 0.5; // rad
constexpr double kLastStep = 0.02;

/// Numbers that are the same on every computer, unlike those of the standard's distributions.
class LayoutDraw
{
public:
    explicit LayoutDraw(std::uint32_t seed) : m_random{seed} {}
    double part() { return 2.0 * double(m_random()) / double(std::mt19937::max()) - 1.0; }
    Vec3 vector() { return {part(), part(), part()}; }
    std::size_t index(std::size_t count) { return m_random() % count; }

private:
    std::mt19937 m_random;
};

ToolMarker facingOutward(const Vec3& direction, Length radius)
{
    return {radius.si * direction, direction};
}

double costOfLayout(const Probe& probe, const ProbeGoal& goal)
{
    const ProbeSurvey survey = surveyProbe(probe, goal.noise, goal.p_OQ, kCoarse);
    const double share = std::max(0.0, goal.share - survey.share[goal.seen]);
    const double spacing = std::max(0.0, 1.0 - closestMarkers(probe) / goal.spacing);
    return survey.rotation / kGoodRotation + survey.position / kGoodPosition
           + kMissingShare * (share + 1.0 - survey.posed) + kMissingSpacing * spacing;
}

Result<void> checkGoal(const ProbeGoal& goal)
{
    if (goal.markers < 4 || goal.markers > kMostMarkers)
        return fail(Errc::OutOfRange, "a probe has 4 to 20 markers");
    if (!(goal.radius.si > 0.0 && goal.spacing.si > 0.0))
        return fail(Errc::OutOfRange, "radius and spacing of a probe are above 0");
    if (goal.seen > std::size_t(goal.markers))
        return fail(Errc::OutOfRange, "more markers to be seen than the probe has");
    return {};
}

} // namespace

Length closestMarkers(const Probe& probe)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < probe.markers.size(); ++i)
        for (std::size_t j = i + 1; j < probe.markers.size(); ++j)
            least = std::min(least, (probe.markers[i].p_OQ - probe.markers[j].p_OQ).norm());
    return metres(least);
}

Result<Probe> designProbe(const ProbeGoal& goal)
{
    if (const auto sound = checkGoal(goal); !sound)
        return tl::unexpected(sound.error());
    LayoutDraw draw{goal.seed};
    Probe best;
    best.largestAngle = goal.largestAngle;
    constexpr double kUneven = 0.1; // so that no two distances are alike
    for (const Vec3& even : directionsAllRound(goal.markers))
        best.markers.push_back(
            facingOutward((even + kUneven * draw.vector()).normalized(), goal.radius));
    double least = costOfLayout(best, goal);
    for (int step = 0; step < goal.steps; ++step) {
        const double size =
            kFirstStep * std::pow(kLastStep / kFirstStep, double(step) / goal.steps);
        Probe moved = best;
        ToolMarker& marker = moved.markers[draw.index(moved.markers.size())];
        marker = facingOutward((marker.normal_O + size * draw.vector()).normalized(), goal.radius);
        const double cost = costOfLayout(moved, goal);
        if (cost < least) {
            least = cost;
            best = std::move(moved);
        }
    }
    return best;
}

} // namespace carina
