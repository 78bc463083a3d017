#include "evaluation/network/lossy_relay.h"

#include "engine/core/expects.h"
#include "engine/core/monotonic_clock.h"

namespace carina
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

LocalTime relayTime() { return machineTime(monotonicNow()); }

} // namespace

LossyRelay::LossyRelay(std::uint16_t hostPort, const Paths& paths, std::uint64_t seed)
    : m_hostPort{hostPort},
      m_inward{paths.toHost, seedToHost(seed)},
      m_outward{paths.toClients, seedToClients(seed)},
      m_begin{relayTime() + std::chrono::hours{1}},
      m_timer{[this] { sendDue(); }}
{
    const bool bound = m_front.bind(kLoopback, 0);
    CARINA_EXPECTS(bound);
    connect(&m_front, &QUdpSocket::readyRead, this, &LossyRelay::readClients);
}

void LossyRelay::readClients()
{
    while (m_front.hasPendingDatagrams()) {
        quint16 port = 0;
        const QByteArray bytes = readOne(m_front, port);
        carry(m_inward, true, {port, bytes});
    }
    sendDue();
}

void LossyRelay::readHost(Client& client)
{
    while (client.socket.hasPendingDatagrams()) {
        quint16 port = 0;
        const QByteArray bytes = readOne(client.socket, port);
        carry(m_outward, false, {client.port, bytes});
    }
    sendDue();
}

void LossyRelay::carry(VirtualLink& link, bool isToHost, const Passed& datagram)
{
    if (m_cut)
        return;
    const auto size = static_cast<std::size_t>(datagram.bytes.size());
    m_bytes += size;
    const auto arrivals = link.send(size, relayTime() - m_begin);
    for (std::size_t copy = 0; copy < arrivals.count; ++copy)
        m_waiting.push({m_begin + arrivals.at[copy], m_order++, isToHost, datagram});
}

void LossyRelay::sendDue()
{
    while (!m_waiting.empty() && m_waiting.top().due <= relayTime()) {
        const auto [due, order, isToHost, datagram] = m_waiting.top();
        m_waiting.pop();
        if (isToHost) {
            m_toHost.push_back(datagram);
            replay(datagram);
        } else {
            m_front.writeDatagram(datagram.bytes, kLoopback, datagram.clientPort);
        }
    }
    if (!m_waiting.empty())
        m_timer.setTo(m_waiting.top().due);
}

void LossyRelay::replay(const Passed& passed)
{
    clientAt(passed.clientPort).socket.writeDatagram(passed.bytes, kLoopback, m_hostPort);
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

} // namespace carina
