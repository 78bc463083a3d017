#include "engine/net/secure/client_transport.h"

#include "engine/net/entry/session_identity.h"
#include "engine/net/secure/endpoint.h"

#include <algorithm>

namespace carina
{

ClientTransport::ClientTransport(const QHostAddress& host, std::uint16_t port,
                                 ClientCredentials& credentials, LocalTime now,
                                 std::optional<ExpectedCertificate> expected,
                                 std::uint16_t discoveryPort, QHostAddress from)
    : m_host{normalised(host)},
      m_port{port},
      m_from{std::move(from)},
      m_credentials{credentials},
      m_expected{std::move(expected)},
      m_discoveryPort{discoveryPort},
      m_lastAlive{now},
      m_nextTry{now}
{
    m_credentials.onChange([this] {
        m_nextTry = LocalTime::min();
        tellNews();
    });
}

ClientTransport::~ClientTransport() { m_credentials.onChange({}); }

void ClientTransport::serve(TransportListener& listener, LocalTime now)
{
    if (m_path)
        servePath(listener, now);
    serveTries(listener, now);
    serveSearch(listener, now);
    if (const auto& refusal = m_credentials.refusal(); refusal && !m_toldRefusal) {
        m_toldRefusal = true;
        m_opening.clear();
        m_found.clear();
        m_search.reset();
        listener.refused(*refusal, now);
    }
    if (needsPath(now) && now >= m_nextTry && m_credentials.mayTry())
        beginTry(now);
}

void ClientTransport::servePath(TransportListener& listener, LocalTime now)
{
    const LocalTime heard = m_path->lastHeard();
    m_path->serve([&](std::span<const std::byte> bytes, LocalTime arrived) {
        listener.receive(m_address, bytes, arrived);
    });
    if (m_path->state() == ClientPath::State::Failed) {
        m_path.reset();
        m_nextTry = now;
        listener.disconnected(m_address, now);
    } else if (m_path->lastHeard() > heard) {
        m_opening.clear(); // it lives after all
    }
}

void ClientTransport::serveTries(TransportListener& listener, LocalTime now)
{
    for (auto& path : m_opening) {
        path->serve([](auto, auto) {});
        m_roundTrip = path->roundTrip().value_or(m_roundTrip);
        if (path->roundTrip() && m_credentials.session().empty())
            m_lastAlive = now; // somebody is there: whose session it is shows in the handshake
        if (path->state() == ClientPath::State::Encrypted)
            return take(std::move(path), listener, now);
    }
    std::erase_if(m_opening,
                  [](const auto& path) { return path->state() == ClientPath::State::Failed; });
}

void ClientTransport::serveSearch(TransportListener& listener, LocalTime now)
{
    if (m_path)
        m_lastAlive = std::max(m_lastAlive, m_path->lastHeard());
    if (!needsSearch(now)) {
        m_found.clear();
        m_search.reset();
        return;
    }
    if (!m_search)
        m_search = std::make_unique<SessionSearch>(
            sessionKey(m_credentials.sought()), [this] { tellNews(); }, m_discoveryPort);
    for (auto& path : m_found) {
        path->serve([](auto, auto) {});
        if (path->state() == ClientPath::State::Encrypted) {
            moveTo(*path);
            return take(std::move(path), listener, now);
        }
    }
    std::erase_if(m_found, [now](const auto& path) {
        return path->state() == ClientPath::State::Failed || now >= path->opened() + kFoundTry;
    });
    tryFound(now);
}

bool ClientTransport::needsSearch(LocalTime now) const
{
    return needsPath(now) && now >= m_lastAlive + kSearchAfter && m_credentials.mayTry()
           && !m_credentials.sought().empty();
}

void ClientTransport::tryFound(LocalTime now)
{
    while (m_found.size() < kMostTries) {
        const auto place = m_search->take();
        if (!place)
            return;
        if (place->address == m_host && place->port == m_port)
            continue; // is being tried
        m_found.push_back(std::make_unique<ClientPath>(
            place->address, place->port, m_credentials, m_expected, [this] { tellNews(); }, now,
            HostPlace::Found));
    }
}

void ClientTransport::moveTo(const ClientPath& path)
{
    m_host = path.host();
    m_port = path.hostPort();
    if (m_onMoved)
        m_onMoved(m_host.toString().toStdString(), m_port);
}

void ClientTransport::take(std::unique_ptr<ClientPath> path, TransportListener& listener,
                           LocalTime now)
{
    if (m_path)
        listener.disconnected(m_address, now);
    m_path = std::move(path);
    m_opening.clear();
    m_found.clear();
    m_search.reset();
    m_nextTry = now;
    m_unfinished = 0;
    listener.connected(++m_address, m_path->offer()->identity.who, now);
}

bool ClientTransport::needsPath(LocalTime now) const
{
    return !m_path || now >= m_path->lastHeard() + kSilence;
}

void ClientTransport::beginTry(LocalTime now)
{
    if (m_opening.size() >= kMostTries) {
        m_unfinished += m_opening.front()->roundTrip() ? 1 : 0;
        m_opening.erase(m_opening.begin());
    }
    m_opening.push_back(std::make_unique<ClientPath>(
        m_host, m_port, m_credentials, m_expected, [this] { tellNews(); }, now, HostPlace::Told,
        m_from));
    ++m_tries;
    m_nextTry = now + untilNextTry();
}

Duration ClientTransport::untilNextTry() const
{
    const Duration shortest = m_unfinished < kEagerTries ? kShortestTry : kPatientTry;
    return std::max(shortest, kTryRoundTrips * m_roundTrip);
}

LocalTime ClientTransport::nextWake() const
{
    const auto hasMore = [](const auto& path) { return path->hasMore(); };
    if ((m_path && m_path->hasMore()) || std::ranges::any_of(m_opening, hasMore)
        || std::ranges::any_of(m_found, hasMore))
        return LocalTime::min();
    if (!m_credentials.mayTry())
        return LocalTime::max();
    return m_path ? std::max(m_path->lastHeard() + kSilence, m_nextTry) : m_nextTry;
}

void ClientTransport::send(PeerAddress to, std::span<const std::byte> bytes)
{
    if (m_path && to == m_address)
        m_path->send(bytes);
}

void ClientTransport::close()
{
    m_opening.clear();
    m_found.clear();
    m_search.reset();
    if (m_path)
        m_path->close();
    m_path.reset();
}

} // namespace carina
