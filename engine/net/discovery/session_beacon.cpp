#include "engine/net/discovery/session_beacon.h"

#include "engine/net/discovery/loopback.h"
#include "engine/net/secure/dtls.h"
#include "engine/net/secure/endpoint.h"

#include <QNetworkProxy>

namespace carina
{

Result<std::unique_ptr<SessionBeacon>> SessionBeacon::open(const SessionNotice& notice, bool open,
                                                           std::uint16_t port, Announced announced)
{
    std::unique_ptr<SessionBeacon> beacon{new SessionBeacon{notice, announced}};
    QUdpSocket& socket = beacon->m_socket;
    socket.setProxy(QNetworkProxy::NoProxy);
    // Several hosts on one computer share the port: each gets what is broadcast.
    if (!socket.bind(open ? QHostAddress{QHostAddress::AnyIPv4} : loopbackBroadcast(), port,
                     QAbstractSocket::ShareAddress | QAbstractSocket::ReuseAddressHint))
        return fail(Errc::AddressInUse, std::to_string(port));
    QObject::connect(&socket, &QUdpSocket::readyRead, &socket,
                     [beacon = beacon.get()] { beacon->answer(); });
    return beacon;
}

void SessionBeacon::answer()
{
    while (const auto datagram = readRaw(m_socket)) {
        const auto question = decodeQuestion(std::as_bytes(octets(datagram->bytes)));
        const Endpoint from = endpoint(datagram->from, datagram->port);
        if (question && isMeant(*question)
            && m_limiter.admits(sourcePrefix(from), datagram->arrived))
            m_socket.writeDatagram(viewOf(encodeAnswer(question->nonce, m_notice)), datagram->from,
                                   datagram->port);
    }
}

bool SessionBeacon::isMeant(const SessionQuestion& question) const
{
    return question.session == m_notice.session
           || (m_announced == Announced::ToAll && question.session == SessionKey{});
}

} // namespace carina
