#pragma once

#include "engine/net/discovery/session_notice.h"
#include "engine/net/entry/source_limiter.h"

#include <QUdpSocket>

#include <memory>

namespace carina
{

/// Who gets an answer.
enum class Announced : std::uint8_t {
    ToAll,
    ToThoseWhoKnowIt, ///< whose question names the session: they were in it
};

/// Answers discovery questions for a session that is hosted here. Needs a thread with an event
/// loop.
class SessionBeacon
{
public:
    /// @param open answers other computers too; else only this one.
    /// @returns AddressInUse where another program has the discovery port: the session can then be
    ///          joined by its address only.
    [[nodiscard]] static Result<std::unique_ptr<SessionBeacon>>
    open(const SessionNotice& notice, bool open, std::uint16_t port = kDiscoveryPort,
         Announced announced = Announced::ToAll);

private:
    SessionBeacon(SessionNotice notice, Announced announced)
        : m_notice{std::move(notice)}, m_announced{announced}
    {
    }
    void answer();
    [[nodiscard]] bool isMeant(const SessionQuestion& question) const;

    SessionNotice m_notice;
    Announced m_announced;
    SourceLimiter m_limiter;
    QUdpSocket m_socket;
};

} // namespace carina
