#include "apps/lab/drift/drift_measurement.h"

#include "apps/lab/drift/drift_page.h"
#include "apps/lab/drift/drift_report.h"
#include "apps/lab/drift/live_drift.h"
#include "apps/lab/network/loopback_round_trip.h"
#include "engine/core/units.h"
#include "engine/io/files/whole_file.h"
#include "evaluation/network/netlab_network.h"

#include <QCoreApplication>

namespace carina::lab
{
namespace
{

/// Runs in virtual time with which a live one is compared.
constexpr int kVirtualSeeds = 20;

QString inLatin1(std::string_view name)
{
    return QString::fromLatin1(name.data(), qsizetype(name.size()));
}

Result<std::unique_ptr<LiveNetwork>> networkOf(const DriftRequest& request)
{
    const DriftSettings& settings = request.settings;
    if (request.netlab.isEmpty())
        return relayedNetwork(settings.participants, settings.scenario, settings.seed);
    return netlabNetwork(request.netlab, settings.participants, settings.scenario, settings.seed);
}

Result<QJsonObject> measureLive(const DriftRequest& request)
{
    const DriftSettings& settings = request.settings;
    if (!request.logs.isEmpty())
        if (const auto opened = openFolder(request.logs.toStdString()); !opened)
            return fail(Errc::WrongOption, "drift: --logs " + opened.error().detail + '.');
    const auto machine = loopbackRoundTrip();
    if (!machine)
        return tl::unexpected(machine.error());
    const auto network = networkOf(request);
    if (!network)
        return tl::unexpected(network.error());
    LiveSettings live = liveSettingsOf(settings, QCoreApplication::applicationFilePath());
    live.logs = request.logs;
    return runLiveDrift(live, **network).map([&](const LiveFigures& figures) {
        QJsonObject object = reportOf(figures, settings, runDrift(settings, kVirtualSeeds));
        object[drift_key::kNetwork] = (*network)->name();
        object[drift_key::kLoopbackMedian] = 1e3 * toSeconds(machine->median);
        object[drift_key::kLoopbackP95] = 1e3 * toSeconds(machine->p95);
        return object;
    });
}

QJsonObject measureVirtual(DriftRequest request)
{
    QJsonObject object = reportOf(runDrift(request.settings, request.seeds));
    request.settings.legs = VirtualStar::Legs::FullPath;
    object[drift_key::kAccessLink] = reportOf(runDrift(request.settings, request.seeds));
    return object;
}

} // namespace

void describeRequest(const DriftRequest& request, QJsonObject& object)
{
    const DriftSettings& settings = request.settings;
    object[drift_key::kSchema] = QLatin1StringView{drift_key::kSchema.help};
    object[drift_key::kStrategy] = inLatin1(settings.strategy->name);
    object[drift_key::kParticipants] = settings.participants;
    object[drift_key::kTurningSpeed] = inDegrees(radians(settings.script.angularSpeed));
    object[drift_key::kMovingSpeed] = inMillimetres(metres(settings.script.speed));
    object[drift_key::kActions] = settings.script.actions;
    object[drift_key::kActionTime] = toSeconds(ActionScript::kActionTime);
    object[drift_key::kAxes] = inLatin1(nameOf(settings.script.axes));
    object[drift_key::kScenario] = QString::fromStdString(settings.scenario.name);
    object[drift_key::kExternalClocks] = QJsonValue::Null;
    if (const auto error = settings.scenario.externalClocks)
        object[drift_key::kExternalClocks] = 1e3 * toSeconds(*error);
    object[drift_key::kLocalLag] = 1e3 * toSeconds(settings.longestLag);
    object[drift_key::kAsaDelays] = int{settings.asa.delays};
    object[drift_key::kSeed] = qint64{settings.seed};
    object[drift_key::kSeeds] = request.seeds;
}

Result<QJsonObject> measuredDrift(const DriftRequest& request)
{
    auto object =
        request.isLive ? measureLive(request) : Result<QJsonObject>{measureVirtual(request)};
    if (object)
        describeRequest(request, *object);
    return object;
}

} // namespace carina::lab
