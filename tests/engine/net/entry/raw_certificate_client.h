#pragma once

#include "tests/engine/net/secure/transports.h"

#include <QSslConfiguration>

namespace carina
{

/// A client on a port of its choice that nobody watches over, and that may keep its proof back.
class RawCertificateClient
{
public:
    RawCertificateClient(std::uint16_t hostPort, const ExpectedCertificate& expected,
                         const std::optional<AccessKey>& key, std::uint16_t port = 0)
        : m_key{key}
    {
        m_socket.bind(kLoopback, port);
        QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { read(); });
        prepareDtls(m_dtls, expected);
        m_dtls.setPeer(kLoopback, hostPort, expected.name);
        m_dtls.doHandshake(&m_socket);
    }
    [[nodiscard]] std::uint16_t port() const { return m_socket.localPort(); }
    [[nodiscard]] bool isAsked() const { return m_isAsked; }
    [[nodiscard]] bool isIn() const { return m_isIn; }
    void send(const char* text) { m_dtls.writeDatagramEncrypted(&m_socket, text); }

private:
    void read()
    {
        while (const auto datagram = readRaw(m_socket)) {
            if (!m_dtls.isConnectionEncrypted()) {
                m_dtls.doHandshake(&m_socket, datagram->bytes);
                continue;
            }
            const QByteArray text = m_dtls.decryptDatagram(&m_socket, datagram->bytes);
            const auto bytes = std::as_bytes(octets(text));
            m_isIn = m_isIn || decodeVerdict(bytes) == true;
            if (const auto challenge = decodeChallenge(bytes))
                answer(*challenge);
        }
    }
    void answer(const RoleChallenge& challenge)
    {
        m_isAsked = true;
        if (!m_key)
            return;
        const auto host = digestOf(m_dtls.dtlsConfiguration().peerCertificate());
        const PskIdentity trainee{{Role::Trainee, std::nullopt}, challenge.sessionId};
        const auto proof = encodeProof(proveRole(trainee, *m_key, challenge.nonce, host));
        m_dtls.writeDatagramEncrypted(&m_socket, viewOf(proof));
    }

    std::optional<AccessKey> m_key;
    bool m_isAsked = false;
    bool m_isIn = false;
    QUdpSocket m_socket;
    QDtls m_dtls{QSslSocket::SslClientMode};
};

} // namespace carina
