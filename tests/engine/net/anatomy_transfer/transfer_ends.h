#pragma once

#include "engine/net/anatomy_transfer/set_fetch.h"
#include "engine/net/anatomy_transfer/set_server.h"
#include "engine/net/anatomy_transfer/transfer_frame.h"
#include "engine/net/anatomy_transfer/transfer_tls.h"
#include "engine/net/secure/dtls.h"
#include "tests/engine/io/anatomy_set/carried_set_files.h"
#include "tests/support/soon.h"

#include <QSslCipher>
#include <QSslPreSharedKeyAuthenticator>
#include <QSslServer>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>

#include <netinet/in.h>
#include <sys/socket.h>

#include <atomic>
#include <deque>
#include <utility>

namespace carina::test
{

using namespace transfer;

inline constexpr int kSoon_ms = 5000;
inline const std::string kCarriedSession = "00112233445566778899aabbccddeeff";
inline const QHostAddress kHere{QHostAddress::LocalHost};

inline AccessKey keyFilledWith(int value)
{
    AccessKey key;
    key.fill(std::byte(value));
    return key;
}

/// The holder of the trainees' code in the session, with its key.
inline KeyOffer traineesOffer()
{
    return {{{Role::Trainee, std::nullopt}, kCarriedSession}, keyFilledWith(7)};
}

/// The holder of a participant's token, with it.
inline KeyOffer tokenOffer(std::uint16_t participant)
{
    return {{{Role::Trainee, ParticipantId{participant}}, kCarriedSession},
            keyFilledWith(100 + participant)};
}

inline HostDoor doorAt(std::uint16_t port, KeyOffer offer = traineesOffer())
{
    return {"127.0.0.1", port, std::move(offer)};
}

inline HostTransport::KeyAnswer answerTo(const PskIdentity& identity)
{
    using State = HostTransport::KeyAnswer::State;
    const auto& participant = identity.who.participant;
    const KeyOffer known = participant ? tokenOffer(participant->value) : traineesOffer();
    return identity == known.identity ? HostTransport::KeyAnswer{State::Known, known.key}
                                      : HostTransport::KeyAnswer{};
}

/// The cache of a computer that imported the sample and carries it. Made once, for hosts to begin
/// with a copy of it.
inline std::filesystem::path cacheWithSample(std::size_t copies)
{
    static const QTemporaryDir folder;
    const auto cache = std::filesystem::path{folder.path().toStdString()} / std::to_string(copies);
    if (!std::filesystem::exists(cache)) {
        importInto(cache, carriedSample(copies));
        const auto prepared = CarriedSets{cache}.prepare(kSetHash);
        Q_ASSERT(prepared);
    }
    return cache;
}

/// A computer that serves the sample, as long as it is named.
struct ServingHost {
    explicit ServingHost(std::size_t copies = 20'000, const SetPatience& given = {})
        : patience{given}
    {
        std::filesystem::copy(cacheWithSample(copies), cache(),
                              std::filesystem::copy_options::recursive);
        bytes =
            contentOf(CarriedSets{cache()}.file(CarriedSets{cache()}.prepare(kSetHash)->digest));
        open();
    }
    void open(std::uint16_t port = 0)
    {
        server = *SetServer::listen(port, false, cache(), patience);
        server->admit(
            kCarriedSession,
            [this](const PskIdentity& identity) {
                return isKeyHeld ? answerTo(identity) : HostTransport::KeyAnswer{};
            },
            [this](const std::string& hash) { return isNamed && hash == kSetHash; },
            [this](const Credential&) { return isWelcome.load(); });
    }
    [[nodiscard]] std::filesystem::path cache() const
    {
        return folder.path().toStdString() + "/host";
    }
    [[nodiscard]] std::uint16_t port() const { return server->port(); }

    QTemporaryDir folder;
    SetPatience patience;
    std::atomic<bool> isNamed = true;
    std::atomic<bool> isKeyHeld = true;
    std::atomic<bool> isWelcome = true; ///< everybody
    QByteArray bytes;                   ///< of the set as it is carried
    std::unique_ptr<SetServer> server;
};

[[nodiscard]] inline bool comes(const SetFetch& fetch)
{
    return soon([&] { return fetch.status().state == FetchStatus::State::Here; });
}

/// A connection to a port of loopback from another of its addresses.
inline int connectedFrom(const QHostAddress& from, std::uint16_t port)
{
    const auto addressOf = [](const QHostAddress& address, std::uint16_t number) {
        sockaddr_in known{};
        known.sin_family = AF_INET;
        known.sin_addr.s_addr = htonl(address.toIPv4Address());
        known.sin_port = htons(number);
        return known;
    };
    const int opened = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in own = addressOf(from, 0);
    const sockaddr_in host = addressOf(kHere, port);
    ::bind(opened, reinterpret_cast<const sockaddr*>(&own), sizeof own);
    ::connect(opened, reinterpret_cast<const sockaddr*>(&host), sizeof host);
    return opened;
}

/// A peer that speaks frames by hand, at either end.
class RawPeer
{
public:
    /// A client, once it is let in or turned away. @param configuration of its own, or Carina's
    /// @param from one of the loopback addresses of this computer
    explicit RawPeer(std::uint16_t port, const KeyOffer& offer = traineesOffer(),
                     const QSslConfiguration& configuration = tlsConfiguration({}),
                     int patience_ms = kSoon_ms, const QHostAddress& from = kHere)
        : m_socket{new QSslSocket}
    {
        m_socket->setSslConfiguration(configuration);
        QObject::connect(m_socket.get(), &QSslSocket::preSharedKeyAuthenticationRequired,
                         m_socket.get(), [=](QSslPreSharedKeyAuthenticator* question) {
                             answerPsk(*question, toText(offer.identity), offer.key);
                         });
        if (from == kHere) {
            m_socket->connectToHostEncrypted(kHere.toString(), port);
        } else {
            m_socket->setSocketDescriptor(connectedFrom(from, port));
            m_socket->startClientEncryption();
        }
        m_socket->waitForEncrypted(patience_ms);
    }
    /// A host's end.
    explicit RawPeer(QSslSocket* accepted) : m_socket{accepted} { accepted->setParent(nullptr); }

