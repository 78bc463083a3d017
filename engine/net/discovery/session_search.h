#pragma once

#include "engine/net/discovery/session_notice.h"

#include <QHostAddress>
#include <QTimer>
#include <QUdpSocket>

#include <functional>
#include <vector>

namespace carina
{

/// Looks for the host of one session, at whatever address and port it is now. Anybody can answer in
/// the session's name, so every place that does is reported, and whose it is shows only in the
/// handshake. Needs a thread with an event loop.
class SessionSearch
{
public:
    static constexpr std::chrono::milliseconds kAskEvery{500};
    /// Most places that wait to be taken, so that forged answers cannot exhaust the memory. A
    /// further one takes the place of any, so that those who answer first keep nobody out.
    static constexpr std::size_t kMost = 16;

    struct Place {
        QHostAddress address;
        std::uint16_t port = 0; ///< UDP

        friend bool operator==(const Place&, const Place&) = default;
    };

    /// @param onAnswer called on this thread when there is a place to take
    SessionSearch(const SessionKey& session, std::function<void()> onAnswer,
                  std::uint16_t port = kDiscoveryPort);

    /// Any of the places that wait. One that answers again later is reported again.
    [[nodiscard]] std::optional<Place> take();

private:
    void ask();
    void hear();
    [[nodiscard]] bool keep(const Place& place);

    SessionQuestion m_question;
    std::function<void()> m_onAnswer;
    std::uint16_t m_port;
    std::vector<Place> m_places;
    QUdpSocket m_socket;
    QTimer m_timer;
};

} // namespace carina
