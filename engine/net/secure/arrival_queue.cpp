#include "engine/net/secure/arrival_queue.h"

#include <algorithm>

namespace carina
{
namespace
{

/// In whose place all strangers stand that are not told apart.
constexpr Endpoint kOthers{};

} // namespace

void ArrivalQueue::add(const Endpoint& from, RawDatagram datagram, bool isKnown)
{
    const bool isApart = isKnown || m_strangers < kMostStrangers || m_sources.contains(from);
    const Endpoint& place = isApart ? from : kOthers;
    if (m_size >= kMost)
        dropOldest(sourceToDropFor(place));
    const auto [entry, isNew] = m_sources.try_emplace(place);
    Source& source = entry->second;
    if (isNew) {
        m_turns.push_back(place);
        source.isStranger = !isKnown && isApart;
        m_strangers += source.isStranger ? 1 : 0;
    } else if (source.waiting.size() >= kMostOfOne) {
        dropOldest(source);
    }
    source.waiting.push_back(std::move(datagram));
    ++m_size;
}

std::optional<RawDatagram> ArrivalQueue::next()
{
    while (!m_turns.empty()) {
        const Endpoint place = m_turns.front();
        m_turns.pop_front();
        const auto entry = m_sources.find(place);
        std::deque<RawDatagram>& waiting = entry->second.waiting;
        std::optional<RawDatagram> datagram;
        if (!waiting.empty()) {
            datagram = std::move(waiting.front());
            waiting.pop_front();
            --m_size;
        }
        if (waiting.empty()) {
            m_strangers -= entry->second.isStranger ? 1 : 0;
            m_sources.erase(entry);
        } else {
            m_turns.push_back(place);
        }
        if (datagram)
            return datagram;
    }
    return std::nullopt;
}

void ArrivalQueue::clear()
{
    m_sources.clear();
    m_turns.clear();
    m_strangers = 0;
    m_size = 0;
}

ArrivalQueue::Source& ArrivalQueue::sourceToDropFor(const Endpoint& place)
{
    // One that has its share already pays itself: so in a flood nobody is looked for.
    if (const auto own = m_sources.find(place);
        own != m_sources.end() && own->second.waiting.size() * m_sources.size() >= kMost)
        return own->second;
    return std::ranges::max_element(m_sources, {},
                                    [](const auto& entry) { return entry.second.waiting.size(); })
        ->second;
}

void ArrivalQueue::dropOldest(Source& source)
{
    source.waiting.pop_front();
    --m_size;
}

} // namespace carina
