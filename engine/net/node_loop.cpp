#include "engine/net/node_loop.h"

#include "engine/core/monotonic_clock.h"

#include <QNetworkProxy>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

// One serving reads no more than this, so that a flood does not keep the timer from its turn.
constexpr int kDatagramsPerTurn = 256;

PeerAddress peerAddress(const QHostAddress& host, std::uint16_t port)
{
    return PeerAddress{host.toIPv4Address()} << 16 | port;
}

} // namespace

PeerAddress loopbackAddress(std::uint16_t port)
{
    return peerAddress(QHostAddress{QHostAddress::LocalHost}, port);
}

Result<std::uint16_t> NodeLoop::bind(std::uint16_t port)
{
    m_socket.setProxy(QNetworkProxy::NoProxy);
    if (!m_socket.bind(QHostAddress::LocalHost, port, QAbstractSocket::DontShareAddress))
        return fail(Errc::AddressInUse, std::to_string(port));
    return m_socket.localPort();
}

void NodeLoop::drive(std::unique_ptr<NodeDriver> driver)
{
    m_driver = std::move(driver);
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &NodeLoop::serve);
    connect(&m_socket, &QUdpSocket::readyRead, this, &NodeLoop::serve);
    serve();
}

void NodeLoop::serve()
{
    if (!m_driver)
        return;
    readDatagrams();
    send(m_driver->advance(monotonicNow()));
    sleepUntil(m_driver->nextWake(), monotonicNow());
}

void NodeLoop::close()
{
    m_timer.stop();
    if (m_driver)
        send(m_driver->close(monotonicNow()));
    m_driver.reset();
    m_socket.close();
}

void NodeLoop::readDatagrams()
{
    // One byte more than fits, to tell a datagram that is too long from one that just fits.
    std::array<std::byte, kLargestDatagram + 1> buffer;
    for (int i = 0; i < kDatagramsPerTurn && m_socket.hasPendingDatagrams(); ++i) {
        QHostAddress host;
        quint16 port = 0;
        const qint64 size = m_socket.readDatagram(reinterpret_cast<char*>(buffer.data()),
                                                  buffer.size(), &host, &port);
        if (size > 0)
            m_driver->receive(peerAddress(host, port),
                              std::span{buffer}.first(static_cast<std::size_t>(size)),
                              monotonicNow());
    }
}

void NodeLoop::send(const NodeDriver::Datagrams& datagrams)
{
    for (const auto& [to, bytes] : datagrams)
        m_socket.writeDatagram(
            reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()),
            QHostAddress{static_cast<quint32>(to >> 16)}, static_cast<quint16>(to & 0xFFFF));
}

void NodeLoop::sleepUntil(LocalTime wake, LocalTime now)
{
    // Datagrams left for the next turn do not signal again.
    if (m_socket.hasPendingDatagrams())
        wake = now;
    if (wake == LocalTime::max())
        return m_timer.stop();
    const Duration wait =
        std::clamp<Duration>(wake - std::min(now, wake), Duration{}, std::chrono::seconds{1});
    m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(wait));
}

} // namespace carina
