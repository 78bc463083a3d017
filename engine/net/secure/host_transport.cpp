#include "engine/net/secure/host_transport.h"

#include "engine/net/secure/dtls_record.h"

#include <QNetworkProxy>
#include <QSslPreSharedKeyAuthenticator>

#include <algorithm>
#include <utility>

namespace carina
{

namespace
{

constexpr int kReceiveBuffer = 4 << 20; ///< bytes that are asked for

} // namespace

struct HostTransport::Association {
    PeerAddress address = 0;
    QByteArray hello; // that it began with
    LocalTime lastHeard{};
    bool asked = false;                  // for its key
    AccessKey nonce{};                   // that a role is proved with, under a certificate
    std::optional<PskIdentity> identity; // as it says
    KeyAnswer key;                       // that it has to have for that
    QDtls dtls{QSslSocket::SslServerMode};
};

Result<std::unique_ptr<HostTransport>> HostTransport::bind(std::uint16_t port, bool open)
{
    std::unique_ptr<HostTransport> transport{new HostTransport};
    QUdpSocket& socket = transport->m_socket;
    socket.setProxy(QNetworkProxy::NoProxy);
    if (!socket.bind(open ? QHostAddress::Any : QHostAddress::LocalHost, port,
                     QAbstractSocket::DontShareAddress))
        return fail(Errc::AddressInUse, std::to_string(port));
    // As much as the system gives.
    socket.setSocketOption(QAbstractSocket::ReceiveBufferSizeSocketOption, kReceiveBuffer);
    return transport;
}

HostTransport::~HostTransport() = default;

void HostTransport::present(HostCertificate certificate)
{
    m_digest = digestOf(certificate.chain.first());
    m_certificate = std::move(certificate);
}

void HostTransport::admit(const std::string& sessionId, KeyOf keyOf)
{
    m_hint = QByteArray::fromStdString(sessionId);
    m_keyOf = std::move(keyOf);
    QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { tellNews(); });
    const auto onNews = [this] {
        QMetaObject::invokeMethod(
            &m_socket, [this] { tellNews(); }, Qt::QueuedConnection);
    };
    m_drain = std::make_unique<SocketDrain>(m_socket.socketDescriptor(), onNews);
    m_drain->start();
}

void HostTransport::serve(TransportListener& listener, LocalTime now)
{
    read();
    for (std::size_t i = 0; i < kDatagramsPerTurn; ++i) {
        const auto datagram = m_arrived.next();
        if (!datagram)
            break;
        // One left from an earlier turn counts as arrived in this one: the listener's time only
        // rises.
        take(*datagram, listener, std::max(datagram->arrived, now));
    }
    dropSilent(listener, now);
}

void HostTransport::read()
{
    // All are read before the first is taken, for each counts as arrived when it was read.
    SocketDrain::Hold hold;
    if (m_drain) {
        hold = m_drain->hold();
        if (std::exchange(m_hasNewEndpoints, false))
            m_drain->setKnown(endpoints(), hold);
        for (RawDatagram& datagram : m_drain->take(hold))
            arrive(std::move(datagram));
    }
    for (std::size_t i = 0; i < kReadPerTurn; ++i) {
        auto datagram = readRaw(m_socket);
        if (!datagram)
            return;
        arrive(*std::move(datagram));
    }
}

std::vector<Endpoint> HostTransport::endpoints() const
{
    std::vector<Endpoint> all;
    for (const Associations* associations : {&m_paths, &m_handshakes})
        for (const auto& [from, association] : *associations)
            all.push_back(from);
    std::ranges::sort(all);
    return all;
}

void HostTransport::arrive(RawDatagram datagram)
{
    if (!firstRecord(octets(datagram.bytes)))
        return;
    const Endpoint from = endpoint(datagram.from, datagram.port);
    const bool isKnown = m_paths.contains(from) || m_handshakes.contains(from);
    m_arrived.add(from, std::move(datagram), isKnown);
}

LocalTime HostTransport::nextWake() const
{
    // Datagrams left for the next turn do not signal again.
    if (!m_arrived.empty() || m_socket.hasPendingDatagrams())
        return LocalTime::min();
    return m_nobodySilentBefore;
}

void HostTransport::send(PeerAddress to, std::span<const std::byte> bytes)
{
    if (const auto path = m_byAddress.find(to); path != m_byAddress.end())
        path->second->dtls.writeDatagramEncrypted(&m_socket, viewOf(bytes));
}

void HostTransport::end(PeerAddress peer, TransportListener& listener, LocalTime now)
{
    const auto path = std::ranges::find_if(
        m_paths, [peer](const auto& entry) { return entry.second->address == peer; });
    if (path == m_paths.end())
        return;
    path->second->dtls.shutdown(&m_socket);
    drop(path, listener, now);
}

