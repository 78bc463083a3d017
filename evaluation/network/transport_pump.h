#pragma once

#include "engine/core/monotonic_clock.h"
#include "engine/net/secure/secure_transport.h"

#include <QTimer>

#include <algorithm>

namespace carina
{

/// Runs a transport from this thread's event loop, without a node.
class TransportPump
{
public:
    /// @pre both outlive the pump.
    TransportPump(SecureTransport& transport, TransportListener& listener)
        : m_transport{transport}, m_listener{listener}
    {
        m_timer.setSingleShot(true);
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { serve(); });
        m_transport.onNews([this] { serve(); });
        serve();
    }
    ~TransportPump() { m_transport.onNews({}); }
    TransportPump(const TransportPump&) = delete;
    TransportPump& operator=(const TransportPump&) = delete;

    void serve()
    {
        const LocalTime now = monotonicNow();
        m_transport.serve(m_listener, now);
        const LocalTime wake = std::clamp(m_transport.nextWake(), now, now + kLongestSleep);
        m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(wake - now));
    }

private:
    static constexpr Duration kLongestSleep = std::chrono::seconds{1};

    SecureTransport& m_transport;
    TransportListener& m_listener;
    QTimer m_timer;
};

} // namespace carina
