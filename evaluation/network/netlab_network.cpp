#include "evaluation/network/netlab_network.h"

#include "engine/core/monotonic_clock.h"
#include "engine/io/files/whole_file.h"
#include "evaluation/network/virtual_star.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>

#include <cmath>

namespace carina
{
namespace
{

constexpr int kStart_ms = 15000;
constexpr int kEnd_ms = 5000;
constexpr int kDraws = 200;
/// netlab's first host.
constexpr const char* kHostAddress = "10.77.0.1";

QString nanoseconds(Duration time) { return QString::number(time.count()) + QStringLiteral("ns"); }

QString jitterOf(const PathProfile& leg)
{
    switch (leg.jitter) {
    case PathProfile::Jitter::Exponential:
        return QStringLiteral("exp:") + nanoseconds(leg.jitterScale);
    case PathProfile::Jitter::Pareto:
        return QStringLiteral("pareto:") + nanoseconds(leg.jitterScale);
    case PathProfile::Jitter::Uniform:
        return QStringLiteral("uniform:") + nanoseconds(leg.jitterScale);
    case PathProfile::Jitter::None:
        break;
    }
    return QStringLiteral("none");
}

QString wordsOf(const PathProfile& leg, bool hasStepped, const std::filesystem::path& trace)
{
    const Duration delay = leg.delay + (hasStepped ? leg.stepBy : Duration{});
    QStringList words{
        QStringLiteral("order=free"),
        QStringLiteral("delay=") + nanoseconds(delay),
        QStringLiteral("jitter=") + jitterOf(leg),
        QStringLiteral("loss=%1").arg(leg.loss),
        QStringLiteral("dup=%1").arg(leg.duplication),
        QStringLiteral("reorder=%1:%2").arg(leg.reordering).arg(nanoseconds(leg.heldUp))};
    if (leg.burst)
        words << QStringLiteral("ge=%1:%2").arg(leg.burst->enter).arg(leg.burst->leave);
    if (leg.bitsPerSecond > 0.0)
        words << QStringLiteral("rate=%1").arg(leg.bitsPerSecond)
              << QStringLiteral("queue=%1").arg(leg.queueBytes);
    if (leg.trace)
        words << QStringLiteral("trace=") + QString::fromStdString(trace.string());
    return words.join(QLatin1Char{' '});
}

/// p2,p3 and so on.
QString viewers(std::size_t participants)
{
    QStringList names;
    for (std::size_t i = 2; i <= participants; ++i)
        names << QStringLiteral("p%1").arg(i);
    return names.join(QLatin1Char{','});
}

std::string traceText(const std::vector<TracePoint>& points)
{
    QString text;
    for (const TracePoint& point : points)
        text += QStringLiteral("%1 %2\n")
                    .arg(1e3 * toSeconds(point.at))
                    .arg(point.delay ? QString::number(1e3 * toSeconds(*point.delay))
                                     : QStringLiteral("x"));
    return text.toStdString();
}

class NetlabNetwork : public LiveNetwork
{
public:
    NetlabNetwork(QString program, std::size_t participants, DriftScenario scenario,
                  std::uint32_t seed)
        : m_program{std::move(program)},
          m_participants{participants},
          m_scenario{std::move(scenario)},
          m_seed{seed}
    {
    }
    ~NetlabNetwork() override
    {
        // The lab lasts as long as its command, and that as long as its input.
        m_lab.closeWriteChannel();
        if (m_lab.state() != QProcess::NotRunning && !m_lab.waitForFinished(kEnd_ms))
            m_lab.terminate();
        m_lab.waitForFinished(kEnd_ms);
    }

    Result<void> start()
    {
        const std::filesystem::path folder{m_folder.path().toStdString()};
        const Legs legs = legsOf(1, m_scenario);
        if (legs.toHost.trace)
            if (const auto kept = writePrivateFile(traceFile(), traceText(*legs.toHost.trace));
                !kept)
                return kept;
        QStringList lines{QStringLiteral("hosts host p1 ")
                              + viewers(m_participants).replace(QLatin1Char{','}, QLatin1Char{' '}),
                          QStringLiteral("seed %1").arg(m_seed)};
        lines << links(false);
        const std::filesystem::path file = folder / "lab.conf";
        if (const auto kept =
                writePrivateFile(file, lines.join(QLatin1Char{'\n'}).toStdString() + '\n');
            !kept)
            return kept;
        m_lab.setProcessChannelMode(QProcess::MergedChannels);
        m_lab.start(m_program,
                    {QStringLiteral("run"), QString::fromStdString(file.string()),
                     QStringLiteral("-n"), m_name, QStringLiteral("--rt"), QStringLiteral("--spin"),
                     QStringLiteral("60us"), QStringLiteral("--"), QStringLiteral("cat")});
        QByteArray said;
        while (m_lab.waitForReadyRead(kStart_ms)) {
            said += m_lab.readAll();
            if (said.contains(" up: "))
                return {};
        }
        return fail(Errc::NotPermitted,
                    "drift: netlab has not started. " + said.trimmed().toStdString());
    }

