#pragma once

#include "engine/net/entry/psk_identity.h"
#include "engine/sync/connection/sync_host.h"

#include <functional>
#include <span>

namespace carina
{

/// Hears what a SecureTransport brings.
class TransportListener
{
public:
    virtual ~TransportListener() = default;

    /// There is a new encrypted path, to somebody who proved to be this.
    virtual void connected(PeerAddress peer, const Credential& who, LocalTime now) = 0;
    /// A datagram over a path that is connected, decrypted.
    virtual void receive(PeerAddress from, std::span<const std::byte> bytes, LocalTime now) = 0;
    /// This path is no more.
    virtual void disconnected(PeerAddress peer, LocalTime now) = 0;
    /// There is no way in, and no more tries are made.
    virtual void refused(const Error& why, LocalTime now) = 0;
};

/// Carries a node's datagrams in DTLS 1.2 with keys that both ends knew before (ECDHE-PSK), and
/// nothing else. A path is one association with its keys and has an address of its own, which is
/// never used again. Lives on the node's thread.
class SecureTransport
{
public:
    virtual ~SecureTransport() = default;

    /// Reads what came and does what is due; called at nextWake() and upon news.
    virtual void serve(TransportListener& listener, LocalTime now) = 0;
    [[nodiscard]] virtual LocalTime nextWake() const = 0;
    /// Dropped where there is no such path any more.
    virtual void send(PeerAddress to, std::span<const std::byte> bytes) = 0;
    /// Tells the peers that their paths end.
    virtual void close() = 0;
    /// The UDP port that peers come to; 0 for one who only goes to others.
    [[nodiscard]] virtual std::uint16_t port() const = 0;

    /// Called when there is something to serve; must return at once.
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
