#include "apps/lab/network/loopback_round_trip.h"

#include "engine/core/monotonic_clock.h"

#include <QUdpSocket>

#include <algorithm>
#include <future>
#include <thread>
#include <vector>

namespace carina::lab
{
namespace
{

constexpr std::size_t kExchanges = 400;
constexpr Duration kPause = std::chrono::milliseconds{2};
constexpr int kPatience_ms = 1000;
constexpr int kEchoWait_ms = 50;
constexpr qint64 kBytes = 16;

/// Answers each datagram with its own bytes. Its port is 0 where it has no socket.
class Echo
{
public:
    Echo()
        : m_port{m_bound.get_future()}, m_thread{[this](const std::stop_token& stopping) {
              answer(stopping);
          }}
    {
    }

    [[nodiscard]] quint16 port() { return m_port.get(); }

private:
    void answer(const std::stop_token& stopping)
    {
        QUdpSocket socket;
        m_bound.set_value(socket.bind(QHostAddress::LocalHost) ? socket.localPort() : 0);
        QByteArray bytes(kBytes, '\0');
        while (!stopping.stop_requested()) {
            if (!socket.waitForReadyRead(kEchoWait_ms))
                continue;
            QHostAddress from;
            quint16 port = 0;
            const qint64 size = socket.readDatagram(bytes.data(), bytes.size(), &from, &port);
            if (size > 0)
                socket.writeDatagram(bytes.constData(), size, from, port);
        }
    }

    std::promise<quint16> m_bound;
    std::future<quint16> m_port;
    std::jthread m_thread; // last: it uses the others
};

std::optional<Duration> exchange(QUdpSocket& socket, quint16 port)
{
    QByteArray bytes(kBytes, 'c');
    const LocalTime sent = monotonicNow();
    if (socket.writeDatagram(bytes, QHostAddress::LocalHost, port) != kBytes
        || !socket.waitForReadyRead(kPatience_ms)
        || socket.readDatagram(bytes.data(), bytes.size()) != kBytes)
        return std::nullopt;
    return monotonicNow() - sent;
}

} // namespace

Result<LoopbackRoundTrip> loopbackRoundTrip()
{
    Echo echo;
    QUdpSocket socket;
    const quint16 port = echo.port();
    if (port == 0 || !socket.bind(QHostAddress::LocalHost))
        return fail(Errc::AddressInUse, "a datagram on loopback");
    std::vector<Duration> times;
    while (times.size() < kExchanges) {
        const auto time = exchange(socket, port);
        if (!time)
            return fail(Errc::Cancelled, "A datagram on loopback was not answered.");
        times.push_back(*time);
        std::this_thread::sleep_for(kPause);
    }
    std::ranges::sort(times);
    return LoopbackRoundTrip{.median = times[kExchanges / 2], .p95 = times[kExchanges * 95 / 100]};
}

} // namespace carina::lab