void HostTransport::close()
{
    for (const auto& [from, path] : m_paths)
        path->dtls.shutdown(&m_socket);
    m_byAddress.clear();
    m_paths.clear();
    m_handshakes.clear();
    m_arrived.clear();
    m_drain.reset();
    m_socket.close();
}

void HostTransport::take(const RawDatagram& datagram, TransportListener& listener, LocalTime now)
{
    const auto record = firstRecord(octets(datagram.bytes));
    if (!record)
        return;
    const Endpoint from = endpoint(datagram.from, datagram.port);
    if (isClientHello(octets(datagram.bytes)))
        return greet(from, datagram, now);
    const bool shakesHands = record->epoch == 0 || record->type == DtlsRecord::Type::Handshake;
    if (const auto handshake = m_handshakes.find(from); handshake != m_handshakes.end()) {
        // What a path before it was sent may still arrive while its role is to be proved.
        if (handshake->second->dtls.isConnectionEncrypted()) {
            if (hearProof(handshake, datagram, listener, now))
                return;
        } else if (shakesHands) {
            return goOn(handshake, datagram, listener, now);
        }
    }
    if (const auto path = m_paths.find(from); path != m_paths.end())
        decrypt(path, datagram, listener, now);
}

void HostTransport::greet(const Endpoint& from, const RawDatagram& hello, LocalTime now)
{
    const auto began = [&](const Associations& associations) {
        const auto known = associations.find(from);
        return known != associations.end() && known->second->hello == hello.bytes;
    };
    // A repeat uses nothing up: whoever captured it can send it as often as they like.
    if (began(m_handshakes) || began(m_paths))
        return;
    const auto cookie = m_cookies.check(m_socket, hello, now);
    if (!cookie)
        return; // it was sent its cookie, and comes again with it
    // Only now is the source proved: a forged one cannot use up its owner's share.
    if (!m_endpointLimiter.hasRoom(from, now) || !m_limiter.admits(sourcePrefix(from), now))
        return;
    m_endpointLimiter.count(from, now);
    auto association = newAssociation(hello, now);
    // It looks at the cookie once more.
    association->dtls.setCookieGeneratorParameters(*cookie);
    if (!association->dtls.doHandshake(&m_socket, hello.bytes))
        return;
    m_handshakes.insert_or_assign(from, std::move(association));
    m_hasNewEndpoints = true;
    watch(now + kHandshakeTimeout);
    if (m_handshakes.size() > kMostHandshakes)
        dropHandshake();
}

void HostTransport::dropHandshake()
{
    std::map<SourcePrefix, std::size_t> ofSource;
    for (const auto& [endpoint, association] : m_handshakes)
        ++ofSource[sourcePrefix(endpoint)];
    // The most negative number is least: of the busiest source, the oldest.
    m_handshakes.erase(std::ranges::min_element(m_handshakes, {}, [&](const auto& entry) {
        return std::pair{-static_cast<std::ptrdiff_t>(ofSource.at(sourcePrefix(entry.first))),
                         entry.second->lastHeard};
    }));
}

std::unique_ptr<HostTransport::Association> HostTransport::newAssociation(const RawDatagram& hello,
                                                                          LocalTime now)
{
    auto association = std::make_unique<Association>();
    association->hello = hello.bytes;
    association->lastHeard = now;
    association->dtls.setPeer(hello.from, hello.port);
    if (m_certificate) {
        prepareDtls(association->dtls, *m_certificate);
        association->nonce = randomKey();
        return association;
    }
    prepareDtls(association->dtls, m_hint);
    const auto onQuestion = [this,
                             peer = association.get()](QSslPreSharedKeyAuthenticator* question) {
        peer->identity = pskIdentity(question->identity().toStdString());
        peer->key = keyOf(peer->identity);
        peer->asked = true;
        answerPsk(*question, {}, peer->key.key);
    };
    QObject::connect(&association->dtls, &QDtls::pskRequired, &association->dtls, onQuestion);
    return association;
}

HostTransport::KeyAnswer HostTransport::keyOf(const std::optional<PskIdentity>& identity) const
{
    KeyAnswer answer = identity ? m_keyOf(*identity) : KeyAnswer{};
    // Nobody shall learn which identities there are: an unknown one just has a wrong key.
    if (answer.state != KeyAnswer::State::Known)
        answer.key = randomKey();
    return answer;
}

