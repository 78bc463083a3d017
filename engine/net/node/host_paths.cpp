#include "engine/net/node/host_paths.h"

#include <algorithm>

namespace carina
{

void HostPaths::connected(PeerAddress path, const Credential& who, LocalTime now)
{
    endOldestIdle(who);
    m_paths.emplace(path, Path{who, now});
    m_nextLook = std::min(m_nextLook, now + kLook);
}

void HostPaths::idleFrom(PeerAddress path, LocalTime time)
{
    if (const auto known = m_paths.find(path); known != m_paths.end())
        known->second.idleSince = time;
}

bool HostPaths::hearsHello(PeerAddress path, LocalTime now)
{
    const auto known = m_paths.find(path);
    return known == m_paths.end() || known->second.hellos.take(1.0, kHellos, now);
}

bool HostPaths::hearsTokenRequest(PeerAddress path, LocalTime now)
{
    const auto known = m_paths.find(path);
    return known != m_paths.end() && known->second.tokenRequests.take(1.0, kTokenRequests, now);
}

void HostPaths::advance(LocalTime now)
{
    if (now < m_nextLook)
        return;
    m_nextLook = m_paths.empty() ? LocalTime::max() : now + kLook;
    for (auto& [address, path] : m_paths) {
        if (m_isInUse(address)) {
            path.idleSince = now;
        } else if (now >= path.idleSince + kHelloWithin) {
            m_ended.push_back(address);
            path.idleSince = now; // it is told as disconnected next
        } else {
            m_nextLook = std::min(m_nextLook, path.idleSince + kHelloWithin);
        }
    }
}

void HostPaths::endOldestIdle(const Credential& who)
{
    std::vector<PeerAddress> idle;
    for (const auto& [address, path] : m_paths)
        if (path.who == who && !m_isInUse(address))
            idle.push_back(address);
    if (idle.size() < (who.participant ? kMostIdleOfToken : kMostIdleOfCode))
        return;
    const PeerAddress oldest = *std::ranges::min_element(
        idle, {}, [this](PeerAddress address) { return m_paths.at(address).idleSince; });
    m_ended.push_back(oldest);
    m_paths.erase(oldest);
}

} // namespace carina
