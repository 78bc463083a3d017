#include "engine/sync/streams/stream_slots.h"

#include <algorithm>

namespace carina
{

bool StreamSlots::takes(ObjectId object, StationId station, ParticipantId owner,
                        const StreamPlace& place)
{
    if (const auto known = m_slots.find(object); known != m_slots.end()) {
        const Slot& slot = known->second;
        if (slot.station == station && slot.owner == owner && slot.place == place)
            return true;
        release(object);
    }
    if (const auto own = m_ofPlace.find(place);
        own != m_ofPlace.end() && own->second >= kMostOfPlace)
        return false;
    Station& there = m_stations[station];
    if (there.taken >= kMostOfStation && !makeRoom(there, place))
        return false;
    m_slots.emplace(object, Slot{station, owner, place});
    there.places[place].push_back(object);
    ++there.taken;
    ++m_ofPlace[place];
    return true;
}

void StreamSlots::owned(ObjectId object, ParticipantId owner)
{
    if (const auto slot = m_slots.find(object);
        slot != m_slots.end() && slot->second.owner != owner)
        release(object);
}

void StreamSlots::leave(ParticipantId owner)
{
    std::vector<ObjectId> left;
    for (const auto& [object, slot] : m_slots)
        if (slot.owner == owner)
            left.push_back(object);
    for (const ObjectId object : left)
        release(object);
}

bool StreamSlots::makeRoom(Station& station, const StreamPlace& place)
{
    const auto number = [](const auto& entry) { return entry.second.size(); };
    const auto fullest = std::ranges::max_element(station.places, {}, number);
    const auto own = station.places.find(place);
    const std::size_t owned = own == station.places.end() ? 0 : number(*own);
    // With one less it still has as many as the other then has.
    if (fullest == station.places.end() || number(*fullest) < owned + 2)
        return false;
    release(fullest->second.back());
    return true;
}

void StreamSlots::release(ObjectId object)
{
    const auto found = m_slots.find(object);
    const Slot slot = found->second;
    m_slots.erase(found);
    Station& station = m_stations.at(slot.station);
    std::vector<ObjectId>& objects = station.places.at(slot.place);
    std::erase(objects, object);
    if (objects.empty())
        station.places.erase(slot.place);
    --station.taken;
    if (--m_ofPlace.at(slot.place) == 0)
        m_ofPlace.erase(slot.place);
}

} // namespace carina
