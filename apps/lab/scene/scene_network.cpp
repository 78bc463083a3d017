#include "apps/lab/scene/scene_network.h"

#include "evaluation/network/lossy_relay.h"
#include "evaluation/network/netlab_process.h"

namespace carina::lab
{
namespace
{

class RelayedSceneNetwork final : public SceneNetwork
{
public:
    explicit RelayedSceneNetwork(const SceneNetworkSettings& settings) : m_settings{settings} {}

    QString name() const override { return QStringLiteral("relay"); }
    QStringList consoleOptions() const override { return {}; }
    QStringList inPlace(int, const QStringList& program) const override { return program; }

    Door doorOf(int participant) override
    {
        const QString here = QStringLiteral("127.0.0.1");
        if (!m_settings.remote.contains(participant))
            return {here, m_settings.hostPort};
        m_relays.push_back(std::make_unique<LossyRelay>(
            m_settings.hostPort,
            LossyRelay::Paths{m_settings.scenario.forward, m_settings.scenario.backward},
            (std::uint64_t{m_settings.seed} << 8U) + std::uint64_t(participant)));
        return {here, m_relays.back()->port()};
    }

private:
    SceneNetworkSettings m_settings;
    std::vector<std::unique_ptr<LossyRelay>> m_relays;
};

QString placeNamed(int who)
{
    return who == 0 ? QStringLiteral("host") : QStringLiteral("p%1").arg(who);
}

class NetlabSceneNetwork final : public SceneNetwork
{
public:
    NetlabSceneNetwork(const QString& program, const SceneNetworkSettings& settings)
        : m_lab{program}, m_settings{settings}
    {
    }

    Result<void> start()
    {
        const auto lan = findScenario("lan");
        if (!lan)
            return tl::unexpected(lan.error());
        QString hosts = QStringLiteral("hosts");
        for (int who = 0; who <= m_settings.participants; ++who)
            hosts += QLatin1Char{' '} + placeNamed(who);
        QStringList lines{hosts, QStringLiteral("seed %1").arg(m_settings.seed)};
        for (int who = 1; who <= m_settings.participants; ++who) {
            const bool isRemote = m_settings.remote.contains(who);
            const DriftScenario& path = isRemote ? m_settings.scenario : *lan;
            lines << QStringLiteral("link %1>host %2")
                         .arg(placeNamed(who), netlabWay(path.forward, false, {}))
                  << QStringLiteral("link host>%1 %2")
                         .arg(placeNamed(who), netlabWay(path.backward, false, {}));
        }
        return m_lab.start(lines);
    }

    QString name() const override { return QStringLiteral("netlab"); }
    QStringList consoleOptions() const override { return {QStringLiteral("--open")}; }
    QStringList inPlace(int who, const QStringList& program) const override
    {
        return m_lab.inPlace(placeNamed(who), program);
    }
    Door doorOf(int) override
    {
        return {QString::fromLatin1(NetlabProcess::kFirstAddress), m_settings.hostPort};
    }

private:
    NetlabProcess m_lab;
    SceneNetworkSettings m_settings;
};

} // namespace

std::unique_ptr<SceneNetwork> relayedSceneNetwork(const SceneNetworkSettings& settings)
{
    return std::make_unique<RelayedSceneNetwork>(settings);
}

Result<std::unique_ptr<SceneNetwork>> netlabSceneNetwork(const QString& program,
                                                         const SceneNetworkSettings& settings)
{
    auto network = std::make_unique<NetlabSceneNetwork>(program, settings);
    if (const auto started = network->start(); !started)
        return tl::unexpected(started.error());
    return network;
}

} // namespace carina::lab
