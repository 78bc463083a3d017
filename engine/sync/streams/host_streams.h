#pragma once

#include "engine/sync/streams/stream_slots.h"
#include "engine/sync/streams/stream_table.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/datagram.h"

#include <cstddef>
#include <map>
#include <optional>
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
/// those of the first go out at each tick, and of the others those that have waited longest.
class HostStreams
{
public:
    /// Bytes of samples in a second to all receivers together, of a host with 100 Mbit/s: 8 MB/s
    /// are 64 Mbit/s, and the rest is for what is around the samples, facts and actions.
    static constexpr double kMostBytes = 8e6;
    /// From one sample of an object that goes out to the next, while there are any: at the tick
    /// nearest to it at the latest. What exceeds kMostBytes nevertheless goes out, at each tick a
    /// quarter of those that wait.
    static constexpr std::ptrdiff_t kLongestWaitInTicks = 4;
    static constexpr Duration kLongestWait = kLongestWaitInTicks * StreamTick::kPeriod;

    void share(ObjectId object, ParticipantId owner);
    /// The streams of a participant have ended.
    void leave(ParticipantId participant);
    /// @returns whether the sample is accepted (StreamTable::accept), and thus forwarded.
    bool take(const StreamSample& sample, const StreamSource& from, SessionTime session);

    /// Whether samples wait, and a tick is due.
    [[nodiscard]] bool isDue(LocalTime now) const;
    [[nodiscard]] LocalTime nextDue() const;
    /// Of a tick, whether samples wait or not.
    [[nodiscard]] LocalTime nextTick() const { return m_tick.next(); }
    /// Begins a tick: gathers what goes out. @pre isDue @param stations of all readers
    void gather(std::span<const StationId> stations, LocalTime now);
    /// Records to send to a reader at this tick. @pre gather
    [[nodiscard]] std::vector<WireRecord> dueTo(const StreamReader& reader) const;
    /// Ends the tick: all participants were sent their records.
    void served(LocalTime now);

private:
    struct Outgoing {
        std::optional<StreamSample> newest; ///< that has not gone out
        ParticipantId owner;
        bool isFirst = false;
        LocalTime wentOut{}; ///< its last sample that did
    };
    using Entry = std::pair<const ObjectId, Outgoing>;

    /// Those with a sample: of the first, then of the others the one that waits longest.
    [[nodiscard]] std::vector<Entry*> inTurn();
    /// Adds what may go out since the last tick.
    void earn(LocalTime now);

    StreamTable m_table;
    StreamSlots m_slots;
    StreamTick m_tick;
    std::map<ObjectId, Outgoing> m_outgoing;
    std::size_t m_waiting = 0; // of these with a sample
    double m_mayGoOut = 0.0;   // bytes
    LocalTime m_earnedUntil{};
    std::map<StationId, std::vector<StreamGroup>> m_groups; // of this tick
};

} // namespace carina
