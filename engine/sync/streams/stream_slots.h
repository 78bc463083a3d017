#pragma once

#include "engine/core/ids.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace carina
{

/// Those whose streams count together: all of one address, or one participant by itself. Only
/// whether two are the same matters.
using StreamPlace = std::pair<std::uintptr_t, ParticipantId>;

/// Which objects may be streamed. Every sample goes to everybody at the station, and everybody
/// keeps a history of the object, so that the host has to say how many there are.
///
/// An object has a slot from its first sample until its owner goes or changes. Where a station is
/// full, who has fewer slots there gets one of whoever has most: one who brings many objects keeps
/// out nobody from elsewhere.
class StreamSlots
{
public:
    /// Of a station: 12 people, each with head, jaw, tube, stylus and laryngoscope.
    static constexpr std::size_t kMostOfStation = 64;
    /// Of a place, at all stations: 16 at each of eight.
    static constexpr std::size_t kMostOfPlace = 128;

    /// Whether the object may be streamed from this place; it has a slot then.
    [[nodiscard]] bool takes(ObjectId object, StationId station, ParticipantId owner,
                             const StreamPlace& place);
    /// The object has this owner; the slot of another is free.
    void owned(ObjectId object, ParticipantId owner);
    /// The participant is gone, and its slots are free.
    void leave(ParticipantId owner);

private:
    struct Slot {
        StationId station;
        ParticipantId owner;
        StreamPlace place;
    };
    /// The objects of each place, in the order in which they came.
    using Places = std::map<StreamPlace, std::vector<ObjectId>>;
    struct Station {
        Places places;
        std::size_t taken = 0;
    };

    /// Frees a slot at a full station for one who has fewer. @returns whether there was one
    bool makeRoom(Station& station, const StreamPlace& place);
    void release(ObjectId object);

    std::map<ObjectId, Slot> m_slots;
    std::map<StationId, Station> m_stations;
    std::map<StreamPlace, std::size_t> m_ofPlace;
};

} // namespace carina
