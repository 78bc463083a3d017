#include "engine/sync/strategies/relayed_view.h"

namespace carina
{

void RelayedView::begin(const EventCpo& action, LocalTime start)
{
    ++m_revision;
    m_buffers.erase(action.object);
    m_running.insert_or_assign(action.object, Running{action, start});
}

void RelayedView::addSnapshot(const EventCpo& snapshot, LocalTime now)
{
    ++m_revision;
    m_running.erase(snapshot.object);
    m_buffers[snapshot.object].add(snapshot.start, evaluateAfter(snapshot, Duration{}), now);
}

void RelayedView::forget(ObjectId object)
{
    ++m_revision;
    m_running.erase(object);
    m_buffers.erase(object);
}

const EventCpo* RelayedView::running(ObjectId object) const
{
    const auto found = m_running.find(object);
    return found == m_running.end() ? nullptr : &found->second.action;
}

std::optional<ActedPose> RelayedView::at(ObjectId object, LocalTime t) const
{
    if (const auto buffered = m_buffers.find(object); buffered != m_buffers.end())
        return buffered->second.at(t);
    if (const auto running = m_running.find(object); running != m_running.end())
        return evaluateAfter(running->second.action, t - running->second.start);
    return std::nullopt;
}

} // namespace carina
