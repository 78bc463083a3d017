#include "evaluation/network/netlab_network.h"

#include "engine/core/monotonic_clock.h"
#include "engine/io/files/whole_file.h"
#include "evaluation/network/netlab_process.h"
#include "evaluation/network/virtual_star.h"

#include <QTimer>

#include <cmath>

namespace carina
{
namespace
{

constexpr int kDraws = 200;

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
        : m_lab{std::move(program)},
          m_participants{participants},
          m_scenario{std::move(scenario)},
          m_seed{seed}
    {
    }
    Result<void> start()
    {
        const Legs legs = legsOf(1, m_scenario);
        if (legs.toHost.trace)
            if (const auto kept = writePrivateFile(traceFile(), traceText(*legs.toHost.trace));
                !kept)
                return kept;
        QStringList lines{QStringLiteral("hosts host p1 ")
                              + viewers(m_participants).replace(QLatin1Char{','}, QLatin1Char{' '}),
                          QStringLiteral("seed %1").arg(m_seed)};
        lines << links(false);
        return m_lab.start(lines);
    }

    QString name() const override { return QStringLiteral("netlab"); }
    bool isHostOpen() const override { return true; }

    QStringList inPlace(std::size_t who, const QStringList& program) const override
    {
        const QString place = who == 0 ? QStringLiteral("host") : QStringLiteral("p%1").arg(who);
        return m_lab.inPlace(place, program);
    }

    Place placeOfHost(std::size_t, std::uint16_t hostPort) override
    {
        return {NetlabProcess::kFirstAddress, hostPort};
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
    std::filesystem::path traceFile() const { return m_lab.folder() / "trace"; }
    QStringList links(bool hasStepped) const
    {
        return netlabLinks(m_scenario, m_participants, hasStepped, traceFile());
    }
    /// Tells the running lab.
    void later(Duration after, const QStringList& statements)
    {
        const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(after);
        QTimer::singleShot(ms, Qt::PreciseTimer, &m_context, [this, statements] {
            for (const QString& statement : statements)
                m_lab.tell(statement);
        });
    }

    NetlabProcess m_lab;
    std::size_t m_participants;
    DriftScenario m_scenario;
    std::uint32_t m_seed;
    QObject m_context; // what is due later is not due after this
};

} // namespace

QStringList netlabLinks(const DriftScenario& scenario, std::size_t participants, bool hasStepped,
                        const std::filesystem::path& trace)
{
    QStringList statements;
    const auto add = [&](const QString& who, const LiveNetwork::Legs& legs) {
        statements
            << QStringLiteral("link %1>host %2").arg(who, netlabWay(legs.toHost, hasStepped, trace))
            << QStringLiteral("link host>%1 %2")
                   .arg(who, netlabWay(legs.fromHost, hasStepped, trace));
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
