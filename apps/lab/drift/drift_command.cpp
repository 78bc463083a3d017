#include "apps/lab/drift/drift_command.h"

#include "apps/lab/drift/drift_report.h"
#include "apps/lab/drift/live_drift.h"
#include "engine/core/units.h"
#include "engine/io/files/whole_file.h"
#include "evaluation/drift/drift_experiment.h"
#include "evaluation/network/netlab_network.h"

#include <QCoreApplication>
#include <QMap>

namespace carina::lab
{
namespace
{

constexpr std::string_view kDriftHelp =
    R"(drift --scenario NAME|FILE [--strategy S] [--participants N] [--speed-deg-s W]
      [--speed-mm-s V] [--actions A] [--axes cartesian|random] [--seed K] [--seeds M]
      [--live [--netlab PROGRAM] [--warm-up-s T] [--logs DIR]]
    How far the views of shared objects are apart, in virtual time: one of N participants turns one
    object and moves another, an action of 1.2 s after the other, each about and along a new random
    axis; all others watch. A host in the middle passes everything on. The same words print the same
    bytes.
    --scenario NAME   lan, wifi, metro, wan, asymmetric, cellular, 5g, starlink, step, partition,
                      burst, bottleneck, duplication, reordering or clock (docs/synchronisation.md)
    --scenario FILE   a trace of lines "t_ms delay_ms", x for lost; it repeats
    --strategy S      session-clock (default), asa-adaptive, asa-fixed, dead-reckoning,
                      interpolation, event or none
    --participants N  2 to 64; 2
    --speed-deg-s W   above 0, at most 1000; 100
    --speed-mm-s V    0 to 10000; 100
    --actions A       1 to 10000; 50
    --axes            cartesian: one of +-x, +-y, +-z; random: any; cartesian
    --seed K          0 to 4294967295; 1
    --seeds M         so many runs, with the seeds K, K+1 and so on; 1 to 1000; 1
    schema            "carina.drift/1"
    strategy, participants, speed_deg_s, speed_mm_s, actions, axes, scenario, seed, seeds: as given
    action_s          duration of an action
    then, means over the runs, the angle being that of q_s q_c^-1, 2 atan2(|v|, |w|):
    at_event_mean_deg          between truth and view just before the next action
    time_average_mean_deg      over time
    p95_deg                    95th percentile over time, of each run
    position_mean_mm           of the moved object, over time
    limit_time_average_deg     what no strategy can be below with the delays of the run
    ratio_to_limit             time average to that; null where the limit is 0
    clock_error_ms             mean |session clock - the host's|; null where there is none
    bytes_per_s                payload that a participant sends and receives, mean
    probes_per_s               datagrams sent for the delay alone, of all together
    access_link                the same with the scenario's delay on each link to the host, so that
                               the way from actor to viewer has it twice; null with --live
    --live            in real time instead: a program for the host and for each participant, over
                      encrypted sockets and relays that are the scenario's network. The
                      participants' clocks are spread evenly over +-250 ms, at +-50 ppm. Only
                      session-clock, at most 16 participants, one seed; 15 actions if not told, but
                      step and partition come after 30 s, so that they take 28 or more
    --netlab PROGRAM  the network emulator to use in place of the relays; root only
    --warm-up-s T     for the clocks, before the first action; 0 to 300; 20
    --logs DIR        for what each program wrote down; the folder is made if need be
    with --live every figure is of what the programs' logs say they showed, on the machine's
    CLOCK_MONOTONIC (but the limit, of the delays that the scenario has then), and there are also
    live, network              true; relay or netlab
    bound_time_average_deg     1.5 limit + W (0.2 ms + half the paths' asymmetry)
    is_within_bound            time average to that
    is_end_state_same          both objects ended to the bit alike in all programs
    handshake_mean_ms, handshake_max_ms   until a participant was in and had the session's clock
    sample_gap_p95_ms          between a program's samples, which are to be 5.003 ms apart
    load_average               of the machine in the minute in which the run ended
    probes_per_s is null, and bytes_per_s is of the encrypted datagrams, null with
    --netlab
)";

using Options = QMap<QString, QString>;

const QString kLive = QStringLiteral("--live");
const QStringList kOfLive{QStringLiteral("--warm-up-s"), QStringLiteral("--logs"),
                          QStringLiteral("--netlab")};
constexpr int kMostLive = 16;

tl::unexpected<Error> badOption(const QString& sentence)
{
    return fail(Errc::OutOfRange, "drift: " + sentence.toStdString());
}

Result<Options> optionsOf(QStringList arguments)
{
    Options options{{QStringLiteral("--strategy"), QStringLiteral("session-clock")},
                    {QStringLiteral("--participants"), QStringLiteral("2")},
                    {QStringLiteral("--speed-deg-s"), QStringLiteral("100")},
                    {QStringLiteral("--speed-mm-s"), QStringLiteral("100")},
                    {QStringLiteral("--actions"), QString{}},
                    {QStringLiteral("--axes"), QStringLiteral("cartesian")},
                    {QStringLiteral("--scenario"), QString{}},
                    {QStringLiteral("--seed"), QStringLiteral("1")},
                    {QStringLiteral("--seeds"), QStringLiteral("1")},
                    {QStringLiteral("--warm-up-s"), QStringLiteral("20")},
                    {QStringLiteral("--logs"), QString{}},
                    {QStringLiteral("--netlab"), QString{}}};
    const bool isLive = arguments.removeAll(kLive) > 0;
    QStringList given;
    for (qsizetype i = 0; i < arguments.size(); i += 2) {
        if (!options.contains(arguments[i]))
            return badOption(QStringLiteral("%1 is no option.").arg(arguments[i]));
        if (i + 1 == arguments.size())
            return badOption(QStringLiteral("%1 needs a value.").arg(arguments[i]));
        if (given.contains(arguments[i]))
            return badOption(QStringLiteral("%1 is given twice.").arg(arguments[i]));
        if (!isLive && kOfLive.contains(arguments[i]))
            return badOption(QStringLiteral("%1 goes with --live.").arg(arguments[i]));
        given.append(arguments[i]);
        options[arguments[i]] = arguments[i + 1];
    }
    if (options[QStringLiteral("--scenario")].isEmpty())
        return badOption(QStringLiteral("--scenario NAME or FILE is missing."));
    if (isLive)
        options.insert(kLive, {});
    if (options[QStringLiteral("--actions")].isEmpty())
        options[QStringLiteral("--actions")] = QString::number(isLive ? 15 : 50);
    return options;
}

/// Reads the values of options, and keeps the first that cannot be read.
class OptionReader
{
public:
    explicit OptionReader(const Options& options) : m_options{options} {}

