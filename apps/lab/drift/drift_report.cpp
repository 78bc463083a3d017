#include "apps/lab/drift/drift_report.h"

#include "apps/lab/drift/drift_page.h"
#include "engine/core/units.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace carina::lab
{
namespace
{

constexpr double kClockAllowance_s = 0.2e-3;
constexpr double kLimitsAllowed = 1.5;
/// Of every strategy, beside the same in virtual time.
constexpr double kMachineAllowance_s = 0.3e-3;
constexpr double kVirtualsAllowed = 1.25;

double inDegrees(double rad) { return carina::inDegrees(radians(rad)); }

/// How far two clocks may be apart that nothing else than the path and the clocks disciplined from
/// outside can compare.
double clockAllowance(const DriftScenario& scenario)
{
    const double asymmetry = std::abs(toSeconds(scenario.forward.delay - scenario.backward.delay));
    const double unseen = scenario.externalClocks
                              ? std::min(asymmetry / 2.0, toSeconds(*scenario.externalClocks))
                              : asymmetry / 2.0;
    return kClockAllowance_s + unseen;
}

/// How old the newest frame is on average.
double halfAFrame(const ViewFrames& frames) { return frames.rate > 0.0 ? 0.5 / frames.rate : 0.0; }

double boundByLimit(double limit, const DriftSettings& settings)
{
    return kLimitsAllowed * limit
           + settings.script.angularSpeed
                 * (clockAllowance(settings.scenario) + halfAFrame(settings.scenario.frames));
}

double boundByVirtualTime(double average, const DriftSettings& settings)
{
    return kVirtualsAllowed * average + settings.script.angularSpeed * kMachineAllowance_s;
}

bool repeatsWhatIsLost(const DriftSettings& settings)
{
    const StrategyKind kind = settings.strategy->kind;
    return kind == StrategyKind::SessionClock || kind == StrategyKind::LocalLag;
}

/// What is judged: with a strategy that repeats what is lost, over all actions.
double judgedAverage(const DriftFigures& figures, const DriftSettings& settings)
{
    return repeatsWhatIsLost(settings) ? figures.timeAverage
                                       : figures.timeAverageShown.value_or(figures.timeAverage);
}

bool losesMessages(const PathProfile& path)
{
    return path.loss > 0.0 || path.burst || path.trace || path.bitsPerSecond > 0.0
           || path.cutFor > Duration{};
}

/// How many actions may not be shown: as many as in virtual time and three standard deviations of a
/// Poisson distribution, and one action, by all viewers, where a message can be lost for good.
double lostAllowed(const DriftSettings& settings, const DriftFigures& inVirtualTime)
{
    const DriftScenario& scenario = settings.scenario;
    const bool losesForGood =
        !repeatsWhatIsLost(settings)
        && (losesMessages(scenario.forward) || losesMessages(scenario.backward));
    const double viewers = settings.participants - 1.0;
    return inVirtualTime.lost + 3.0 * std::sqrt(inVirtualTime.lost)
           + (losesForGood ? viewers : 0.0);
}

double boundOf(const LiveFigures& figures, const DriftSettings& settings,
               const DriftFigures& inVirtualTime)
{
    const double byVirtualTime =
        boundByVirtualTime(judgedAverage(inVirtualTime, settings), settings);
    return settings.strategy->kind == StrategyKind::SessionClock
               ? std::min(byVirtualTime, boundByLimit(figures.drift.limit, settings))
               : byVirtualTime;
}

QJsonValue shownAverage(const DriftFigures& figures)
{
    return figures.timeAverageShown ? QJsonValue{inDegrees(*figures.timeAverageShown)}
                                    : QJsonValue{QJsonValue::Null};
}

} // namespace

QJsonObject reportOf(const DriftFigures& figures)
{
    QJsonObject object{{drift_key::kAtEvent, inDegrees(figures.atEvent)},
                       {drift_key::kRawAtLast, QJsonValue::Null},
                       {drift_key::kRawGreatest, QJsonValue::Null},
                       {drift_key::kTimeAverage, inDegrees(figures.timeAverage)},
                       {drift_key::kPercentile, inDegrees(figures.p95)},
                       {drift_key::kLost, figures.lost},
                       {drift_key::kShown, shownAverage(figures)},
                       {drift_key::kPosition, inMillimetres(metres(figures.position))},
                       {drift_key::kLimit, inDegrees(figures.limit)},
                       {drift_key::kRatio, QJsonValue::Null},
                       {drift_key::kResponse, figures.response * 1e3},
                       {drift_key::kClockError, QJsonValue::Null},
                       {drift_key::kBytes, figures.bytesPerSecond},
                       {drift_key::kProbes, figures.probesPerSecond}};
    if (!figures.actions.empty()) {
        const auto& actions = figures.actions;
        object[drift_key::kRawAtLast] = inDegrees(actions.back().rawAngle);
        object[drift_key::kRawGreatest] =
            inDegrees(std::ranges::max(actions, {}, &ActionDrift::rawAngle).rawAngle);
    }
    if (figures.limit > 0.0)
        object[drift_key::kRatio] = figures.timeAverage / figures.limit;
    if (figures.clockError)
        object[drift_key::kClockError] = *figures.clockError * 1e3;
    return object;
}

QJsonObject reportOf(const LiveFigures& figures, const DriftSettings& settings,
                     const DriftFigures& inVirtualTime)
{
    const double bound = boundOf(figures, settings, inVirtualTime);
    const double allowed = lostAllowed(settings, inVirtualTime);
    double load = 0.0;
    ::getloadavg(&load, 1);
    QJsonObject object = reportOf(figures.drift);
    object[drift_key::kLiveProbes] = QJsonValue::Null;
    if (figures.drift.bytesPerSecond <= 0.0) // where nobody counts
        object[drift_key::kLiveBytes] = QJsonValue::Null;
    object[drift_key::kLiveAccessLink] = QJsonValue::Null;
    object[drift_key::kLive] = true;
    object[drift_key::kBound] = inDegrees(bound);
    object[drift_key::kVirtual] = inDegrees(inVirtualTime.timeAverage);
    object[drift_key::kVirtualShown] = shownAverage(inVirtualTime);
    object[drift_key::kLostBound] = allowed;
    object[drift_key::kIsWithinBound] =
        judgedAverage(figures.drift, settings) <= bound && figures.drift.lost <= allowed;
    object[drift_key::kIsEndStateSame] = figures.isEndStateSame;
    object[drift_key::kHandshakeMean] = 1e3 * toSeconds(figures.handshakeMean);
    object[drift_key::kHandshakeMax] = 1e3 * toSeconds(figures.handshakeMax);
    object[drift_key::kSampleGap] = 1e3 * toSeconds(figures.gapP95);
    object[drift_key::kLoad] = load;
    return object;
}

} // namespace carina::lab