    QString name() const override { return QStringLiteral("netlab"); }
    bool isHostOpen() const override { return true; }

    QStringList inPlace(std::size_t who, const QStringList& program) const override
    {
        const QString place = who == 0 ? QStringLiteral("host") : QStringLiteral("p%1").arg(who);
        return QStringList{m_program, QStringLiteral("exec"), QStringLiteral("-n"), m_name, place}
               + program;
    }

    Place placeOfHost(std::size_t, std::uint16_t hostPort) override
    {
        return {kHostAddress, hostPort};
    }

    void beginAt(LocalTime machine) override
    {
        const PathProfile path = legsOf(1, m_scenario).toHost;
        const Duration ahead = machine - machineTime(monotonicNow());
        if (path.stepAt != Duration::max())
            later(ahead + path.stepAt, links(true));
        if (path.cutFrom == Duration::max())
            return;
        later(ahead + path.cutFrom,
              {QStringLiteral("partition host|p1,") + viewers(m_participants)});
        later(ahead + path.cutFrom + path.cutFor, {QStringLiteral("heal")});
    }

    std::optional<std::uint64_t> bytes() const override { return std::nullopt; }

    Duration leastDelay(std::size_t participant, Duration t) override
    {
        // What netlab draws is not known. The limit is in the square of the delay, so the root of
        // the mean square over draws from the same links has its expectation.
        double meanSquare = 0.0;
        for (std::uint64_t draw = 0; draw < kDraws; ++draw) {
            VirtualLink toHost{legsOf(1, m_scenario).toHost, m_seed + 2 * draw};
            VirtualLink fromHost{legsOf(participant, m_scenario).fromHost, m_seed + 2 * draw + 1};
            const Duration atHost = VirtualStar::throughLeg(toHost, t);
            const Duration whole = atHost + VirtualStar::throughLeg(fromHost, t + atHost);
            meanSquare += toSeconds(whole) * toSeconds(whole) / kDraws;
        }
        return fromSeconds(std::sqrt(meanSquare));
    }

private:
    std::filesystem::path traceFile() const
    {
        return std::filesystem::path{m_folder.path().toStdString()} / "trace";
    }
    QStringList links(bool hasStepped) const
    {
        return netlabLinks(m_scenario, m_participants, hasStepped, traceFile());
    }
    /// Tells the running lab.
    void later(Duration after, const QStringList& statements)
    {
        const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(after);
        QTimer::singleShot(ms, Qt::PreciseTimer, &m_lab, [this, statements] {
            for (const QString& statement : statements) {
                QProcess control;
                control.setProgram(m_program);
                control.setArguments(
                    QStringList{QStringLiteral("ctl"), QStringLiteral("-n"), m_name}
                    + statement.split(QLatin1Char{' '}));
                control.setStandardOutputFile(QProcess::nullDevice()); // ours is for the figures
                control.startDetached();
            }
        });
    }

    QString m_program;
    std::size_t m_participants;
    DriftScenario m_scenario;
    std::uint32_t m_seed;
    QString m_name = QStringLiteral("carina%1").arg(QCoreApplication::applicationPid());
    QTemporaryDir m_folder;
    QProcess m_lab;
};

} // namespace

QStringList netlabLinks(const DriftScenario& scenario, std::size_t participants, bool hasStepped,
                        const std::filesystem::path& trace)
{
    QStringList statements;
    const auto add = [&](const QString& who, const LiveNetwork::Legs& legs) {
        statements
            << QStringLiteral("link %1>host %2").arg(who, wordsOf(legs.toHost, hasStepped, trace))
            << QStringLiteral("link host>%1 %2")
                   .arg(who, wordsOf(legs.fromHost, hasStepped, trace));
    };
    add(QStringLiteral("p1"), LiveNetwork::legsOf(1, scenario));
    add(viewers(participants), LiveNetwork::legsOf(2, scenario));
    return statements;
}

Result<std::unique_ptr<LiveNetwork>> netlabNetwork(const QString& program, std::size_t participants,
                                                   const DriftScenario& scenario,
                                                   std::uint32_t seed)
{
    auto network = std::make_unique<NetlabNetwork>(program, participants, scenario, seed);
    if (const auto started = network->start(); !started)
        return tl::unexpected(started.error());
    return network;
}

} // namespace carina
