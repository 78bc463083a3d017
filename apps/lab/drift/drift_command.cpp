#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/drift/drift_page.h"
#include "apps/lab/drift/drift_report.h"
#include "apps/lab/drift/live_drift.h"
#include "engine/core/units.h"
#include "engine/io/files/whole_file.h"
#include "evaluation/drift/drift_experiment.h"
#include "evaluation/network/netlab_network.h"

#include <QCoreApplication>

namespace carina::lab
{
namespace
{

constexpr int kMostLive = 16;
constexpr int kUsualActions = 50;
constexpr int kUsualLiveActions = 15;
constexpr double kUsualTurning_degPerSecond = 100.0;
constexpr double kUsualMoving_mmPerSecond = 100.0;
constexpr double kUsualWarmUp_s = 20.0;
/// Runs in virtual time with which a live one is compared.
constexpr int kVirtualSeeds = 5;

/// Axes as they are named in options and results.
struct NamedAxes {
    std::string_view name;
    ActionScript::Axes axes;
};
constexpr std::array kNamedAxes{NamedAxes{"cartesian", ActionScript::Axes::Cartesian},
                                NamedAxes{"random", ActionScript::Axes::Random}};

struct DriftRequest {
    DriftSettings settings;
    int seeds = 1;
    bool isLive = false;
    double warmUp_s = 0.0;
    QString logs;
    QString netlab;
};

QString inLatin1(std::string_view name)
{
    return QString::fromLatin1(name.data(), qsizetype(name.size()));
}

tl::unexpected<Error> driftRefusal(const QString& sentence)
{
    return fail(Errc::WrongOption, "drift: " + sentence.toStdString());
}

/// Whether the options go together, whatever their values are.
Result<void> checkOptions(const Words& words)
{
    for (const Option& option : drift_option::kOfLive)
        if (words.has(option) && !words.has(drift_option::kLive))
            return driftRefusal(
                QStringLiteral("--%1 goes with --live.").arg(inLatin1(option.name)));
    if (words.text(drift_option::kScenario).isEmpty())
        return driftRefusal(QStringLiteral("--scenario NAME or FILE is missing."));
    return {};
}

Result<const SyncStrategy*> strategyOption(const Words& words)
{
    if (!words.has(drift_option::kStrategy))
        return &syncStrategies().front();
    const std::string name = words.text(drift_option::kStrategy).toStdString();
    if (const SyncStrategy* strategy = findSyncStrategy(name))
        return strategy;
    QStringList names;
    for (const SyncStrategy& strategy : syncStrategies())
        names += inLatin1(strategy.name);
    return words.unknownWord(drift_option::kStrategy, names);
}

/// What the participants do.
Result<ActionScript::Settings> scriptOption(const Words& words)
{
    const auto turning =
        words.number(drift_option::kTurningSpeed, 1e-3, 1000.0, kUsualTurning_degPerSecond);
    if (!turning)
        return tl::unexpected(turning.error());
    const auto moving =
        words.number(drift_option::kMovingSpeed, 0.0, 10000.0, kUsualMoving_mmPerSecond);
    if (!moving)
        return tl::unexpected(moving.error());
    const int usual = words.has(drift_option::kLive) ? kUsualLiveActions : kUsualActions;
    const auto actions = words.whole(drift_option::kActions, 1, 10000, usual);
    if (!actions)
        return tl::unexpected(actions.error());
    const auto axes = words.word(drift_option::kAxes, kNamedAxes, &NamedAxes::axes);
    if (!axes)
        return tl::unexpected(axes.error());
    ActionScript::Settings script;
    script.angularSpeed = degrees(*turning).si;
    script.speed = millimetres(*moving).si;
    script.actions = static_cast<int>(*actions);
    script.axes = *axes;
    return script;
}

Result<void> checkLive(const DriftRequest& request)
{
    if (request.settings.participants > kMostLive || request.seeds != 1)
        return driftRefusal(
            QStringLiteral("--live takes 2 to %1 participants and one seed.").arg(kMostLive));
    return {};
}

/// Everything but the network.
Result<DriftRequest> requestWithoutScenario(const Words& words)
{
    const auto strategy = strategyOption(words);
    if (!strategy)
        return tl::unexpected(strategy.error());
    const auto script = scriptOption(words);
    if (!script)
        return tl::unexpected(script.error());
    const auto participants = words.whole(drift_option::kParticipants, 2, 64, 2);
    const auto seed = words.whole(drift_option::kSeed, 0, 4294967295, 1);
    const auto seeds = words.whole(drift_option::kSeeds, 1, 1000, 1);
    for (const auto* number : {&participants, &seed, &seeds})
        if (!*number)
            return tl::unexpected(number->error());
    const auto warmUp_s = words.number(drift_option::kWarmUp, 0.0, 300.0, kUsualWarmUp_s);
    if (!warmUp_s)
        return tl::unexpected(warmUp_s.error());
    DriftRequest request;
    request.seeds = static_cast<int>(*seeds);
    request.isLive = words.has(drift_option::kLive);
    request.warmUp_s = *warmUp_s;
    request.logs = words.text(drift_option::kLogs);
    request.netlab = words.text(drift_option::kNetlab);
    request.settings.strategy = *strategy;
    request.settings.script = *script;
    request.settings.participants = static_cast<std::uint16_t>(*participants);
    request.settings.seed = static_cast<std::uint32_t>(*seed);
    return request;
}

Result<DriftRequest> requestOf(const Words& words)
{
    if (const auto checked = checkOptions(words); !checked)
        return tl::unexpected(checked.error());
    auto request = requestWithoutScenario(words);
    if (!request)
        return request;
    if (request->isLive)
        if (const auto live = checkLive(*request); !live)
            return tl::unexpected(live.error());
    auto scenario = findScenario(words.text(drift_option::kScenario).toStdString());
    if (!scenario)
        return tl::unexpected(scenario.error());
    request->settings.scenario = *std::move(scenario);
    if (words.has(drift_option::kExternalClocks)) {
        const auto error_ms = words.number(drift_option::kExternalClocks, 1e-3, 1000.0, 1.0);
        if (!error_ms)
            return tl::unexpected(error_ms.error());
        if (request->isLive)
            return driftRefusal(QStringLiteral("--external-clocks-ms is of virtual time."));
        request->settings.scenario.externalClocks = fromSeconds(1e-3 * *error_ms);
    }
    return request;
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
            return driftRefusal(
                QStringLiteral("--logs %1.").arg(QString::fromStdString(opened.error().detail)));
    const auto network = networkOf(request);
    if (!network)
        return tl::unexpected(network.error());
    return runLiveDrift({.program = QCoreApplication::applicationFilePath(),
                         .participants = settings.participants,
                         .strategy = settings.strategy->kind,
                         .script = settings.script,
                         .seed = settings.seed,
                         .warmUp = fromSeconds(request.warmUp_s),
                         .logs = request.logs},
                        **network)
        .map([&](const LiveFigures& figures) {
            QJsonObject object =
                reportOf(figures, settings, runDrift(settings, kVirtualSeeds).timeAverage);
            object[drift_key::kNetwork] = (*network)->name();
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

/// Adds what was asked for.
void describeRequest(const DriftRequest& request, QJsonObject& object)
{
    const DriftSettings& settings = request.settings;
    const auto* axes = std::ranges::find(kNamedAxes, settings.script.axes, &NamedAxes::axes);
    object[drift_key::kSchema] = QLatin1StringView{drift_key::kSchema.help};
    object[drift_key::kStrategy] = inLatin1(settings.strategy->name);
    object[drift_key::kParticipants] = settings.participants;
    object[drift_key::kTurningSpeed] = inDegrees(radians(settings.script.angularSpeed));
    object[drift_key::kMovingSpeed] = inMillimetres(metres(settings.script.speed));
    object[drift_key::kActions] = settings.script.actions;
    object[drift_key::kActionTime] = toSeconds(ActionScript::kActionTime);
    object[drift_key::kAxes] = inLatin1(axes->name);
    object[drift_key::kScenario] = QString::fromStdString(settings.scenario.name);
    object[drift_key::kExternalClocks] = QJsonValue::Null;
    if (const auto error = settings.scenario.externalClocks)
        object[drift_key::kExternalClocks] = 1e3 * toSeconds(*error);
    object[drift_key::kSeed] = qint64{settings.seed};
    object[drift_key::kSeeds] = request.seeds;
}

Result<QJsonObject> drift(const Words& words)
{
    const Result<DriftRequest> request = requestOf(words);
    if (!request)
        return tl::unexpected(request.error());
    auto object =
        request->isLive ? measureLive(*request) : Result<QJsonObject>{measureVirtual(*request)};
    if (object)
        describeRequest(*request, *object);
    return object;
}

Use driftInVirtualTime()
{
    return {.lines = {"--scenario NAME|FILE [OPTION...]"},
            .text = "Measures the drift between the participants' views of shared objects, in "
                    "virtual time. One of N participants turns one object and moves another, in "
                    "successive actions of 1.2 s, each about and along a new random axis; all "
                    "others watch. A host in the middle forwards everything. The figures are means "
                    "over the runs; an angle between two orientations is that of q_s q_c^-1, 2 "
                    "atan2(|v|, |w|). The same arguments print the same bytes.",
            .options = {drift_option::kOfAll.begin(), drift_option::kOfAll.end()},
            .schema = drift_key::kSchema,
            .keys = {drift_key::kStrategy,    drift_key::kParticipants, drift_key::kTurningSpeed,
                     drift_key::kMovingSpeed, drift_key::kActions,      drift_key::kActionTime,
                     drift_key::kAxes,        drift_key::kScenario,     drift_key::kExternalClocks,
                     drift_key::kSeed,        drift_key::kSeeds,        drift_key::kAtEvent,
                     drift_key::kRawAtLast,   drift_key::kRawGreatest,  drift_key::kTimeAverage,
                     drift_key::kPercentile,  drift_key::kPosition,     drift_key::kLimit,
                     drift_key::kRatio,       drift_key::kResponse,     drift_key::kClockError,
                     drift_key::kBytes,       drift_key::kProbes,       drift_key::kAccessLink}};
}

Use driftInRealTime()
{
    return {
        .lines = {"--live --scenario NAME|FILE [OPTION...] [--netlab PROGRAM] [--warm-up-s T] "
                  "[--logs DIR]"},
        .text = "The same in real time: one program for the host and one for each participant, "
                "over encrypted sockets and relays that imitate the network of the scenario. The "
                "clocks of the participants are spread evenly over +-250 ms and run fast or slow "
                "by 50 ppm. Takes the options above, at most 16 participants and one seed "
                "only. The scenarios step and partition change after 30 s, so that "
                "they need 28 actions or more. Every figure is from what the logs of the programs "
                "say that they showed, on the machine's CLOCK_MONOTONIC; but the limit is that of "
                "the delays which the scenario has then. Prints the keys above, and besides or "
                "otherwise:",
        .options = {drift_option::kOfLive.begin(), drift_option::kOfLive.end()},
        .schema = drift_key::kSchema,
        .keys = {drift_key::kLive, drift_key::kNetwork, drift_key::kBound, drift_key::kVirtual,
                 drift_key::kIsWithinBound, drift_key::kIsEndStateSame, drift_key::kHandshakeMean,
                 drift_key::kHandshakeMax, drift_key::kSampleGap, drift_key::kLoad,
                 drift_key::kLiveBytes, drift_key::kLiveProbes, drift_key::kLiveAccessLink}};
}

} // namespace

Command driftCommand()
{
    return {.name = "drift",
            .theme = "drift and network",
            .summary = "measures the drift between the views of shared objects",
            .uses = {driftInVirtualTime(), driftInRealTime()},
            .experiment = drift};
}

} // namespace carina::lab
