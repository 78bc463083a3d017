#include "engine/net/secure/client_path.h"

#include "engine/net/secure/dtls_record.h"

#include <QNetworkProxy>
#include <QSslConfiguration>
#include <QSslPreSharedKeyAuthenticator>

namespace carina
{

namespace
{

// One serving reads no more than this.
constexpr int kReadPerTurn = 256;

} // namespace

ClientPath::ClientPath(const QHostAddress& host, std::uint16_t port, ClientCredentials& credentials,
                       const std::optional<ExpectedCertificate>& expected,
                       std::function<void()> onReadable, LocalTime now, HostPlace place,
                       const QHostAddress& from)
    : m_host{host},
      m_port{port},
      m_place{place},
      m_credentials{credentials},
      m_expected{expected},
      m_socket{new QUdpSocket},
      m_opened{now},
      m_lastHeard{now}
{
    m_socket->setProxy(QNetworkProxy::NoProxy);
    const bool isIpv4 = host.protocol() == QAbstractSocket::IPv4Protocol;
    m_socket->bind(!from.isNull()      ? from
                   : host.isLoopback() ? host
                   : isIpv4            ? QHostAddress{QHostAddress::AnyIPv4}
                                       : QHostAddress{QHostAddress::AnyIPv6},
                   0);
    QObject::connect(m_socket.get(), &QUdpSocket::readyRead, m_socket.get(), std::move(onReadable));
    QObject::connect(&m_dtls, &QDtls::pskRequired, &m_dtls,
                     [this](QSslPreSharedKeyAuthenticator* question) {
                         m_offer = offerFor(question->identityHint().toStdString());
                         if (m_offer)
                             answerPsk(*question, toText(m_offer->identity), m_offer->key);
                     });
    if (m_expected)
        prepareDtls(m_dtls, *m_expected);
    else
        prepareDtls(m_dtls, QByteArray{});
    m_dtls.setPeer(m_host, m_port, m_expected ? m_expected->name : QString{});
    if (!m_dtls.doHandshake(m_socket.get()))
        m_state = State::Failed;
}

void ClientPath::DeleteLater::operator()(QUdpSocket* socket) const
{
    socket->disconnect();
    socket->close();
    socket->deleteLater();
}

void ClientPath::serve(const std::function<void(std::span<const std::byte>, LocalTime)>& plain)
{
    for (int i = 0; i < kReadPerTurn && m_state != State::Failed; ++i) {
        const auto datagram = readRaw(*m_socket);
        if (!datagram)
            return;
        if (datagram->from != m_host || datagram->port != m_port
            || !firstRecord(octets(datagram->bytes)))
            continue;
        if (!m_dtls.isConnectionEncrypted()) {
            shakeHands(datagram->bytes, datagram->arrived);
            continue;
        }
        const QByteArray text = m_dtls.decryptDatagram(m_socket.get(), datagram->bytes);
        if (!text.isEmpty() && m_state == State::Opening) {
            proveItself(std::as_bytes(octets(text)), datagram->arrived);
        } else if (!text.isEmpty()) {
            m_lastHeard = datagram->arrived;
            plain(std::as_bytes(octets(text)), datagram->arrived);
        } else if (!m_dtls.isConnectionEncrypted()) {
            m_state = State::Failed;
        }
    }
}

void ClientPath::shakeHands(const QByteArray& datagram, LocalTime now)
{
    if (!m_roundTrip)
        m_roundTrip = now - m_opened;
    if (isWrongKeyAlert(octets(datagram))) {
        rejected();
        m_state = State::Failed;
        return;
    }
    if (!m_dtls.doHandshake(m_socket.get(), datagram)) {
        if (const auto fault = handshakeFault(datagram); fault && m_place == HostPlace::Told)
            m_credentials.turnedAway(*fault);
        m_state = State::Failed;
    } else if (m_dtls.isConnectionEncrypted() && !m_expected) {
        admitted(now);
    }
}

std::optional<Error> ClientPath::handshakeFault(const QByteArray& datagram) const
{
    if (m_dtls.dtlsError() == QDtlsError::PeerVerificationError)
        return certificateFault(m_dtls.peerVerificationErrors(), m_expected->name);
    if (!isNoCipherAlert(octets(datagram)))
        return std::nullopt;
    return m_expected ? Error{Errc::CertificateMissing, m_expected->name.toStdString()}
                      : Error{Errc::CertificateNeeded, {}};
}

void ClientPath::proveItself(std::span<const std::byte> asked, LocalTime now)
{
    if (const auto challenge = decodeChallenge(asked)) {
        m_offer = offerFor(challenge->sessionId);
        if (!m_offer) {
            m_dtls.shutdown(m_socket.get()); // the host need not wait for it
            m_state = State::Failed;
            return;
        }
        const auto host = digestOf(m_dtls.dtlsConfiguration().peerCertificate());
        const auto proof =
            encodeProof(proveRole(m_offer->identity, m_offer->key, challenge->nonce, host));
        m_dtls.writeDatagramEncrypted(m_socket.get(), viewOf(proof));
        return;
    }
    const auto taken = decodeVerdict(asked);
    if (!taken || !m_offer)
        return;
    if (*taken)
        return admitted(now);
    rejected();
    m_state = State::Failed;
}

std::optional<KeyOffer> ClientPath::offerFor(const std::string& session) const
{
    return m_place == HostPlace::Told ? m_credentials.offerFor(session)
                                      : m_credentials.offerToFound(session);
}

void ClientPath::rejected()
{
    if (m_offer && m_place == HostPlace::Told)
        m_credentials.rejected(*m_offer);
}

void ClientPath::admitted(LocalTime now)
{
    m_state = State::Encrypted;
    m_lastHeard = now;
    m_credentials.accepted(*m_offer);
}

void ClientPath::send(std::span<const std::byte> bytes)
{
    if (m_state == State::Encrypted)
        m_dtls.writeDatagramEncrypted(m_socket.get(), viewOf(bytes));
}

void ClientPath::close()
{
    if (m_state == State::Encrypted)
        m_dtls.shutdown(m_socket.get());
    m_state = State::Failed;
}

} // namespace carina
