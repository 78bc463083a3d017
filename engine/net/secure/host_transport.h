#pragma once

#include "engine/net/entry/hello_limiter.h"
#include "engine/net/secure/arrival_queue.h"
#include "engine/net/secure/dtls.h"
#include "engine/net/secure/endpoint_limiter.h"
#include "engine/net/secure/hello_cookies.h"
#include "engine/net/secure/secure_transport.h"
#include "engine/net/secure/socket_drain.h"

#include <algorithm>
#include <memory>

namespace carina
{

/// The host's transport: one UDP socket, and a DTLS association for each authenticated peer.
///
/// A ClientHello from an unknown source is answered with a cookie, and no state is stored for it;
/// the rate of ClientHellos with a cookie is limited for each endpoint, each address, and over all.
/// A handshake is complete only if the key that it began with is still the one of its identity: a
/// code that was changed or a token that was replaced in between lets nobody in. An existing path
/// is replaced only by an authenticated one: a ClientHello with a forged source address does not
/// affect its owner. With a wrong key the last message of the handshake cannot be decrypted; the
/// client is then sent an unencrypted alert, and its handshake is dropped. A host with a
/// certificate requires the proof of a role inside the association instead, and the handshake lasts
/// until it arrives.
class HostTransport : public SecureTransport
{
public:
    struct KeyAnswer {
        enum class State : std::uint8_t { Known, NotYet, Unknown }; ///< NotYet: still being derived
        State state = State::Unknown;
        AccessKey key{}; ///< valid if Known

        friend bool operator==(const KeyAnswer&, const KeyAnswer&) = default;
    };
    using KeyOf = std::function<KeyAnswer(const PskIdentity&)>;

    static constexpr std::size_t kDatagramsPerTurn = 256; ///< handled, of all sources in turn
    static constexpr std::size_t kReadPerTurn = 1024;     ///< from the socket
    /// At once; for a new one, the oldest of the source that has most is dropped.
    static constexpr std::size_t kMostHandshakes = 64;
    /// Those of all participants who may be present, and idle ones: the host ends these soon.
    static constexpr std::size_t kMostPaths = 1536;
    static constexpr Duration kHandshakeTimeout = std::chrono::seconds{5};
    static constexpr Duration kPathTimeout = std::chrono::seconds{10}; ///< without a datagram

    /// Binds the port, on loopback or on all addresses of the computer; datagrams are handled from
    /// admit() on.
    /// @returns AddressInUse with the port.
    [[nodiscard]] static Result<std::unique_ptr<HostTransport>> bind(std::uint16_t port, bool open);
    ~HostTransport() override;

    /// Requires that all handshakes from now on use this certificate.
    void present(HostCertificate certificate);
    /// Starts to accept peers whose keys are known. @param sessionId sent to every peer,
    /// unencrypted
    void admit(const std::string& sessionId, KeyOf keyOf);

    void serve(TransportListener& listener, LocalTime now) override;
    [[nodiscard]] LocalTime nextWake() const override;
    void send(PeerAddress to, std::span<const std::byte> bytes) override;
    void end(PeerAddress peer, TransportListener& listener, LocalTime now) override;
    void close() override;
    [[nodiscard]] std::uint16_t port() const override { return m_socket.localPort(); }

    [[nodiscard]] std::size_t handshakes() const { return m_handshakes.size(); }
    [[nodiscard]] std::size_t paths() const { return m_paths.size(); }

private:
    struct Association;
    using Associations = std::map<Endpoint, std::unique_ptr<Association>>;

    HostTransport() = default;

    void take(const RawDatagram& datagram, TransportListener& listener, LocalTime now);
    void greet(const Endpoint& from, const RawDatagram& hello, LocalTime now);
    void dropHandshake();
    [[nodiscard]] std::unique_ptr<Association> newAssociation(const RawDatagram& hello,
                                                              LocalTime now);
    void goOn(Associations::iterator handshake, const RawDatagram& datagram,
              TransportListener& listener, LocalTime now);
    /// @returns whether the datagram was of this handshake.
    bool hearProof(Associations::iterator handshake, const RawDatagram& datagram,
                   TransportListener& listener, LocalTime now);
    [[nodiscard]] KeyAnswer keyOf(const std::optional<PskIdentity>& identity) const;
    void proved(Associations::iterator handshake, TransportListener& listener, LocalTime now);
    /// Whether the key that the handshake began with is the one of its identity to this moment.
    [[nodiscard]] bool hasHeldKey(const Association& peer) const;
    void decrypt(Associations::iterator path, const RawDatagram& datagram,
                 TransportListener& listener, LocalTime now);
    Associations::iterator drop(Associations::iterator path, TransportListener& listener,
                                LocalTime now);
    void dropSilent(TransportListener& listener, LocalTime now);
    void read();
    void arrive(RawDatagram datagram);
    /// Of all paths and handshakes, sorted.
    [[nodiscard]] std::vector<Endpoint> endpoints() const;
    /// Notes an association that may be silent for too long from a time on.
    void watch(LocalTime from) { m_nobodySilentBefore = std::min(m_nobodySilentBefore, from); }

    QUdpSocket m_socket;
    std::unique_ptr<SocketDrain> m_drain; // of it; null before admit() and after close()
    HelloCookies m_cookies;
    QByteArray m_hint;
    std::optional<HostCertificate> m_certificate;
    CertificateDigest m_digest{}; // of it
    KeyOf m_keyOf;
    EndpointLimiter m_endpointLimiter;
    HelloLimiter m_limiter;
    ArrivalQueue m_arrived;
    Associations m_handshakes;
    Associations m_paths;
    bool m_hasNewEndpoints = false;                  // since the drain was last told
    std::map<PeerAddress, Association*> m_byAddress; // into m_paths
    PeerAddress m_lastAddress = 0;
    /// No association is silent for too long before this.
    LocalTime m_nobodySilentBefore = LocalTime::max();
};

} // namespace carina
