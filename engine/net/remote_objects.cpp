#include "engine/net/remote_objects.h"

namespace carina
{

void RemoteObjects::add(ObjectId object)
{
    const std::scoped_lock lock{m_mutex};
    if (!m_objects.contains(object))
        m_objects.emplace(object, Object{std::make_shared<RemoteObject>()});
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

void RemoteObjects::take(const StreamCpo& cpo, SessionTime drawn)
{
    const std::scoped_lock lock{m_mutex};
    const auto found = m_objects.find(cpo.object);
    if (found == m_objects.end())
        return;
    if (const auto drift = found->second.poses->take(cpo, drawn))
        found->second.drift = *drift;
}

std::shared_ptr<const RemoteObject> RemoteObjects::find(ObjectId object) const
{
    const std::scoped_lock lock{m_mutex};
    const auto found = m_objects.find(object);
    return found == m_objects.end() ? nullptr : found->second.poses;
}

std::vector<ObjectReport> RemoteObjects::reports(SessionTime now) const
{
    const std::scoped_lock lock{m_mutex};
    std::vector<ObjectReport> reports;
    for (const auto& [id, object] : m_objects)
        if (const auto newest = object.poses->newest())
            reports.push_back({id, now - newest->time, inDegrees(object.drift.rotation),
                               inMillimetres(object.drift.position)});
    return reports;
}

} // namespace carina
