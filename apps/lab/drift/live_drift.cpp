#include "apps/lab/drift/live_drift.h"

#include "apps/lab/drift/live_program.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/files/json_fields.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace carina::lab
{
namespace
{

constexpr Duration kStartPatience = std::chrono::seconds{60};
constexpr Duration kEndPatience = std::chrono::seconds{20};
/// Until all have read when it begins.
constexpr Duration kNotice = std::chrono::milliseconds{300};
constexpr int kLook_ms = 20;

void tell(const QString& progress)
{
    const QByteArray line = progress.toUtf8() + '\n';
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
}

LocalTime liveNow() { return machineTime(monotonicNow()); }

QString variable(const char* name, double value)
{
    return QStringLiteral("%1=%2").arg(QLatin1StringView{name}).arg(value, 0, 'g', 12);
}

/// The session's clock of a program: off, but for the host's.
QStringList clockOf(std::size_t who, std::size_t participants)
{
    const double share =
        static_cast<double>(who - 1) / static_cast<double>(participants - 1); // from 0 to 1
    const double offset = who == 0 ? 0.0 : kLiveOffset_ms * (2.0 * share - 1.0);
    const double skew = who == 0 ? 0.0 : kLiveSkew_ppm * (who % 2 == 1 ? 1.0 : -1.0);
    return {variable("CARINA_CLOCK_OFFSET_MS", offset), variable("CARINA_CLOCK_PPM", skew)};
}

/// The disciplined clock of a program, with its error and the standard deviation of these.
QStringList externalClockOf(std::size_t who, const std::optional<Duration>& largest,
                            std::uint32_t seed)
{
    const double largest_ms = largest ? 1e3 * toSeconds(*largest) : 0.0;
    std::mt19937_64 random{(std::uint64_t{seed} << 8U) + who};
    const double share = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; // from -1 to 1
    return {variable("CARINA_EXTERNAL_CLOCK_OFFSET_MS", largest_ms * share),
            variable("CARINA_EXTERNAL_CLOCK_ERROR_MS", largest_ms / std::sqrt(3.0))};
}

class LiveExperiment
{
public:
    LiveExperiment(const LiveSettings& settings, LiveNetwork& network)
        : m_settings{settings},
          m_network{network},
          m_displays{displaysOf(settings.frames, settings.participants - 1, settings.seed)}
    {
        m_wake.start(kLook_ms);
    }

    Result<LiveFigures> run()
    {
        return startAll().and_then([&] { return act(); }).and_then([&] { return evaluate(); });
    }

private:
    /// Waits, with all programs listened to.
    template <class Condition> Result<void> waitUntil(LocalTime deadline, Condition condition)
    {
        for (;;) {
            for (const auto& program : m_programs)
                program->listen();
            if (condition())
                return {};
            const auto ended = std::ranges::find_if(
                m_programs, [&](const auto& program) { return program->hasEnded() && !m_mayEnd; });
            if (ended != m_programs.end())
                return fail(Errc::Cancelled, "drift: " + (*ended)->who() + " has ended early.");
            if (liveNow() > deadline)
                return fail(Errc::Cancelled, "drift: a program no longer answers.");
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
    }

    void start(std::size_t who, LiveOrders orders)
    {
        orders.name = who == 0 ? "the host" : "participant " + std::to_string(who);
        orders.isOpen = m_network.isHostOpen();
        orders.key = m_key;
        orders.strategy = m_settings.strategy;
        orders.longestLag = m_settings.longestLag;
        orders.asaDelays = m_settings.asa.delays;
        if (who >= 2)
            orders.frames = m_displays[who - 2];
        orders.script = m_settings.script;
        orders.seed = m_settings.seed;
        const QStringList words = m_network.inPlace(
            who, QStringList{QStringLiteral("env")} + clockOf(who, m_settings.participants)
                     + externalClockOf(who, m_settings.externalClocks, m_settings.seed)
                     + QStringList{m_settings.program, QStringLiteral("drift-node")});
        m_programs.push_back(std::make_unique<LiveProgram>(orders.name, words, orders));
    }

    Result<void> startAll()
    {
        const LocalTime deadline = liveNow() + kStartPatience;
        start(0, {.part = LiveOrders::Part::Host});
        const auto open = waitUntil(deadline, [&] { return m_programs[0]->port() != 0; });
        if (!open)
            return open;
        for (std::size_t who = 1; who <= m_settings.participants; ++who) {
            const auto [address, port] = m_network.placeOfHost(who, m_programs[0]->port());
            start(who, {.part = who == 1 ? LiveOrders::Part::Actor : LiveOrders::Part::Viewer,
                        .address = address,
                        .port = port});
        }
        tell(QStringLiteral("drift: %1 programs are joining.").arg(m_programs.size()));
        return waitUntil(deadline, [&] {
            return std::ranges::all_of(m_programs, [](const auto& one) { return one->isReady(); });
        });
    }

    Result<void> act()
    {
        const LocalTime begin = liveNow() + std::max(m_settings.warmUp, kNotice);
        const LocalTime end = begin + ActionScript::startOf(m_settings.script.actions);
        m_network.beginAt(begin);
        for (const auto& program : m_programs)
            program->begin(begin);
        tell(QStringLiteral(
                 "drift: all have joined; %1 s for the clocks to settle, then %2 actions of 1.2 s.")
                 .arg(toSeconds(m_settings.warmUp))
                 .arg(m_settings.script.actions));
        std::optional<std::uint64_t> before;
        return waitUntil(begin + kEndPatience, [&] { return liveNow() >= begin; })
            .and_then([&] {
                tell(QStringLiteral("drift: acting."));
                before = m_network.bytes();
                return waitUntil(end + kEndPatience, [&] { return liveNow() >= end; });
            })
            .and_then([&] {
                if (before)
                    m_bytesPerSecond =
                        static_cast<double>(*m_network.bytes() - *before) / toSeconds(end - begin);
                m_mayEnd = true;
                return waitUntil(end + kEndPatience, [&] {
                    return std::ranges::all_of(m_programs,
                                               [](const auto& one) { return one->hasEnded(); });
                });
            });
    }

    Result<LiveLog> logOf(LiveProgram& program)
    {
        return program.log().and_then([&](const QJsonObject& json) {
            const std::string folder = m_settings.logs.toStdString();
            std::string name = program.who() + ".json";
            std::ranges::replace(name, ' ', '-');
            const auto kept =
                folder.empty() ? Result<void>{} : writeJsonFile(folder + '/' + name, json);
            return kept.and_then([&] { return liveLogFrom(json); });
        });
    }

    Result<LiveFigures> evaluate()
    {
        LiveRun run{m_settings.script,
                    m_settings.seed,
                    {},
                    {},
                    [this](std::size_t who, Duration t) { return m_network.leastDelay(who, t); },
                    m_settings.strategy};
        for (const auto& program : m_programs) {
            auto log = logOf(*program);
            if (!log)
                return tl::unexpected(log.error());
            if (program == m_programs.front())
                run.host = *std::move(log);
            else
                run.participants.push_back(*std::move(log));
        }
        return evaluateLive(run).map([&](LiveFigures figures) {
            figures.drift.bytesPerSecond =
                m_bytesPerSecond / static_cast<double>(m_settings.participants);
            return figures;
        });
    }

    const LiveSettings& m_settings;
    LiveNetwork& m_network;
    std::vector<DisplayFrames> m_displays; // of the viewers
    AccessKey m_key = randomKey();
    std::vector<std::unique_ptr<LiveProgram>> m_programs; // the host first
    bool m_mayEnd = false;
    double m_bytesPerSecond = 0.0;
    QTimer m_wake;
};

} // namespace

LiveSettings liveSettingsOf(const DriftSettings& settings, const QString& program)
{
    return {.program = program,
            .participants = settings.participants,
            .strategy = settings.strategy->kind,
            .longestLag = settings.longestLag,
            .asa = settings.asa,
            .script = settings.script,
            .seed = settings.seed,
            .warmUp = settings.warmUp,
            .frames = settings.scenario.frames,
            .externalClocks = settings.scenario.externalClocks};
}

Result<LiveFigures> runLiveDrift(const LiveSettings& settings, LiveNetwork& network)
{
    return LiveExperiment{settings, network}.run();
}

} // namespace carina::lab