void HostTransport::goOn(Associations::iterator handshake, const RawDatagram& datagram,
                         TransportListener& listener, LocalTime now)
{
    Association& peer = *handshake->second;
    if (!peer.dtls.doHandshake(&m_socket, datagram.bytes)) {
        m_handshakes.erase(handshake);
        return;
    }
    if (peer.dtls.handshakeState() == QDtls::HandshakeComplete && m_certificate) {
        const auto challenge = encodeChallenge({m_hint.toStdString(), peer.nonce});
        peer.dtls.writeDatagramEncrypted(&m_socket, viewOf(challenge));
        return;
    }
    if (peer.dtls.handshakeState() == QDtls::HandshakeComplete)
        return proved(handshake, listener, now);
    if (!peer.asked || !holdsFinished(octets(datagram.bytes)))
        return;
    // A client sends all that its key makes in one datagram: what is not complete now has another
    // key. Where the right one is not derived yet, the client shall just try again.
    if (peer.key.state != KeyAnswer::State::NotYet) {
        const auto alert = wrongKeyAlert();
        m_socket.writeDatagram(reinterpret_cast<const char*>(alert.data()),
                               static_cast<qint64>(alert.size()), datagram.from, datagram.port);
    }
    m_handshakes.erase(handshake);
}

bool HostTransport::hearProof(Associations::iterator handshake, const RawDatagram& datagram,
                              TransportListener& listener, LocalTime now)
{
    Association& peer = *handshake->second;
    const QByteArray plain = peer.dtls.decryptDatagram(&m_socket, datagram.bytes);
    if (plain.isEmpty()) {
        if (!peer.dtls.isConnectionEncrypted())
            m_handshakes.erase(handshake);
        return false;
    }
    const auto proof = decodeProof(std::as_bytes(octets(plain)));
    if (!proof)
        return true; // nothing else is heard before it
    const KeyAnswer answer = keyOf(proof->identity);
    const bool taken = isProvedBy(*proof, answer.key, peer.nonce, m_digest)
                       && answer.state == KeyAnswer::State::Known;
    // Where the right key is not derived yet, the client shall just try again.
    if (answer.state != KeyAnswer::State::NotYet)
        peer.dtls.writeDatagramEncrypted(&m_socket, viewOf(encodeVerdict(taken)));
    peer.identity = proof->identity;
    peer.key = answer;
    if (taken)
        proved(handshake, listener, now);
    else
        m_handshakes.erase(handshake);
    return true;
}

void HostTransport::proved(Associations::iterator handshake, TransportListener& listener,
                           LocalTime now)
{
    const Endpoint from = handshake->first;
    std::unique_ptr<Association> peer = std::move(handshake->second);
    m_handshakes.erase(handshake);
    if (!hasHeldKey(*peer)) {
        peer->dtls.shutdown(&m_socket);
        return;
    }
    if (const auto before = m_paths.find(from); before != m_paths.end())
        drop(before, listener, now);
    if (m_paths.size() >= kMostPaths) { // the listener ends idle ones before
        peer->dtls.shutdown(&m_socket);
        return;
    }
    peer->address = ++m_lastAddress;
    peer->lastHeard = now;
    watch(now + kPathTimeout);
    m_byAddress.emplace(peer->address, peer.get());
    const Association& path = *m_paths.emplace(from, std::move(peer)).first->second;
    listener.cameFrom(sourcePrefix(from));
    listener.connected(path.address, path.identity->who, now);
}

bool HostTransport::hasHeldKey(const Association& peer) const
{
    // A handshake lasts as long as its client likes: meanwhile the code may have been changed, or
    // the token replaced.
    const KeyAnswer held = peer.identity ? m_keyOf(*peer.identity) : KeyAnswer{};
    return held.state == KeyAnswer::State::Known && peer.key == held;
}

void HostTransport::decrypt(Associations::iterator path, const RawDatagram& datagram,
                            TransportListener& listener, LocalTime now)
{
    Association& peer = *path->second;
    const QByteArray plain = peer.dtls.decryptDatagram(&m_socket, datagram.bytes);
    if (!plain.isEmpty()) {
        peer.lastHeard = now;
        listener.receive(peer.address, std::as_bytes(octets(plain)), now);
    } else if (!peer.dtls.isConnectionEncrypted()) {
        drop(path, listener, now);
    }
}

HostTransport::Associations::iterator
HostTransport::drop(Associations::iterator path, TransportListener& listener, LocalTime now)
{
    const PeerAddress address = path->second->address;
    m_byAddress.erase(address);
    const auto next = m_paths.erase(path);
    listener.disconnected(address, now);
    return next;
}

void HostTransport::dropSilent(TransportListener& listener, LocalTime now)
{
    if (now < m_nobodySilentBefore)
        return;
    m_nobodySilentBefore = LocalTime::max();
    const auto isSilent = [&](const Association& association, Duration timeout) {
        const LocalTime end = association.lastHeard + timeout;
        if (now < end)
            watch(end);
        return now >= end;
    };
    std::erase_if(m_handshakes,
                  [&](const auto& entry) { return isSilent(*entry.second, kHandshakeTimeout); });
    for (auto path = m_paths.begin(); path != m_paths.end();)
        path = isSilent(*path->second, kPathTimeout) ? drop(path, listener, now) : std::next(path);
}

} // namespace carina
