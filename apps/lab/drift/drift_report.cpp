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
/// Of the other strategies, beside the same in virtual time.
constexpr double kMachineAllowance_s = 0.3e-3;
constexpr double kVirtualsAllowed = 1.25;

double inDegrees(double rad) { return carina::inDegrees(radians(rad)); }

double boundByLimit(double limit, const DriftSettings& settings)
{
    const Duration asymmetry = settings.scenario.forward.delay - settings.scenario.backward.delay;
    return kLimitsAllowed * limit
           + settings.script.angularSpeed
                 * (kClockAllowance_s + std::abs(toSeconds(asymmetry)) / 2.0);
}

} // namespace

QJsonObject reportOf(const DriftFigures& figures)
{
    QJsonObject object{{drift_key::kAtEvent, inDegrees(figures.atEvent)},
                       {drift_key::kRawAtLast, QJsonValue::Null},
                       {drift_key::kRawGreatest, QJsonValue::Null},
                       {drift_key::kTimeAverage, inDegrees(figures.timeAverage)},
                       {drift_key::kPercentile, inDegrees(figures.p95)},
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
                     double inVirtualTime)
{
    const double bound =
        settings.strategy->kind == StrategyKind::SessionClock
            ? boundByLimit(figures.drift.limit, settings)
            : kVirtualsAllowed * inVirtualTime + settings.script.angularSpeed * kMachineAllowance_s;
    double load = 0.0;
    ::getloadavg(&load, 1);
    QJsonObject object = reportOf(figures.drift);
    object[drift_key::kLiveProbes] = QJsonValue::Null;
    if (figures.drift.bytesPerSecond <= 0.0) // where nobody counts
        object[drift_key::kLiveBytes] = QJsonValue::Null;
    object[drift_key::kLiveAccessLink] = QJsonValue::Null;
    object[drift_key::kLive] = true;
    object[drift_key::kBound] = inDegrees(bound);
    object[drift_key::kVirtual] = inDegrees(inVirtualTime);
    object[drift_key::kIsWithinBound] = figures.drift.timeAverage <= bound;
    object[drift_key::kIsEndStateSame] = figures.isEndStateSame;
    object[drift_key::kHandshakeMean] = 1e3 * toSeconds(figures.handshakeMean);
    object[drift_key::kHandshakeMax] = 1e3 * toSeconds(figures.handshakeMax);
    object[drift_key::kSampleGap] = 1e3 * toSeconds(figures.gapP95);
    object[drift_key::kLoad] = load;
    return object;
}

} // namespace carina::lab
