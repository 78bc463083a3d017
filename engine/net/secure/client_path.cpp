#include "engine/net/secure/client_path.h"

#include "engine/net/secure/dtls_record.h"

#include <QNetworkProxy>
#include <QSslPreSharedKeyAuthenticator>

namespace carina
{

namespace
{

// One serving reads no more than this.
constexpr int kReadPerTurn = 256;

} // namespace

ClientPath::ClientPath(const QHostAddress& host, std::uint16_t port, ClientCredentials& credentials,
                       std::function<void()> onReadable, LocalTime now)
    : m_host{host},
      m_port{port},
      m_credentials{credentials},
      m_socket{new QUdpSocket},
      m_opened{now},
      m_lastHeard{now}
{
    m_socket->setProxy(QNetworkProxy::NoProxy);
    const bool isIpv4 = host.protocol() == QAbstractSocket::IPv4Protocol;
    m_socket->bind(host.isLoopback() ? host
                   : isIpv4          ? QHostAddress{QHostAddress::AnyIPv4}
                                     : QHostAddress{QHostAddress::AnyIPv6},
                   0);
    QObject::connect(m_socket.get(), &QUdpSocket::readyRead, m_socket.get(), std::move(onReadable));
    QObject::connect(&m_dtls, &QDtls::pskRequired, &m_dtls,
                     [this](QSslPreSharedKeyAuthenticator* question) {
                         m_offer = m_credentials.offerFor(question->identityHint().toStdString());
                         if (m_offer)
                             answerPsk(*question, toText(m_offer->identity), m_offer->key);
                     });
    prepareDtls(m_dtls, {});
    m_dtls.setPeer(m_host, m_port);
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
        if (m_state == State::Opening) {
            shakeHands(datagram->bytes, datagram->arrived);
            continue;
        }
        const QByteArray text = m_dtls.decryptDatagram(m_socket.get(), datagram->bytes);
        if (!text.isEmpty()) {
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
        if (m_offer)
            m_credentials.rejected(*m_offer);
        m_state = State::Failed;
        return;
    }
    if (!m_dtls.doHandshake(m_socket.get(), datagram))
        m_state = State::Failed;
    else if (m_dtls.isConnectionEncrypted()) {
        m_state = State::Encrypted;
        m_lastHeard = now;
        m_credentials.accepted(*m_offer);
    }
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
