#include "engine/net/node/host_paths.h"

#include "engine/session/participant_limits.h"

#include <algorithm>

namespace carina
{

void HostPaths::connected(PeerAddress path, const Credential& who, const SourcePrefix& from,
                          LocalTime now)
{
    endOldestIdle(who, from);
    m_paths.emplace(path, Path{who, from, now});
    m_nextLook = std::min(m_nextLook, now + kLook);
}

void HostPaths::idleFrom(PeerAddress path, LocalTime now)
{
    if (const auto known = m_paths.find(path); known != m_paths.end())
        known->second.idleSince = now;
}

bool HostPaths::hears(PeerAddress path, LocalTime now)
{
    const auto known = m_paths.find(path);
    if (known == m_paths.end() || m_isInUse(path))
        return true;
    if (!known->second.isEnded && known->second.datagrams.take(1.0, kIdleDatagrams, now))
        return true;
    end(path, known->second);
    return false;
}

std::shared_ptr<SharedBudget> HostPaths::sharedBudget(PeerAddress path)
{
    const auto known = m_paths.find(path);
    if (known == m_paths.end())
        return nullptr;
    const Role role = known->second.who.role;
    auto& shared = m_shared[{known->second.from, role}];
    if (shared)
        return shared;
    auto created = std::make_shared<SharedBudget>(sharedLimitsOf(role));
    shared = created;
    // Whose budget nobody has any more has nothing to remember.
    std::erase_if(m_shared, [&](const auto& entry) {
        return entry.second != created && entry.second.use_count() == 1;
    });
    return created;
}

SourcePrefix HostPaths::sourceOf(PeerAddress path) const
{
    const auto known = m_paths.find(path);
    return known == m_paths.end() ? SourcePrefix{} : known->second.from;
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
        if (!isIdle(address)) {
            path.idleSince = now;
        } else if (now >= path.idleSince + kHelloWithin) {
            end(address, path); // it is told as disconnected next
        } else {
            m_nextLook = std::min(m_nextLook, path.idleSince + kHelloWithin);
        }
    }
}

void HostPaths::endOldestIdle(const Credential& who, const SourcePrefix& from)
{
    std::vector<PeerAddress> idle;
    std::vector<PeerAddress> own;
    for (const auto& [address, path] : m_paths) {
        if (path.isEnded || !isIdle(address))
            continue;
        idle.push_back(address);
        if (path.who == who && path.from == from)
            own.push_back(address);
    }
    const std::size_t mostOwn = who.participant ? kMostIdleOfToken : kMostIdleOfCode;
    const auto endOldest = [this](const std::vector<PeerAddress>& of) {
        const PeerAddress oldest = *std::ranges::min_element(
            of, {}, [this](PeerAddress address) { return m_paths.at(address).idleSince; });
        end(oldest, m_paths.at(oldest));
    };
    if (own.size() >= mostOwn)
        endOldest(own);
    else if (idle.size() >= kMostIdle)
        endOldest(idle);
}

void HostPaths::end(PeerAddress address, Path& path)
{
    if (!std::exchange(path.isEnded, true))
        m_ended.push_back(address);
}

} // namespace carina
