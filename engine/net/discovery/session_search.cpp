#include "engine/net/discovery/session_search.h"

#include "engine/net/discovery/broadcast.h"
#include "engine/net/secure/dtls.h"

#include <QNetworkProxy>
#include <QRandomGenerator>

#include <algorithm>

namespace carina
{
namespace
{

/// An index below the size.
std::size_t anyOf(std::size_t size)
{
    return QRandomGenerator::system()->bounded(static_cast<quint32>(size));
}

} // namespace

SessionSearch::SessionSearch(const SessionKey& session, std::function<void()> onAnswer,
                             std::uint16_t port)
    : m_question{.nonce = QRandomGenerator::system()->generate(), .session = session},
      m_onAnswer{std::move(onAnswer)},
      m_port{port}
{
    m_socket.setProxy(QNetworkProxy::NoProxy);
    // A computer without any network has nothing to find: then nothing is ever heard.
    if (!m_socket.bind(QHostAddress{QHostAddress::AnyIPv4}, 0))
        return;
    QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { hear(); });
    m_timer.callOnTimeout([this] { ask(); });
    m_timer.start(kAskEvery);
    ask();
}

std::optional<SessionSearch::Place> SessionSearch::take()
{
    if (m_places.empty())
        return std::nullopt;
    std::swap(m_places[anyOf(m_places.size())], m_places.back());
    const Place any = m_places.back();
    m_places.pop_back();
    return any;
}

void SessionSearch::ask()
{
    const auto question = encodeQuestion(m_question);
    for (const QHostAddress& address : broadcastAddresses())
        m_socket.writeDatagram(viewOf(question), address, m_port);
}

void SessionSearch::hear()
{
    bool isNews = false;
    while (const auto datagram = readRaw(m_socket)) {
        const auto notice = decodeAnswer(std::as_bytes(octets(datagram->bytes)), m_question.nonce);
        if (!notice || notice->session != m_question.session)
            continue;
        isNews |= keep({datagram->from, notice->port});
    }
    if (isNews) // later: the callback may end this search
        QTimer::singleShot(0, &m_timer, m_onAnswer);
}

/// @returns whether it waits now and did not before.
bool SessionSearch::keep(const Place& place)
{
    if (std::ranges::find(m_places, place) != m_places.end())
        return false;
    if (m_places.size() < kMost)
        m_places.push_back(place);
    else
        m_places[anyOf(kMost)] = place;
    return true;
}

} // namespace carina
