#pragma once

#include "engine/net/entry/client_credentials.h"

#include <memory>

namespace carina
{

/// How a client came to know where its host is.
enum class HostPlace : std::uint8_t {
    Told, ///< by a person or a link
    /// By an answer that anybody may have given: only a token is offered there, and nothing that is
    /// said there before it is accepted counts.
    Found,
};

/// One path of a client to its host: a UDP socket with its own local port and the DTLS association
/// over it, from the first ClientHello on. Where a certificate is expected, it is checked in the
/// handshake and the client then proves its role inside the association; otherwise the role's key
/// is the pre-shared key of the handshake.
class ClientPath
{
public:
    enum class State : std::uint8_t { Opening, Encrypted, Failed };

    /// Sends the first ClientHello. @param expected of the host; outlives the path
    /// @param onReadable called when a datagram arrived
    /// @param from address of this computer; null: any that reaches the host
    ClientPath(const QHostAddress& host, std::uint16_t port, ClientCredentials& credentials,
               const std::optional<ExpectedCertificate>& expected, std::function<void()> onReadable,
               LocalTime now, HostPlace place = HostPlace::Told, const QHostAddress& from = {});

    /// Reads the datagrams that arrived. @param plain receives each decrypted datagram and its time
    /// of arrival
    void serve(const std::function<void(std::span<const std::byte>, LocalTime)>& plain);
    void send(std::span<const std::byte> bytes);
    void close();

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] const QHostAddress& host() const { return m_host; }
    [[nodiscard]] std::uint16_t hostPort() const { return m_port; }
    [[nodiscard]] bool hasMore() const { return m_socket->hasPendingDatagrams(); }
    [[nodiscard]] LocalTime opened() const { return m_opened; }
    [[nodiscard]] LocalTime lastHeard() const { return m_lastHeard; }
    /// Of the first exchange; nothing before the first answer.
    [[nodiscard]] std::optional<Duration> roundTrip() const { return m_roundTrip; }
    /// The key that the host accepted, or is being offered.
    [[nodiscard]] const std::optional<KeyOffer>& offer() const { return m_offer; }

private:
    void shakeHands(const QByteArray& datagram, LocalTime now);
    /// The reason why the handshake failed, where it means that no other attempt can succeed.
    [[nodiscard]] std::optional<Error> handshakeFault(const QByteArray& datagram) const;
    void proveItself(std::span<const std::byte> asked, LocalTime now);
    void admitted(LocalTime now);
    [[nodiscard]] std::optional<KeyOffer> offerFor(const std::string& session) const;
    void rejected();

    QHostAddress m_host;
    std::uint16_t m_port;
    HostPlace m_place;
    ClientCredentials& m_credentials;
    const std::optional<ExpectedCertificate>& m_expected;
    /// Defers deletion: serving may end a path within a signal of its own socket.
    struct DeleteLater {
        void operator()(QUdpSocket* socket) const;
    };
    std::unique_ptr<QUdpSocket, DeleteLater> m_socket;
    QDtls m_dtls{QSslSocket::SslClientMode};
    State m_state = State::Opening;
    LocalTime m_opened;
    LocalTime m_lastHeard;
    std::optional<Duration> m_roundTrip;
    std::optional<KeyOffer> m_offer;
};

} // namespace carina
