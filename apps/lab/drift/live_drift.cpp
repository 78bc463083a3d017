#include "apps/lab/drift/live_drift.h"

#include "apps/lab/drift/live_program.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/files/json_fields.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <cstdio>

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

/// The words that start a program with its clock off: the host's is not.
QStringList withClock(std::size_t who, std::size_t participants, const QStringList& program)
{
    const double share =
        static_cast<double>(who - 1) / static_cast<double>(participants - 1); // from 0 to 1
    const double offset = who == 0 ? 0.0 : kLiveOffset_ms * (2.0 * share - 1.0);
    const double skew = who == 0 ? 0.0 : kLiveSkew_ppm * (who % 2 == 1 ? 1.0 : -1.0);
    return QStringList{QStringLiteral("env"),
                       QStringLiteral("CARINA_CLOCK_OFFSET_MS=%1").arg(offset),
                       QStringLiteral("CARINA_CLOCK_PPM=%1").arg(skew)}
           + program;
}

class LiveExperiment
{
public:
    LiveExperiment(const LiveSettings& settings, LiveNetwork& network)
        : m_settings{settings}, m_network{network}
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
        orders.script = m_settings.script;
        orders.seed = m_settings.seed;
        const QStringList words =
            m_network.inPlace(who, withClock(who, m_settings.participants,
                                             {m_settings.program, QStringLiteral("drift-node")}));
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
        LiveRun run{
            m_settings.script, m_settings.seed, {}, {}, [this](std::size_t who, Duration t) {
                return m_network.leastDelay(who, t);
            }};
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
    AccessKey m_key = randomKey();
    std::vector<std::unique_ptr<LiveProgram>> m_programs; // the host first
    bool m_mayEnd = false;
    double m_bytesPerSecond = 0.0;
    QTimer m_wake;
};

} // namespace

Result<LiveFigures> runLiveDrift(const LiveSettings& settings, LiveNetwork& network)
{
    return LiveExperiment{settings, network}.run();
}

} // namespace carina::lab
