#include "engine/net/anatomy_transfer/set_listener.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/anatomy_transfer/transfer_tls.h"
#include "engine/net/secure/dtls.h"
#include "engine/net/secure/endpoint.h"

#include <QNetworkProxy>
#include <QSslPreSharedKeyAuthenticator>

namespace carina
{

SetListener::SetListener(const std::filesystem::path& anatomyCache) : m_sets{anatomyCache}
{
    setProxy(QNetworkProxy::NoProxy);
    m_pace.setTimerType(Qt::PreciseTimer);
    m_pace.setInterval(SetServer::kPace);
    m_pace.callOnTimeout(this, &SetListener::sendOneChunk);
    connect(this, &QSslServer::preSharedKeyAuthenticationRequired, this,
            [this](QSslSocket*, QSslPreSharedKeyAuthenticator* question) { answerKey(*question); });
    connect(this, &QSslServer::startedEncryptionHandshake, this, [this](QSslSocket* socket) {
        const Endpoint from = endpoint(normalised(socket->peerAddress()), socket->peerPort());
        if (!m_limiter.admits(sourcePrefix(from), monotonicNow()))
            socket->abort();
    });
    connect(this, &QTcpServer::pendingConnectionAvailable, this, &SetListener::welcome);
}

Result<std::uint16_t> SetListener::bind(std::uint16_t port, bool open)
{
    if (!listen(open ? QHostAddress::Any : QHostAddress::LocalHost, port))
        return fail(Errc::AddressInUse, "TCP " + std::to_string(port));
    pauseAccepting();
    return serverPort();
}

void SetListener::admit(const std::string& sessionId, HostTransport::KeyOf keyOf,
                        SetServer::IsNamed isNamed)
{
    m_keyOf = std::move(keyOf);
    m_isNamed = std::move(isNamed);
    setSslConfiguration(transfer::tlsConfiguration(QByteArray::fromStdString(sessionId)));
    resumeAccepting();
}

void SetListener::answerKey(QSslPreSharedKeyAuthenticator& question) const
{
    const auto identity = pskIdentity(question.identity().toStdString());
    auto answer = identity ? m_keyOf(*identity) : HostTransport::KeyAnswer{};
    // Nobody shall learn which identities there are: an unknown one just has a wrong key.
    if (answer.state != HostTransport::KeyAnswer::State::Known)
        answer.key = randomKey();
    answerPsk(question, {}, answer.key);
}

void SetListener::welcome()
{
    while (auto* socket = qobject_cast<QSslSocket*>(nextPendingConnection())) {
        ++m_transfers;
        connect(socket, &QObject::destroyed, this, [this] { --m_transfers; });
        connect(socket, &QSslSocket::disconnected, socket, &QObject::deleteLater);
        auto* sender = new SetSender{*socket, *this}; // Qt's: a child of the socket
        if (m_transfers > SetServer::kMostTransfers)
            sender->refuse(transfer::Reason::Busy);
    }
}

void SetListener::giveTurns(SetSender& sender)
{
    m_turns.emplace_back(&sender);
    if (!m_pace.isActive())
        m_pace.start();
}

void SetListener::sendOneChunk()
{
    bool sent = false;
    for (std::size_t turns = m_turns.size(); turns > 0 && !sent; --turns) {
        const QPointer<SetSender> sender = m_turns.front();
        m_turns.pop_front();
        if (!sender)
            continue; // its connection has ended
        sent = sender->sendChunk();
        if (sender->hasMore())
            m_turns.push_back(sender);
    }
    if (m_turns.empty())
        m_pace.stop();
}

tl::expected<CarriedSet, transfer::Reason> SetListener::find(const std::string& contentHash)
{
    if (!m_isNamed(contentHash))
        return tl::unexpected(transfer::Reason::NotNamed);
    const auto known = m_prepared.find(contentHash);
    if (known != m_prepared.end() && m_sets.has(known->second))
        return known->second;
    const auto prepared = m_sets.prepare(contentHash);
    if (!prepared)
        return tl::unexpected(transfer::Reason::Withdrawn);
    return m_prepared.insert_or_assign(contentHash, *prepared).first->second;
}

} // namespace carina