    double number(const char* name, double lowest, double highest)
    {
        bool isNumber = false;
        const QString text = m_options[QLatin1StringView{name}];
        const double value = text.toDouble(&isNumber);
        if (!isNumber || !(value >= lowest && value <= highest))
            refuse(name, QStringLiteral("a number from %1 to %2").arg(lowest).arg(highest));
        return value;
    }
    std::int64_t whole(const char* name, std::int64_t lowest, std::int64_t highest)
    {
        bool isNumber = false;
        const qlonglong value = m_options[QLatin1StringView{name}].toLongLong(&isNumber);
        if (!isNumber || value < lowest || value > highest)
            refuse(name, QStringLiteral("a whole number from %1 to %2").arg(lowest).arg(highest));
        return value;
    }
    std::string text(const char* name) const
    {
        return m_options[QLatin1StringView{name}].toStdString();
    }
    void refuse(const char* name, const QString& wanted)
    {
        if (m_refusal.isEmpty())
            m_refusal = QStringLiteral("%1 needs %2.").arg(QLatin1StringView{name}, wanted);
    }
    [[nodiscard]] const QString& refusal() const { return m_refusal; }

private:
    const Options& m_options;
    QString m_refusal;
};

struct DriftRequest {
    DriftSettings settings;
    int seeds = 1;
    bool isLive = false;
    double warmUp_s = 0.0;
    QString logs;
    QString netlab;
};

Result<void> checkLive(const DriftRequest& request)
{
    if (request.settings.strategy->name != "session-clock")
        return badOption(QStringLiteral("--live measures the programs, which run session-clock; "
                                        "the other strategies run in virtual time only."));
    if (request.settings.participants > kMostLive || request.seeds != 1)
        return badOption(
            QStringLiteral("--live takes 2 to %1 participants and one seed.").arg(kMostLive));
    return {};
}

Result<DriftRequest> requestOf(const Options& options)
{
    OptionReader reader{options};
    DriftRequest request;
    DriftSettings& settings = request.settings;
    settings.strategy = findSyncStrategy(reader.text("--strategy"));
    if (settings.strategy == nullptr)
        reader.refuse("--strategy", QStringLiteral("one of those that carina-lab help names"));
    settings.participants = static_cast<std::uint16_t>(reader.whole("--participants", 2, 64));
    settings.script.angularSpeed = degrees(reader.number("--speed-deg-s", 1e-3, 1000.0)).si;
    settings.script.speed = millimetres(reader.number("--speed-mm-s", 0.0, 10000.0)).si;
    settings.script.actions = static_cast<int>(reader.whole("--actions", 1, 10000));
    settings.seed = static_cast<std::uint32_t>(reader.whole("--seed", 0, 4294967295));
    request.seeds = static_cast<int>(reader.whole("--seeds", 1, 1000));
    const std::string axes = reader.text("--axes");
    if (axes == "random")
        settings.script.axes = ActionScript::Axes::Random;
    else if (axes != "cartesian")
        reader.refuse("--axes", QStringLiteral("cartesian or random"));
    request.isLive = options.contains(kLive);
    request.warmUp_s = reader.number("--warm-up-s", 0.0, 300.0);
    request.logs = options[QStringLiteral("--logs")];
    request.netlab = options[QStringLiteral("--netlab")];
    if (!reader.refusal().isEmpty())
        return badOption(reader.refusal());
    if (request.isLive)
        if (const auto live = checkLive(request); !live)
            return tl::unexpected(live.error());
    auto scenario = findScenario(reader.text("--scenario"));
    if (!scenario)
        return tl::unexpected(scenario.error());
    settings.scenario = *std::move(scenario);
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
            return badOption(
                QStringLiteral("--logs %1.").arg(QString::fromStdString(opened.error().detail)));
    const auto network = networkOf(request);
    if (!network)
        return tl::unexpected(network.error());
    return runLiveDrift({.program = QCoreApplication::applicationFilePath(),
                         .participants = settings.participants,
                         .script = settings.script,
                         .seed = settings.seed,
                         .warmUp = fromSeconds(request.warmUp_s),
                         .logs = request.logs},
                        **network)
        .map([&](const LiveFigures& figures) {
            QJsonObject object = reportOf(figures, settings.script, settings.scenario);
            object[QStringLiteral("network")] = (*network)->name();
            return object;
        });
}

QJsonObject measureVirtual(DriftRequest request)
{
    QJsonObject object = reportOf(runDrift(request.settings, request.seeds));
    request.settings.legs = VirtualStar::Legs::FullPath;
    object[QStringLiteral("access_link")] = reportOf(runDrift(request.settings, request.seeds));
    return object;
}

Result<QJsonObject> runDriftCommand(const QStringList& arguments)
{
    const Result<Options> options = optionsOf(arguments);
    if (!options)
        return tl::unexpected(options.error());
    const Result<DriftRequest> request = requestOf(*options);
    if (!request)
        return tl::unexpected(request.error());
    const auto measured =
        request->isLive ? measureLive(*request) : Result<QJsonObject>{measureVirtual(*request)};
    if (!measured)
        return tl::unexpected(measured.error());

    const DriftSettings& settings = request->settings;
    QJsonObject object = *measured;
    object[QStringLiteral("schema")] = QStringLiteral("carina.drift/1");
    object[QStringLiteral("strategy")] = QString::fromLatin1(
        settings.strategy->name.data(), qsizetype(settings.strategy->name.size()));
    object[QStringLiteral("participants")] = settings.participants;
    object[QStringLiteral("speed_deg_s")] = inDegrees(radians(settings.script.angularSpeed));
    object[QStringLiteral("speed_mm_s")] = inMillimetres(metres(settings.script.speed));
    object[QStringLiteral("actions")] = settings.script.actions;
    object[QStringLiteral("action_s")] = toSeconds(ActionScript::kActionTime);
    object[QStringLiteral("axes")] = options->value(QStringLiteral("--axes"));
    object[QStringLiteral("scenario")] = QString::fromStdString(settings.scenario.name);
    object[QStringLiteral("seed")] = qint64{settings.seed};
    object[QStringLiteral("seeds")] = request->seeds;
    return object;
}

} // namespace

Command driftCommand() { return {"drift", kDriftHelp, runDriftCommand}; }

} // namespace carina::lab
