#include "engine/net/objects/remote_objects.h"

namespace carina
{

void RemoteObjects::add(ObjectId object, ParticipantId owner, StationId station)
{
    const std::scoped_lock lock{m_mutex};
    Object& entry = m_objects[object];
    if (!entry.poses || entry.station != station)
        entry.poses = std::make_shared<RemoteObject>();
    entry.owner = owner;
    entry.station = station;
}

void RemoteObjects::remove(ObjectId object)
{
    const std::scoped_lock lock{m_mutex};
    if (m_objects.erase(object) > 0) // what it sends of an own one stays counted
        m_analysis.forget(object);
}

void RemoteObjects::clear()
{
    const std::scoped_lock lock{m_mutex};
    m_objects.clear();
    m_analysis.clear();
    m_nextLook = SessionTime::min();
}

void RemoteObjects::forgetPasts(SessionTime drawn)
{
    if (drawn < m_nextLook)
        return;
    m_nextLook = drawn + kLook;
    for (const auto& [id, object] : m_objects)
        object.poses->forgetPast(drawn - kPastKept);
}

void RemoteObjects::take(const StreamSample& sample, SessionTime drawn)
{
    const std::scoped_lock lock{m_mutex};
    forgetPasts(drawn);
    const StreamCpo& cpo = sample.cpo;
    const auto found = m_objects.find(cpo.object);
    if (found == m_objects.end() || found->second.station != sample.station)
        return;
    found->second.poses->take(cpo, drawn);
    m_analysis.acted(found->second.owner, cpo.object, cpo.time);
}

void RemoteObjects::sent(ParticipantId self, const StreamCpo& cpo)
{
    const std::scoped_lock lock{m_mutex};
    m_analysis.acted(self, cpo.object, cpo.time);
}

ApplicationAnalysis RemoteObjects::analysis() const
{
    const std::scoped_lock lock{m_mutex};
    return m_analysis;
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
        if (const auto newest = object.poses->newest()) {
            reports.push_back({id, now - newest->time});
            if (newest->motion && newest->validity != Validity::Lost) {
                reports.back().turnDegPerS = inDegrees(radians(newest->motion->w_FO.norm()));
                reports.back().moveMmPerS = inMillimetres(metres(newest->motion->v_FO.norm()));
            }
        }
    return reports;
}

} // namespace carina
