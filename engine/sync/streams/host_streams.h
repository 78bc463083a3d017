#pragma once

#include "engine/sync/streams/stream_slots.h"
#include "engine/sync/streams/stream_table.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/datagram.h"

#include <map>
#include <span>
#include <vector>

namespace carina
{

/// Who is sent streams, and of which station: of all for kAllStations.
struct StreamReader {
    ParticipantId participant;
    StationId station;
};

/// From where the samples of a participant come.
struct StreamSource {
    StreamPlace place{};
    /// Its objects need no slot, and are sent at each tick: those by which a patient is treated.
    bool isFirst = false;
};

/// The session host's end of streams: accepts samples from each object's owner (the host included),
/// and forwards the newest of each object at each tick to everybody else who is at its station, or
/// watches all.
///
/// What goes out to all together is limited. Where it would be more than kMostBytes in a second,
/// each object but those of the first is sent at every second, fourth, ... tick alone.
class HostStreams
{
public:
    /// Bytes of samples in a second to all receivers together, of a host with 100 Mbit/s: 8 MB/s
    /// are 64 Mbit/s, and the rest is for what is around the samples, facts and actions.
    static constexpr double kMostBytes = 8e6;
    /// From tick to tick of one object at most: 16 are 267 ms, within which it is not yet stale
    /// (StreamView::kStaleAfter). What exceeds kMostBytes nevertheless goes out.
    static constexpr unsigned kLargestThinning = 16;

    void share(ObjectId object, ParticipantId owner);
    /// The streams of a participant have ended.
    void leave(ParticipantId participant) { m_slots.leave(participant); }
    /// @returns whether the sample is accepted (StreamTable::accept), and thus forwarded.
    bool take(const StreamSample& sample, const StreamSource& from, SessionTime session);

    [[nodiscard]] bool isDue(LocalTime now) const;
    [[nodiscard]] LocalTime nextDue() const;
    /// Begins a tick: gathers what goes out. @pre isDue @param stations of all readers
    void gather(std::span<const StationId> stations);
    /// Records to send to a reader at this tick. @pre gather
    [[nodiscard]] std::vector<WireRecord> dueTo(const StreamReader& reader) const;
    /// Ends the tick: all participants were sent their records.
    void served(LocalTime now);

private:
    struct Outgoing {
        StreamSample sample;
        bool isFirst = false;
    };

    /// @returns whether an object is sent at this tick
    [[nodiscard]] bool isTurnOf(ObjectId object, bool isFirst) const
    {
        return isFirst || (m_ticks + object.value) % m_thinning == 0;
    }
    void chooseThinning(std::span<const StationId> stations);

    StreamTable m_table;
    StreamSlots m_slots;
    StreamTick m_tick;
    std::uint64_t m_ticks = 0;
    unsigned m_thinning = 1;                 // of so many ticks each object is sent at one
    std::map<ObjectId, Outgoing> m_outgoing; // the newest of each
    std::map<StationId, std::vector<StreamGroup>> m_groups; // of this tick
};

} // namespace carina
