#include "engine/net/node/node_loop.h"

#include "engine/core/monotonic_clock.h"
#include "engine/sync/wire/datagram_codec.h"

#include <algorithm>

namespace carina
{

void NodeLoop::drive(std::unique_ptr<NodeDriver> driver, std::unique_ptr<SecureTransport> transport)
{
    m_driver = std::move(driver);
    m_transport = std::move(transport);
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &NodeLoop::serve);
    m_transport->onNews([this] { serve(); });
    m_driver->onNews(
        [this] { QMetaObject::invokeMethod(this, &NodeLoop::serve, Qt::QueuedConnection); });
    serve();
}

void NodeLoop::serve()
{
    if (!m_driver)
        return;
    m_transport->serve(*m_driver, monotonicNow());
    const LocalTime now = monotonicNow();
    send(m_driver->advance(now), now);
    for (const PeerAddress ended : m_driver->takeEnded())
        m_transport->end(ended, *m_driver, now);
    sleepUntil(std::min(m_driver->nextWake(), m_transport->nextWake()), monotonicNow());
}

void NodeLoop::close()
{
    m_timer.stop();
    if (!m_driver)
        return;
    const LocalTime now = monotonicNow();
    send(m_driver->close(now), now);
    m_transport->close();
    m_transport.reset();
    m_driver.reset();
}

void NodeLoop::send(NodeDriver::Datagrams datagrams, LocalTime made)
{
    for (auto& [to, bytes] : datagrams) {
        leaveLater(bytes, monotonicNow() - made);
        m_transport->send(to, bytes);
    }
}

void NodeLoop::sleepUntil(LocalTime wake, LocalTime now)
{
    if (wake == LocalTime::max())
        return m_timer.stop();
    const Duration wait =
        std::clamp<Duration>(wake - std::min(now, wake), Duration{}, std::chrono::seconds{1});
    m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(wait));
}

} // namespace carina
