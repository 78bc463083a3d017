#include "engine/net/anatomy_transfer/set_listener.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/anatomy_transfer/transfer_tls.h"
#include "engine/net/secure/dtls.h"
#include "engine/net/secure/endpoint.h"

#include <QNetworkProxy>
#include <QSslPreSharedKeyAuthenticator>

#include <algorithm>

namespace carina
{

SetListener::SetListener(const std::filesystem::path& anatomyCache, const SetPatience& patience)
    : m_sets{anatomyCache}, m_patience{patience}
{
    setProxy(QNetworkProxy::NoProxy);
    m_pace.setTimerType(Qt::PreciseTimer);
    m_pace.setInterval(SetServer::kPace);
    m_pace.callOnTimeout(this, &SetListener::sendOneChunk);
    m_look.setInterval(SetServer::kLook);
    m_look.callOnTimeout(this, &SetListener::endVoid);
    connect(this, &QSslServer::preSharedKeyAuthenticationRequired, this,
            [this](QSslSocket* socket, QSslPreSharedKeyAuthenticator* question) {
                answerKey(socket, *question);
            });
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
                        SetServer::IsNamed isNamed, SetServer::IsWelcome isWelcome)
{
    m_keyOf = std::move(keyOf);
    m_isNamed = std::move(isNamed);
    m_isWelcome = std::move(isWelcome);
    setSslConfiguration(transfer::tlsConfiguration(QByteArray::fromStdString(sessionId)));
    resumeAccepting();
}

void SetListener::answerKey(QSslSocket* socket, QSslPreSharedKeyAuthenticator& question)
{
    const auto identity = pskIdentity(question.identity().toStdString());
    auto answer = identity ? m_keyOf(*identity) : HostTransport::KeyAnswer{};
    // Nobody shall learn which identities there are: an unknown one just has a wrong key.
    if (answer.state != HostTransport::KeyAnswer::State::Known)
        answer.key = randomKey();
    std::erase_if(m_asked, [](const Asked& asked) { return asked.socket.isNull(); });
    if (identity)
        m_asked.push_back({socket, {*identity, answer.key}});
    answerPsk(question, {}, answer.key);
}

std::optional<SetListener::Key> SetListener::takeKey(const QSslSocket* socket)
{
    const auto asked = std::ranges::find_if(
        m_asked, [socket](const Asked& one) { return one.socket.data() == socket; });
    if (asked == m_asked.end())
        return std::nullopt;
    Key key = std::move(asked->key);
    m_asked.erase(asked);
    return key;
}

bool SetListener::mayHave(const Key& key) const
{
    const auto held = m_keyOf(key.identity);
    return held.state == HostTransport::KeyAnswer::State::Known && held.key == key.key
           && (!m_isWelcome || m_isWelcome(key.identity.who));
}

void SetListener::welcome()
{
    while (auto* socket = qobject_cast<QSslSocket*>(nextPendingConnection())) {
        connect(socket, &QSslSocket::disconnected, socket, &QObject::deleteLater);
        const auto key = takeKey(socket);
        // A handshake lasts as long as its client likes: meanwhile the key may have become void.
        if (!key || !mayHave(*key)) {
            socket->abort();
            continue;
        }
        const Endpoint from = endpoint(normalised(socket->peerAddress()), socket->peerPort());
        auto* sender = new SetSender{*socket, *this, m_patience}; // Qt's: a child of the socket
        if (findPlace(*sender, *key, sourcePrefix(from)))
            sender->start();
        else
            sender->refuse(transfer::Reason::Busy);
    }
}

bool SetListener::findPlace(SetSender& sender, const Key& key, const SourcePrefix& from)
{
    std::erase_if(m_transfers, [](const Transfer& transfer) {
        return transfer.sender.isNull() || transfer.sender->isOver();
    });
    const LocalTime now = monotonicNow();
    std::vector<TransferPlace> places;
    for (const Transfer& transfer : m_transfers)
        places.push_back({transfer.key.identity.who, transfer.from, transfer.sender->held(now),
                          transfer.sender->bytesPerSecond(now)});
    const PlaceVerdict verdict = placeFor({key.identity.who, from}, places);
    if (!verdict.isAdmitted)
        return false;
    if (verdict.ended) {
        // Not refused in words: it may never read them.
        m_transfers.at(*verdict.ended).sender->abort();
        m_transfers.erase(m_transfers.begin() + static_cast<std::ptrdiff_t>(*verdict.ended));
    }
    m_transfers.push_back({&sender, key, from});
    if (!m_look.isActive())
        m_look.start();
    return true;
}

void SetListener::endVoid()
{
    std::erase_if(m_transfers, [this](const Transfer& transfer) {
        if (transfer.sender.isNull() || transfer.sender->isOver())
            return true;
        if (mayHave(transfer.key))
            return false;
        transfer.sender->abort();
        return true;
    });
    if (m_transfers.empty())
        m_look.stop();
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
