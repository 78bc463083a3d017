#pragma once

#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/sequence_file.h"

namespace carina
{

/// How often a recording is played.
enum class Playing : std::uint8_t {
    Once,
    Looped, ///< from its beginning again, after a pause that is too long to interpolate over
};

/// A tracker that plays a recording at the speed of the recording: the time of a sample is
/// the session time of the start plus its time since the first sample of the recording. A tool's
/// history holds the newest poses and estimates their motion, as that of a device's tool.
class RecordedTracker : public Tracker
{
public:
    static constexpr Duration kPause = std::chrono::milliseconds{250}; ///< before a repetition

    RecordedTracker(const TrackerSequence& sequence, ReadSessionClock clock,
                    Playing playing = Playing::Once);

    /// Plays from the beginning; all histories are cleared first.
    [[nodiscard]] Result<void> start() override;
    void stop() override { m_thread.stop(); }
    [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tools; }

    /// One step of the thread: delivers what is due at `now`. The first call sets the start.
    /// @returns when the next sample is due; nothing at the end of a recording played once.
    /// @pre the thread is not running.
    std::optional<SessionTime> advance(SessionTime now);

private:
    struct Tool {
        PoseHistory history{PoseHistory::Limits{.estimates = true}};
    };
    struct Entry {
        Tool* tool = nullptr;
        PoseSample sample;
    };

    void rewind();

    Playing m_playing;
    std::deque<Tool> m_played; // one for each of m_tools; a history cannot be moved
    std::vector<TrackedTool> m_tools;
    std::vector<Entry> m_entries; // ascending in time
    std::size_t m_delivered = 0;
    std::optional<SessionTime> m_start;
    DeliveryThread m_thread; // last: ends before what it uses
};

} // namespace carina
