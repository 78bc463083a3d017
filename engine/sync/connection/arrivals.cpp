#include "engine/sync/connection/arrivals.h"

#include "engine/sync/wire/sequence.h"

#include <algorithm>

namespace carina
{

bool Arrivals::hears(PeerAddress from, const BundleHeader& header, const Hello& hello,
                     LocalTime now)
{
    const auto found = m_arrivals.find(from);
    if (found == m_arrivals.end())
        return false;
    Arrival& known = found->second;
    if (known.hello.join.id == hello.join.id
        && !isAfter(known.header.connection, header.connection))
        known = {header, now, hello, known.admission};
    return true;
}

void Arrivals::add(PeerAddress from, const Arrival& arrival)
{
    forget(arrival.admission.participant);
    m_arrivals.emplace(from, arrival);
}

void Arrivals::forget(ParticipantId participant)
{
    std::erase_if(m_arrivals, [participant](const auto& entry) {
        return entry.second.admission.participant == participant;
    });
}

std::optional<ParticipantId> Arrivals::drop(PeerAddress from)
{
    const auto arrival = m_arrivals.extract(from);
    return arrival ? std::optional{arrival.mapped().admission.participant} : std::nullopt;
}

std::map<PeerAddress, Arrival> Arrivals::takeWaitingFor(FactNumber joined)
{
    std::map<PeerAddress, Arrival> taken;
    for (auto entry = m_arrivals.begin(); entry != m_arrivals.end();) {
        const auto next = std::next(entry);
        if (entry->second.admission.joined == joined)
            taken.insert(m_arrivals.extract(entry));
        entry = next;
    }
    return taken;
}

std::optional<PeerAddress> Arrivals::stored(FactNumber logEnd) const
{
    const auto found = std::ranges::find_if(m_arrivals, [logEnd](const auto& entry) {
        return entry.second.admission.joined <= logEnd;
    });
    return found == m_arrivals.end() ? std::nullopt : std::optional{found->first};
}

bool Arrivals::isHere(ParticipantId participant) const
{
    return std::ranges::any_of(m_arrivals, [participant](const auto& entry) {
        return entry.second.admission.participant == participant;
    });
}

bool Arrivals::keepsOut(PeerAddress from, const Identity& who, ProposalId join, Duration held,
                        LocalTime now) const
{
    return std::ranges::any_of(m_arrivals, [&](const auto& entry) {
        const auto& [address, arrival] = entry;
        const bool isSameRun = who.isProven && arrival.hello.join.id == join;
        return address != from && arrival.admission.participant == who.participant && !isSameRun
               && now < arrival.heard + held;
    });
}

} // namespace carina
