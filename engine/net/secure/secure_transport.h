#pragma once

#include "engine/net/entry/psk_identity.h"
#include "engine/net/entry/source_limiter.h"
#include "engine/sync/connection/sync_host.h"

#include <functional>
#include <span>

namespace carina
{

/// Receives the events of a SecureTransport.
class TransportListener
{
public:
    virtual ~TransportListener() = default;

    /// Where the peer of the next path comes from; told before it by a host's transport.
    virtual void cameFrom(const SourcePrefix& /*source*/) {}
    /// There is a new encrypted path to a peer that authenticated as `who`.
    virtual void connected(PeerAddress peer, const Credential& who, LocalTime now) = 0;
    /// A datagram that arrived over a connected path, decrypted.
    virtual void receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now) = 0;
    /// This path has ended.
    virtual void disconnected(PeerAddress peer, LocalTime now) = 0;
    /// The host cannot be joined, and no further attempt is made.
    virtual void refused(const Error& why, LocalTime now) = 0;
};

/// Transports a node's datagrams in DTLS 1.2: with pre-shared keys (ECDHE-PSK), or with a
/// certificate of the host. A path is one association with its keys; its address is never reused.
/// Used on the node's thread.
class SecureTransport
{
public:
    virtual ~SecureTransport() = default;

    /// Handles the datagrams that arrived and what is due; to be called at nextWake() and when
    /// onNews calls.
    virtual void serve(TransportListener& listener, LocalTime now) = 0;
    [[nodiscard]] virtual LocalTime nextWake() const = 0;
    /// Sends a datagram; it is dropped where the path has ended.
    virtual void send(PeerAddress to, std::span<const std::byte> bytes) = 0;
    /// Ends one path; the listener hears of it. At a client nothing.
    virtual void end(PeerAddress /*peer*/, TransportListener& /*listener*/, LocalTime /*now*/) {}
    /// Informs the peers that their paths end.
    virtual void close() = 0;
    /// The local UDP port for peers; 0 at a client.
    [[nodiscard]] virtual std::uint16_t port() const = 0;

    /// Sets a callback for when there is something to serve; it must not block.
    void onNews(std::function<void()> callback) { m_onNews = std::move(callback); }

protected:
    void tellNews() const
    {
        if (m_onNews)
            m_onNews();
    }

private:
    std::function<void()> m_onNews;
};

} // namespace carina
