#pragma once

#include "engine/net/entry/client_credentials.h"

#include <memory>

namespace carina
{

/// One path of a client to its host: a UDP socket on a local port of its own and the DTLS
/// association over it, from the first hello on. Where a certificate is expected, it is checked
/// first and the client's role proved after it, inside the association; without one the role's key
/// is the association's own.
class ClientPath
{
public:
    enum class State : std::uint8_t { Opening, Encrypted, Failed };

    /// Sends the first hello. @param expected of the host; outlives the path
    /// @param onReadable called when something came
    ClientPath(const QHostAddress& host, std::uint16_t port, ClientCredentials& credentials,
               const std::optional<ExpectedCertificate>& expected, std::function<void()> onReadable,
               LocalTime now);

    /// Reads what came. @param plain is handed what was in it for this node, and when it came
    void serve(const std::function<void(std::span<const std::byte>, LocalTime)>& plain);
    void send(std::span<const std::byte> bytes);
    void close();

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] bool hasMore() const { return m_socket->hasPendingDatagrams(); }
    [[nodiscard]] LocalTime opened() const { return m_opened; }
    [[nodiscard]] LocalTime lastHeard() const { return m_lastHeard; }
    /// Until the first answer came.
    [[nodiscard]] std::optional<Duration> roundTrip() const { return m_roundTrip; }
    /// What the host took, or is asked to take.
    [[nodiscard]] const std::optional<KeyOffer>& offer() const { return m_offer; }

private:
    void shakeHands(const QByteArray& datagram, LocalTime now);
    /// Why the handshake failed, as far as it means that no other can succeed.
    [[nodiscard]] std::optional<Error> handshakeFault(const QByteArray& datagram) const;
    void proveItself(std::span<const std::byte> asked, LocalTime now);
    void admitted(LocalTime now);

    QHostAddress m_host;
    std::uint16_t m_port;
    ClientCredentials& m_credentials;
    const std::optional<ExpectedCertificate>& m_expected;
    /// Serving may end a path that its own socket told of.
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
