#include "engine/net/objects/publications.h"

#include "engine/net/objects/pose_stream.h"
#include "engine/sync/streams/shape_view.h"

#include <algorithm>
#include <utility>

namespace carina
{

void Publications::add(ObjectKind kind, std::string name, PoseSource newest)
{
    m_publications.push_back({kind, std::move(name), std::move(newest)});
}

void Publications::bend(ObjectKind kind, ShapeSource shape)
{
    m_shapes.insert_or_assign(kind, std::move(shape));
}

std::vector<Publications::Wanted> Publications::takeUnknown(const SessionState& state,
                                                            ParticipantId self)
{
    const StationId station = state.stationOf(self);
    if (station == kNoStation)
        return {}; // the fact of its own coming is still on its way
    std::vector<Wanted> wanted;
    for (Publication& publication : m_publications) {
        if (publication.toldOf || idOf(publication, state, self))
            continue;
        publication.toldOf = true;
        wanted.push_back({station, {ObjectId{}, self, publication.kind, publication.name}});
    }
    return wanted;
}

void Publications::forget()
{
    for (Publication& publication : m_publications) {
        publication.toldOf = false;
        publication.lastSent = SessionTime::min();
        publication.sent->clear();
    }
}

LocalTime Publications::nextTick() const
{
    return m_publications.empty() ? LocalTime::max() : m_tick.next();
}

std::vector<Publications::Outgoing> Publications::sample(const SessionState& state,
                                                         ParticipantId self, LocalTime now)
{
    std::vector<Outgoing> samples;
    if (m_publications.empty() || !m_tick.isDue(now))
        return samples;
    m_tick.served(now);
    const StationId station = state.stationOf(self);
    for (Publication& publication : m_publications) {
        if (std::exchange(publication.sentAt, station) != station)
            publication.sent->clear(); // in the frame of another patient
        const auto id = idOf(publication, state, self);
        const auto newest = id ? publication.newest() : std::nullopt;
        if (!newest || newest->time <= publication.lastSent)
            continue;
        publication.lastSent = newest->time;
        publication.sent->push(*newest);
        StreamCpo cpo = toStream(*newest);
        cpo.object = *id;
        cpo.sequence = ++publication.sequence;
        if (cpo.validity != StreamValidity::Lost)
            cpo.shape = shapeOf(publication.kind, cpo.time);
        samples.push_back({station, cpo});
    }
    return samples;
}

std::optional<StreamShape> Publications::shapeOf(ObjectKind kind, SessionTime ofSample) const
{
    const auto source = m_shapes.find(kind);
    auto shape = source == m_shapes.end() ? std::nullopt : source->second();
    if (!shape || ofSample - shape->time > ShapeView::kLongestGap)
        return std::nullopt;
    shape->time = std::min(shape->time, ofSample); // it may know a later pose
    return shape;
}

std::optional<RigidTransform> Publications::measured(ObjectId object, const SessionState& state,
                                                     ParticipantId self, SessionTime t) const
{
    for (const Publication& publication : m_publications)
        if (idOf(publication, state, self) == object)
            if (const auto pose = publication.sent->at(t);
                pose && pose->validity != Validity::Lost && pose->how != How::Predicted)
                return pose->X_FO;
    return std::nullopt;
}

std::optional<ObjectId> Publications::idOf(const Publication& publication,
                                           const SessionState& state, ParticipantId self)
{
    const auto found = std::ranges::find_if(state.objects(), [&](const auto& entry) {
        const SharedObject& object = entry.second;
        return object.owner == self && object.kind == publication.kind
               && object.name == publication.name;
    });
    if (found == state.objects().end())
        return std::nullopt;
    return found->first;
}

} // namespace carina
