#include "engine/tracking/record/recorded_tracker.h"

#include <algorithm>
#include <utility>

namespace carina
{

RecordedTracker::RecordedTracker(const TrackerSequence& sequence, ReadSessionClock clock,
                                 Playing playing)
    : m_playing{playing}, m_thread{std::move(clock), [this](SessionTime now) {
                                       return advance(now);
                                   }}
{
    for (const RecordedTool& tool : sequence.tools) {
        Tool& played = m_played.emplace_back();
        m_tools.push_back({tool.name, tool.role, &played.history});
        for (const PoseSample& sample : tool.samples)
            m_entries.push_back({&played, sample});
    }
    std::ranges::stable_sort(m_entries, {}, [](const Entry& entry) { return entry.sample.time; });
}

Result<void> RecordedTracker::start()
{
    stop();
    for (Tool& tool : m_played)
        tool.history.clear();
    m_delivered = 0;
    m_start.reset();
    return m_thread.start();
}

/// To the beginning, after the pause.
void RecordedTracker::rewind()
{
    m_start = *m_start + (m_entries.back().sample.time - m_entries.front().sample.time) + kPause;
    m_delivered = 0;
}

std::optional<SessionTime> RecordedTracker::advance(SessionTime now)
{
    if (!m_start)
        m_start = now;
    for (;; ++m_delivered) {
        if (m_delivered == m_entries.size()) {
            if (m_playing == Playing::Once || m_entries.empty())
                return std::nullopt;
            rewind();
        }
        Entry entry = m_entries[m_delivered];
        entry.sample.time = *m_start + (entry.sample.time - m_entries.front().sample.time);
        if (entry.sample.time > now)
            return entry.sample.time;
        entry.tool->history.push(entry.sample);
    }
}

} // namespace carina
