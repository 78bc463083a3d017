#pragma once

#include "engine/net/secure/client_transport.h"
#include "engine/net/secure/dtls_record.h"
#include "engine/net/secure/host_transport.h"
#include "evaluation/network/transport_pump.h"
#include "tests/support/patience.h"

#include <QSslPreSharedKeyAuthenticator>

#include <map>
#include <vector>

namespace carina
{

using namespace std::chrono_literals;

inline const std::string kSession = "00112233445566778899aabbccddeeff";
inline const QHostAddress kLoopback{QHostAddress::LocalHost};

inline std::vector<std::byte> textBytes(const char* text)
{
    const auto bytes = std::as_bytes(std::span{text, std::char_traits<char>::length(text)});
    return {bytes.begin(), bytes.end()};
}

/// Writes down what a transport tells.
class Recorder : public TransportListener
{
public:
    void connected(PeerAddress peer, const Credential& who, LocalTime) override
    {
        paths.emplace(peer, who);
    }
    void receive(PeerAddress, std::span<const std::byte> bytes, LocalTime) override
    {
        received.emplace_back(bytes.begin(), bytes.end());
    }
    void disconnected(PeerAddress peer, LocalTime) override { ended.push_back(peer); }
    void refused(const Error& why, LocalTime) override { refusal = why; }

    std::map<PeerAddress, Credential> paths; ///< that ever were
    std::vector<std::vector<std::byte>> received;
    std::vector<PeerAddress> ended;
    std::optional<Error> refusal;
};

/// A host with one key per role, for those who come with a code, and tokens; a role without a key
/// is one whose key is not derived yet.
struct TestHost {
    explicit TestHost(std::uint16_t port = 0) : transport{*HostTransport::bind(port, false)}
    {
        transport->admit(kSession, [this](const PskIdentity& identity) {
            using State = HostTransport::KeyAnswer::State;
            ++asked;
            const auto known = keys.find(identity.who.role);
            if (identity.sessionId != kSession)
                return HostTransport::KeyAnswer{};
            if (const auto who = identity.who.participant)
                return tokens.contains(*who)
                           ? HostTransport::KeyAnswer{State::Known, tokens.at(*who)}
                           : HostTransport::KeyAnswer{};
            return known == keys.end() ? HostTransport::KeyAnswer{State::NotYet, {}}
                                       : HostTransport::KeyAnswer{State::Known, known->second};
        });
    }
    [[nodiscard]] std::uint16_t port() const { return transport->port(); }

    std::map<Role, AccessKey> keys{{Role::Trainee, randomKey()}, {Role::Observer, randomKey()}};
    std::map<ParticipantId, AccessKey> tokens;
    int asked = 0; ///< for a key
    Recorder heard;
    std::unique_ptr<HostTransport> transport;
    TransportPump pump{*transport, heard};
};

/// A client whose code has the key given.
struct TestClient {
    TestClient(std::uint16_t port, const AccessKey& key, Role role = Role::Trainee,
               std::optional<ExpectedCertificate> expected = {},
               std::uint16_t discoveryPort = kDiscoveryPort,
               const std::filesystem::path& tokens = {})
        : credentials{role, JoinCode::random(), TokenFolder{tokens, role, "Anna"},
                      [key](const JoinCode&, const SessionKey&) { return Result<AccessKey>{key}; }},
          transport{kLoopback,           port,         credentials, monotonicNow(),
                    std::move(expected), discoveryPort}
    {
    }
    void send(const char* text) { transport.send(heard.paths.rbegin()->first, textBytes(text)); }

    Recorder heard;
    ClientCredentials credentials;
    ClientTransport transport;
    TransportPump pump{transport, heard};
};

/// A client without anybody who watches over it, on a port of its choice.
class RawClient
{
public:
    RawClient(std::uint16_t hostPort, const std::string& identity, const AccessKey& key,
              std::uint16_t port = 0)
    {
        m_socket.bind(kLoopback, port);
        QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { read(); });
        QObject::connect(
            &m_dtls, &QDtls::pskRequired, &m_dtls,
            [=](QSslPreSharedKeyAuthenticator* question) { answerPsk(*question, identity, key); });
        prepareDtls(m_dtls, QByteArray{});
        m_dtls.setPeer(kLoopback, hostPort);
        m_dtls.doHandshake(&m_socket);
    }
    [[nodiscard]] std::uint16_t port() const { return m_socket.localPort(); }
    [[nodiscard]] bool isIn() const { return m_dtls.isConnectionEncrypted(); }
    void send(const char* text) { m_dtls.writeDatagramEncrypted(&m_socket, text); }

    std::vector<QByteArray> answers; ///< as they came

private:
    void read()
    {
        while (const auto datagram = readRaw(m_socket)) {
            answers.push_back(datagram->bytes);
            if (m_dtls.handshakeState() == QDtls::HandshakeInProgress)
                m_dtls.doHandshake(&m_socket, datagram->bytes);
        }
    }

    QUdpSocket m_socket;
    QDtls m_dtls{QSslSocket::SslClientMode};
};

/// Between a client and a host: passes all datagrams but the encrypted end of the client's part of
/// a handshake, its Finished, which it holds back until it is let go.
class HeldFinish
{
public:
    explicit HeldFinish(std::uint16_t hostPort) : m_hostPort{hostPort}
    {
        m_front.bind(kLoopback, 0);
        m_back.bind(kLoopback, 0);
        QObject::connect(&m_front, &QUdpSocket::readyRead, &m_front, [this] { passToHost(); });
        QObject::connect(&m_back, &QUdpSocket::readyRead, &m_back, [this] { passToClient(); });
    }
    [[nodiscard]] std::uint16_t port() const { return m_front.localPort(); }
    [[nodiscard]] bool isHeld() const { return !m_held.isEmpty(); }
    void letGo() { m_back.writeDatagram(m_held, kLoopback, m_hostPort); }

private:
    void passToHost()
    {
        while (const auto datagram = readRaw(m_front)) {
            m_client = datagram->port;
            QByteArray rest = datagram->bytes;
            QByteArray passed;
            while (const auto record = firstRecord(octets(rest))) {
                const auto size = static_cast<qsizetype>(record->size);
                const bool isFinished =
                    record->type == DtlsRecord::Type::Handshake && record->epoch > 0;
                (isFinished ? m_held : passed) += rest.first(size);
                rest = rest.sliced(size);
            }
            if (!passed.isEmpty())
                m_back.writeDatagram(passed, kLoopback, m_hostPort);
        }
    }
    void passToClient()
    {
        while (const auto datagram = readRaw(m_back))
            m_front.writeDatagram(datagram->bytes, kLoopback, m_client);
    }

    std::uint16_t m_hostPort;
    std::uint16_t m_client = 0;
    QUdpSocket m_front;
    QUdpSocket m_back;
    QByteArray m_held;
};

} // namespace carina
