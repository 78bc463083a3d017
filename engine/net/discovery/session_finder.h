#pragma once

#include "engine/net/discovery/found_sessions.h"

#include <QTimer>
#include <QUdpSocket>

#include <functional>

namespace carina
{

/// Searches for sessions on this computer and on its IPv4 networks, once a second. Needs a thread
/// with an event loop.
class SessionFinder
{
public:
    static constexpr std::chrono::milliseconds kAskEvery{1000};

    /// @param onChange called on this thread whenever sessions() changed
    explicit SessionFinder(std::function<void()> onChange, std::uint16_t port = kDiscoveryPort);

    /// Asks for this session, too, by its id: also one that is joined by link answers that.
    void lookFor(const SessionKey& session);

    [[nodiscard]] std::vector<FoundSession> sessions() const { return m_found.list(); }

private:
    void ask();
    void hear();

    std::function<void()> m_onChange;
    std::uint16_t m_port;
    std::uint32_t m_nonce; ///< answers with another nonce are ignored
    SessionKey m_known{};  ///< of lookFor
    FoundSessions m_found;
    QUdpSocket m_socket;
    QTimer m_timer;
};

} // namespace carina
