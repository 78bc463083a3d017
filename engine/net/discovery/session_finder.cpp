#include "engine/net/discovery/session_finder.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/discovery/broadcast.h"
#include "engine/net/secure/dtls.h"

#include <QNetworkProxy>
#include <QRandomGenerator>

namespace carina
{
SessionFinder::SessionFinder(std::function<void()> onChange, std::uint16_t port)
    : m_onChange{std::move(onChange)}, m_port{port}, m_nonce{QRandomGenerator::system()->generate()}
{
    m_socket.setProxy(QNetworkProxy::NoProxy);
    // A computer without any network has no sessions to find: then nothing is ever heard.
    if (!m_socket.bind(QHostAddress{QHostAddress::AnyIPv4}, 0))
        return;
    QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { hear(); });
    QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { ask(); });
    m_timer.start(kAskEvery);
    ask();
}

void SessionFinder::lookFor(const SessionKey& session)
{
    m_known = session;
    ask();
}

void SessionFinder::ask()
{
    std::vector<std::vector<std::byte>> questions{encodeQuestion({.nonce = m_nonce})};
    if (m_known != SessionKey{})
        questions.push_back(encodeQuestion({m_nonce, m_known}));
    for (const QHostAddress& address : broadcastAddresses())
        for (const auto& question : questions)
            m_socket.writeDatagram(viewOf(question), address, m_port);
    if (m_found.forget(monotonicNow()))
        m_onChange();
}

void SessionFinder::hear()
{
    bool changed = false;
    while (const auto datagram = readRaw(m_socket))
        if (const auto notice = decodeAnswer(std::as_bytes(octets(datagram->bytes)), m_nonce))
            changed |= m_found.heard({*notice, datagram->from.toString().toStdString()},
                                     datagram->arrived);
    if (changed)
        m_onChange();
}

} // namespace carina
