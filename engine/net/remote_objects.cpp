#include "engine/net/remote_objects.h"

#include "engine/net/pose_stream.h"

namespace carina
{

void RemoteObjects::add(ObjectId object)
{
    const std::scoped_lock lock{m_mutex};
    PoseHistory::Limits limits;
    limits.horizon = kStaleAfter;
    if (!m_objects.contains(object))
        m_objects.emplace(object, Object{std::make_shared<PoseHistory>(limits)});
}

void RemoteObjects::remove(ObjectId object)
{
    const std::scoped_lock lock{m_mutex};
    m_objects.erase(object);
}

void RemoteObjects::clear()
{
    const std::scoped_lock lock{m_mutex};
    m_objects.clear();
}

void RemoteObjects::take(const StreamCpo& cpo)
{
    const std::scoped_lock lock{m_mutex};
    const auto found = m_objects.find(cpo.object);
    if (found == m_objects.end())
        return;
    Object& object = found->second;
    const auto shown = object.history->at(cpo.time);
    if (shown && shown->validity != Validity::Lost && cpo.validity != StreamValidity::Lost)
        object.drift = driftBetween(cpo.X_AO, shown->X_FO);
    object.history->push(fromStream(cpo));
}

std::shared_ptr<const PoseHistory> RemoteObjects::history(ObjectId object) const
{
    const std::scoped_lock lock{m_mutex};
    const auto found = m_objects.find(object);
    return found == m_objects.end() ? nullptr : found->second.history;
}

std::vector<ObjectReport> RemoteObjects::reports(SessionTime now) const
{
    const std::scoped_lock lock{m_mutex};
    std::vector<ObjectReport> reports;
    for (const auto& [id, object] : m_objects)
        if (const auto newest = object.history->newest())
            reports.push_back({id, now - newest->time, inDegrees(object.drift.rotation),
                               inMillimetres(object.drift.position)});
    return reports;
}

} // namespace carina
