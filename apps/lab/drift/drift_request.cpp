#include "apps/lab/drift/drift_request.h"

#include "apps/lab/drift/drift_page.h"
#include "engine/core/units.h"

#include <algorithm>
#include <array>

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
/// In a table: its runs are to take some twenty minutes.
constexpr int kUsualTableActions = 12;
constexpr double kUsualTableWarmUp_s = 15.0;
constexpr int kUsualTableDelays = 10; // of the ASA's history, which at one a second is then full
/// What a table is of.
constexpr std::array kTableScenarios{"lan", "metro", "wan", "paper"};
constexpr std::array kTableStrategies{"event", "asa-fixed", "asa-adaptive", "session-clock",
                                      "local-lag"};
constexpr std::array<std::uint16_t, 2> kTableParticipants{2, 6};

/// Axes as they are named in options and results.
struct NamedAxes {
    std::string_view name;
    ActionScript::Axes axes;
};
constexpr std::array kNamedAxes{NamedAxes{"cartesian", ActionScript::Axes::Cartesian},
                                NamedAxes{"random", ActionScript::Axes::Random}};

tl::unexpected<Error> driftRefusal(const QString& sentence)
{
    return fail(Errc::WrongOption, "drift: " + sentence.toStdString());
}

/// Whether the options go together, whatever their values are.
Result<void> checkOptions(const Words& words)
{
    const bool isLive = words.has(drift_option::kLive);
    for (const Option& option : drift_option::kOfLive)
        if (words.has(option) && !isLive)
            return driftRefusal(
                QStringLiteral("--%1 goes with --live.").arg(QLatin1StringView{option.name}));
    if (isTable(words) && (!isLive || words.has(drift_option::kLogs)))
        return driftRefusal(QStringLiteral("--table goes with --live and without --logs."));
    if (!isTable(words) && words.text(drift_option::kScenario).isEmpty())
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
        names += QString::fromLatin1(strategy.name.data(), qsizetype(strategy.name.size()));
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
    const int usual = isTable(words)                   ? kUsualTableActions
                      : words.has(drift_option::kLive) ? kUsualLiveActions
                                                       : kUsualActions;
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
    const auto delays = words.whole(drift_option::kAsaDelays, 2, 1000,
                                    isTable(words) ? kUsualTableDelays : AsaParameters{}.delays);
    for (const auto* number : {&participants, &seed, &seeds, &delays})
        if (!*number)
            return tl::unexpected(number->error());
    const auto warmUp_s = words.number(drift_option::kWarmUp, 0.0, 300.0,
                                       isTable(words) ? kUsualTableWarmUp_s : kUsualWarmUp_s);
    const auto lag_ms =
        words.number(drift_option::kLocalLag, 0.0, 1e3 * toSeconds(kLongestLocalLag),
                     1e3 * toSeconds(StrategyChoice{}.longestLag));
    for (const auto* number : {&warmUp_s, &lag_ms})
        if (!*number)
            return tl::unexpected(number->error());
    DriftRequest request;
    request.seeds = static_cast<int>(*seeds);
    request.isLive = words.has(drift_option::kLive);
    if (request.isLive)
        request.settings.warmUp = fromSeconds(*warmUp_s);
    request.settings.asa.delays = static_cast<std::uint16_t>(*delays);
    request.settings.longestLag = fromSeconds(1e-3 * *lag_ms);
    request.logs = words.text(drift_option::kLogs);
    request.netlab = words.text(drift_option::kNetlab);
    request.settings.strategy = *strategy;
    request.settings.script = *script;
    request.settings.participants = static_cast<std::uint16_t>(*participants);
    request.settings.seed = static_cast<std::uint32_t>(*seed);
    return request;
}

/// The clocks that a scenario has besides, where they are asked for.
Result<void> addExternalClocks(const Words& words, DriftScenario& scenario)
{
    if (!words.has(drift_option::kExternalClocks))
        return {};
    return words.number(drift_option::kExternalClocks, 1e-3, 1000.0).map([&](double error_ms) {
        scenario.externalClocks = fromSeconds(1e-3 * error_ms);
    });
}

Result<DriftRequest> inScenario(const Words& words, DriftRequest request, const std::string& name)
{
    auto scenario = findScenario(name);
    if (!scenario)
        return tl::unexpected(scenario.error());
    request.settings.scenario = *std::move(scenario);
    return addExternalClocks(words, request.settings.scenario).map([&] {
        return std::move(request);
    });
}

Result<DriftRequest> checkedRequest(const Words& words)
{
    if (const auto checked = checkOptions(words); !checked)
        return tl::unexpected(checked.error());
    auto request = requestWithoutScenario(words);
    if (request && request->isLive)
        if (const auto live = checkLive(*request); !live)
            return tl::unexpected(live.error());
    return request;
}

/// The value that an option has in a request, or else those of a table.
template <class Value, class Given>
std::vector<Value> givenOr(bool isGiven, const Given& given, std::vector<Value> ofTable)
{
    return isGiven ? std::vector<Value>{given} : std::move(ofTable);
}

} // namespace

bool isTable(const Words& words) { return words.has(drift_option::kTable); }

std::string_view nameOf(ActionScript::Axes axes)
{
    return std::ranges::find(kNamedAxes, axes, &NamedAxes::axes)->name;
}

Result<DriftRequest> driftRequest(const Words& words)
{
    const std::string scenario = words.text(drift_option::kScenario).toStdString();
    return checkedRequest(words).and_then(
        [&](DriftRequest request) { return inScenario(words, std::move(request), scenario); });
}

Result<std::vector<DriftRequest>> tableRequests(const Words& words)
{
    const auto common = checkedRequest(words);
    if (!common)
        return tl::unexpected(common.error());
    const DriftSettings& settings = common->settings;
    const auto scenarios = givenOr<std::string>(words.has(drift_option::kScenario),
                                                words.text(drift_option::kScenario).toStdString(),
                                                {kTableScenarios.begin(), kTableScenarios.end()});
    const auto strategies =
        givenOr<std::string_view>(words.has(drift_option::kStrategy), settings.strategy->name,
                                  {kTableStrategies.begin(), kTableStrategies.end()});
    const auto participants =
        givenOr<std::uint16_t>(words.has(drift_option::kParticipants), settings.participants,
                               {kTableParticipants.begin(), kTableParticipants.end()});
    std::vector<DriftRequest> requests;
    for (const std::string& scenario : scenarios) {
        auto request = inScenario(words, *common, scenario);
        if (!request)
            return tl::unexpected(request.error());
        for (const std::string_view strategy : strategies) {
            request->settings.strategy = findSyncStrategy(strategy);
            for (const std::uint16_t count : participants) {
                request->settings.participants = count;
                requests.push_back(*request);
            }
        }
    }
    return requests;
}

} // namespace carina::lab
