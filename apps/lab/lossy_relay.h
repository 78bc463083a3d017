#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"

#include <QObject>
#include <QUdpSocket>

#include <map>
#include <memory>
#include <random>
#include <vector>

namespace carina::lab
{

/// Stands between clients and a host on loopback: passes datagrams on, each way late by as much and
/// lost as often as told. Each client's come to the host from a port of their own. Which are lost
/// follows from the seed and the order in which they come.
class LossyRelay : public QObject
{
public:
    struct Path {
        Duration oneWay{};
        double loss = 0.0; ///< share of the datagrams, each way
    };
    /// One that was passed on to the host.
    struct Passed {
        std::uint16_t clientPort = 0;
        QByteArray bytes;
    };

    /// @pre a port is free.
    LossyRelay(std::uint16_t hostPort, const Path& path, std::uint32_t seed);

    [[nodiscard]] std::uint16_t port() const { return m_front.localPort(); }
    [[nodiscard]] const std::vector<Passed>& toHost() const { return m_toHost; }
    /// Once more what was passed on before, from where it came from then.
    void replay(const Passed& passed);
    /// While it is cut nothing passes.
    void setCut(bool cut) { m_cut = cut; }

private:
    struct Client {
        std::uint16_t port = 0;
        QUdpSocket socket; // towards the host
    };

    void readClients();
    void readHost(Client& client);
    [[nodiscard]] bool isLost();
    [[nodiscard]] Client& clientAt(std::uint16_t port);
    void later(std::function<void()> send);

    std::uint16_t m_hostPort;
    Path m_path;
    std::mt19937 m_random;
    bool m_cut = false;
    QUdpSocket m_front;
    std::map<std::uint16_t, std::unique_ptr<Client>> m_clients;
    std::vector<Passed> m_toHost;
};

} // namespace carina::lab
