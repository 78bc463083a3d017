#include "apps/lab/lossy_relay.h"

#include "engine/core/expects.h"

#include <QTimer>

namespace carina::lab
{
namespace
{

const QHostAddress kLoopback{QHostAddress::LocalHost};

QByteArray readOne(QUdpSocket& socket, quint16& port)
{
    QByteArray bytes(qsizetype(socket.pendingDatagramSize()), '\0');
    socket.readDatagram(bytes.data(), bytes.size(), nullptr, &port);
    return bytes;
}

} // namespace

LossyRelay::LossyRelay(std::uint16_t hostPort, const Path& path, std::uint32_t seed)
    : m_hostPort{hostPort}, m_path{path}, m_random{seed}
{
    const bool bound = m_front.bind(kLoopback, 0);
    CARINA_EXPECTS(bound);
    connect(&m_front, &QUdpSocket::readyRead, this, &LossyRelay::readClients);
}

void LossyRelay::readClients()
{
    while (m_front.hasPendingDatagrams()) {
        quint16 port = 0;
        QByteArray bytes = readOne(m_front, port);
        if (isLost())
            continue;
        m_toHost.push_back({port, bytes});
        later([this, passed = m_toHost.back()] { replay(passed); });
    }
}

void LossyRelay::readHost(Client& client)
{
    while (client.socket.hasPendingDatagrams()) {
        quint16 port = 0;
        const QByteArray bytes = readOne(client.socket, port);
        if (!isLost())
            later([this, bytes, to = client.port] { m_front.writeDatagram(bytes, kLoopback, to); });
    }
}

void LossyRelay::replay(const Passed& passed)
{
    clientAt(passed.clientPort).socket.writeDatagram(passed.bytes, kLoopback, m_hostPort);
}

bool LossyRelay::isLost()
{
    return std::uniform_real_distribution{}(m_random) < m_path.loss || m_cut;
}

LossyRelay::Client& LossyRelay::clientAt(std::uint16_t port)
{
    auto& client = m_clients[port];
    if (!client) {
        client = std::make_unique<Client>();
        client->port = port;
        client->socket.bind(kLoopback, 0);
        connect(&client->socket, &QUdpSocket::readyRead, this,
                [this, known = client.get()] { readHost(*known); });
    }
    return *client;
}

void LossyRelay::later(std::function<void()> send)
{
    const auto delay = std::chrono::round<std::chrono::milliseconds>(m_path.oneWay);
    if (delay.count() == 0)
        return send();
    QTimer::singleShot(delay, Qt::PreciseTimer, this, std::move(send));
}

} // namespace carina::lab
