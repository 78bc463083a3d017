#include "apps/lab/drift/drift_table.h"

#include "apps/lab/drift/drift_measurement.h"
#include "apps/lab/drift/drift_page.h"

#include <QJsonArray>

#include <array>
#include <cstdio>

namespace carina::lab
{
namespace
{

/// The keys of a run that a row of a table has.
constexpr std::array kOfRow{
    drift_key::kScenario,       drift_key::kStrategy,    drift_key::kParticipants,
    drift_key::kAtEvent,        drift_key::kTimeAverage, drift_key::kLost,
    drift_key::kShown,          drift_key::kVirtual,     drift_key::kVirtualShown,
    drift_key::kLimit,          drift_key::kBound,       drift_key::kLostBound,
    drift_key::kIsWithinBound,  drift_key::kResponse,    drift_key::kClockError,
    drift_key::kIsEndStateSame, drift_key::kSampleGap,   drift_key::kLoad,
    drift_key::kLoopbackMedian, drift_key::kLoopbackP95};

/// A run as a row; what failed is one, too, because the others took minutes.
QJsonObject rowOf(const DriftRequest& request)
{
    QJsonObject run;
    describeRequest(request, run);
    QJsonObject row;
    if (const auto measured = measuredDrift(request))
        run = *measured;
    else
        row[drift_key::kRowError] = QString::fromStdString(measured.error().detail);
    for (const Key& key : kOfRow)
        row[key] = run.contains(key) ? run[key] : QJsonValue{QJsonValue::Null};
    return row;
}

} // namespace

std::vector<Key> keysOfRow() { return {kOfRow.begin(), kOfRow.end()}; }

Result<QJsonObject> driftTable(const Words& words)
{
    const auto requests = tableRequests(words);
    if (!requests)
        return tl::unexpected(requests.error());
    QJsonArray rows;
    int met = 0;
    for (const DriftRequest& request : *requests) {
        const DriftSettings& settings = request.settings;
        std::fprintf(stderr, "drift: %d of %zu: %s, %s, %d participants\n", int(rows.size()) + 1,
                     requests->size(), settings.scenario.name.c_str(),
                     std::string{settings.strategy->name}.c_str(), int{settings.participants});
        const QJsonObject row = rowOf(request);
        met += row[drift_key::kIsWithinBound].toBool() ? 1 : 0;
        rows.append(row);
    }
    const DriftRequest& one = requests->front();
    QJsonObject described;
    describeRequest(one, described);
    QJsonObject object{
        {drift_key::kTableSchema, QLatin1StringView{drift_key::kTableSchema.help}},
        {drift_key::kNetwork, QLatin1StringView{one.netlab.isEmpty() ? "relay" : "netlab"}},
        {drift_key::kWarmUpTime, toSeconds(one.settings.warmUp)},
        {drift_key::kRows, rows},
        {drift_key::kMet, met},
        {drift_key::kMissed, int(rows.size()) - met}};
    for (const Key& key : {drift_key::kTurningSpeed, drift_key::kMovingSpeed, drift_key::kActions,
                           drift_key::kExternalClocks, drift_key::kLocalLag, drift_key::kAsaDelays,
                           drift_key::kSeed})
        object[key] = described[key];
    return object;
}

} // namespace carina::lab