    [[nodiscard]] QSslSocket& socket() { return *m_socket; }
    [[nodiscard]] bool isIn() const { return m_socket->isEncrypted(); }
    [[nodiscard]] bool isOut() const
    {
        return m_socket->state() == QAbstractSocket::UnconnectedState;
    }
    void say(const Frame& frame) { say(encode(frame)); }
    void say(const std::vector<std::byte>& raw)
    {
        m_socket->write(viewOf(raw).constData(), static_cast<qint64>(raw.size()));
    }
    /// The frames that came so far, but chunks, which are kept in `chunks`.
    const std::vector<Frame>& heard()
    {
        m_received += m_socket->readAll();
        auto rest = test::bytesOf(m_received);
        for (auto frame = takeFrame(rest); frame && *frame; frame = takeFrame(rest)) {
            if (const auto* chunk = std::get_if<Chunk>(&**frame))
                chunks += viewOf(chunk->bytes);
            else
                m_heard.push_back(**frame);
        }
        m_received = m_received.last(static_cast<qsizetype>(rest.size()));
        return m_heard;
    }
    /// Those that were not taken yet.
    std::vector<Frame> takeHeard()
    {
        heard();
        return std::exchange(m_heard, {});
    }
    QByteArray chunks;

private:
    std::unique_ptr<QSslSocket> m_socket;
    QByteArray m_received;
    std::vector<Frame> m_heard;
};

/// A host that answers what a test says, instead of what it has.
class ScriptedHost
{
public:
    using Script = std::function<void(RawPeer&, const Frame&)>;

    explicit ScriptedHost(Script script) : m_script{std::move(script)}
    {
        m_server.setSslConfiguration(tlsConfiguration(QByteArray::fromStdString(kCarriedSession)));
        QObject::connect(&m_server, &QSslServer::preSharedKeyAuthenticationRequired, &m_server,
                         [](QSslSocket*, QSslPreSharedKeyAuthenticator* question) {
                             answerPsk(*question, {}, traineesOffer().key);
                         });
        QObject::connect(&m_server, &QTcpServer::pendingConnectionAvailable, &m_server,
                         [this] { welcome(); });
        m_server.listen(kHere, 0);
    }
    [[nodiscard]] std::uint16_t port() const { return m_server.serverPort(); }
    int connections = 0;

private:
    void welcome()
    {
        while (auto* socket = qobject_cast<QSslSocket*>(m_server.nextPendingConnection())) {
            ++connections;
            RawPeer& peer = m_peers.emplace_back(socket);
            const auto answer = [this, &peer] {
                for (const Frame& frame : peer.takeHeard())
                    m_script(peer, frame);
            };
            QObject::connect(socket, &QSslSocket::readyRead, socket, answer);
            answer();
        }
    }

    Script m_script;
    QSslServer m_server;
    std::deque<RawPeer> m_peers;
};

/// Passes bytes between a client and a host, and breaks the connection after so many.
class BreakingRelay
{
public:
    BreakingRelay(std::uint16_t hostPort, std::vector<qint64> breakAfter)
        : m_hostPort{hostPort}, m_breakAfter{std::move(breakAfter)}
    {
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_server, [this] { welcome(); });
        m_server.listen(kHere, 0);
    }
    [[nodiscard]] std::uint16_t port() const { return m_server.serverPort(); }
    std::vector<qint64> toClient; ///< bytes, of each connection

private:
    void welcome()
    {
        QTcpSocket* client = m_server.nextPendingConnection();
        auto* host = new QTcpSocket{client};
        const std::size_t number = toClient.size();
        toClient.push_back(0);
        QObject::connect(client, &QTcpSocket::readyRead, host,
                         [=] { host->write(client->readAll()); });
        QObject::connect(host, &QTcpSocket::readyRead, client, [=, this] {
            const QByteArray bytes = host->readAll();
            toClient[number] += bytes.size();
            client->write(bytes);
            if (number < m_breakAfter.size() && toClient[number] > m_breakAfter[number])
                client->disconnectFromHost(); // what was passed on still arrives
        });
        QObject::connect(host, &QTcpSocket::disconnected, client, &QTcpSocket::disconnectFromHost);
        QObject::connect(client, &QTcpSocket::disconnected, host, &QTcpSocket::abort);
        host->connectToHost(kHere, m_hostPort);
        host->waitForConnected();
        host->write(client->readAll());
    }

    std::uint16_t m_hostPort;
    std::vector<qint64> m_breakAfter;
    QTcpServer m_server;
};

} // namespace carina::test
