#pragma once

#include "engine/net/discovery/found_sessions.h"

#include <QTimer>
#include <QUdpSocket>

#include <functional>

namespace carina
{

/// Looks for sessions on this computer and on the networks it is in (IPv4), once a second. Lives on
/// a thread with an event loop.
class SessionFinder
{
public:
    static constexpr std::chrono::milliseconds kAskEvery{1000};

    /// @param onChange called on this thread whenever sessions() changed
    explicit SessionFinder(std::function<void()> onChange, std::uint16_t port = kDiscoveryPort);

    [[nodiscard]] std::vector<FoundSession> sessions() const { return m_found.list(); }

private:
    void ask();
    void hear();

    std::function<void()> m_onChange;
    std::uint16_t m_port;
    std::uint32_t m_nonce; ///< answers to others' questions are not heard
    FoundSessions m_found;
    QUdpSocket m_socket;
    QTimer m_timer;
};

} // namespace carina
