#include "apps/lab/drift/drift_report.h"

#include "engine/core/units.h"

#include <cmath>
#include <cstdlib>

namespace carina::lab
{
namespace
{

constexpr double kClockAllowance_s = 0.2e-3;
constexpr double kLimitsAllowed = 1.5;

double inDegrees(double rad) { return carina::inDegrees(radians(rad)); }

} // namespace

QJsonObject reportOf(const DriftFigures& figures)
{
    QJsonObject object{
        {QStringLiteral("at_event_mean_deg"), inDegrees(figures.atEvent)},
        {QStringLiteral("time_average_mean_deg"), inDegrees(figures.timeAverage)},
        {QStringLiteral("p95_deg"), inDegrees(figures.p95)},
        {QStringLiteral("position_mean_mm"), inMillimetres(metres(figures.position))},
        {QStringLiteral("limit_time_average_deg"), inDegrees(figures.limit)},
        {QStringLiteral("ratio_to_limit"), QJsonValue::Null},
        {QStringLiteral("clock_error_ms"), QJsonValue::Null},
        {QStringLiteral("bytes_per_s"), figures.bytesPerSecond},
        {QStringLiteral("probes_per_s"), figures.probesPerSecond}};
    if (figures.limit > 0.0)
        object[QStringLiteral("ratio_to_limit")] = figures.timeAverage / figures.limit;
    if (figures.clockError)
        object[QStringLiteral("clock_error_ms")] = *figures.clockError * 1e3;
    return object;
}

QJsonObject reportOf(const LiveFigures& figures, const ActionScript::Settings& script,
                     const DriftScenario& scenario)
{
    const double asymmetry = std::abs(toSeconds(scenario.forward.delay - scenario.backward.delay));
    const double bound = kLimitsAllowed * figures.drift.limit
                         + script.angularSpeed * (kClockAllowance_s + asymmetry / 2.0);
    double load = 0.0;
    ::getloadavg(&load, 1);
    QJsonObject object = reportOf(figures.drift);
    object[QStringLiteral("probes_per_s")] = QJsonValue::Null;
    if (figures.drift.bytesPerSecond <= 0.0) // where nobody counts
        object[QStringLiteral("bytes_per_s")] = QJsonValue::Null;
    object[QStringLiteral("access_link")] = QJsonValue::Null;
    object[QStringLiteral("live")] = true;
    object[QStringLiteral("bound_time_average_deg")] = inDegrees(bound);
    object[QStringLiteral("is_within_bound")] = figures.drift.timeAverage <= bound;
    object[QStringLiteral("is_end_state_same")] = figures.isEndStateSame;
    object[QStringLiteral("handshake_mean_ms")] = 1e3 * toSeconds(figures.handshakeMean);
    object[QStringLiteral("handshake_max_ms")] = 1e3 * toSeconds(figures.handshakeMax);
    object[QStringLiteral("sample_gap_p95_ms")] = 1e3 * toSeconds(figures.gapP95);
    object[QStringLiteral("load_average")] = load;
    return object;
}

} // namespace carina::lab
