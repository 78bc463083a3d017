#include "engine/net/objects/shown_views.h"

#include <algorithm>
#include <utility>

namespace carina
{

std::optional<ActedPose> shownPoseOf(const SharedActions& actions, const RemoteObjects& others,
                                     ObjectId object, SessionTime t, LocalTime drawn)
{
    if (const auto acted = actions.shown(object, t, drawn, drawn))
        return acted->acted;
    const auto poses = others.find(object);
    const auto pose = poses ? poses->at(t) : std::nullopt;
    if (!pose || pose->validity == Validity::Lost)
        return std::nullopt;
    return ActedPose{pose->X_FO};
}

std::vector<ShownPose> ShownViews::advance(const SessionState& state, ParticipantId self,
                                           SessionTime now)
{
    std::vector<ShownPose> own;
    if (now >= m_last + kMeasuredAfter)
        for (const ObjectId id : std::exchange(m_toMeasure, {}))
            if (const auto X_AO = m_measuredPose(id, m_last))
                own.push_back({id, m_last, *X_AO});
    const SessionTime at = ViewComparison::timeBefore(now);
    if (at <= m_last)
        return own;
    m_last = at;
    forgetOld(state, self, now);
    for (const auto& [id, object] : state.objects()) {
        const auto shown = m_shownPose(id, at);
        if (shown && object.owner == self)
            own.push_back({id, at, shown->X_AO, shown->scale});
        else if (shown)
            m_views.remember({id, at, shown->X_AO, shown->scale});
        else if (object.owner == self)
            m_toMeasure.push_back(id);
    }
    return own;
}

void ShownViews::forgetOld(const SessionState& state, ParticipantId self, SessionTime now)
{
    const auto isOld = [&](const auto& entry) {
        const auto object = state.objects().find(entry.first);
        return now > entry.second.at + kHolds || object == state.objects().end()
               || object->second.owner == self;
    };
    if (std::ranges::none_of(*m_drifts, isOld))
        return;
    Drifts drifts = *m_drifts;
    std::erase_if(drifts, isOld);
    m_drifts = std::make_shared<Drifts>(std::move(drifts));
}

SessionTime ShownViews::nextDue(SessionTime now) const
{
    return m_toMeasure.empty() ? ViewComparison::timeBefore(now) + ViewComparison::kPeriod
                               : m_last + kMeasuredAfter;
}

void ShownViews::compare(const ShownPose& owners)
{
    const auto drift = m_views.compare(owners);
    if (!drift)
        return;
    Drifts drifts = *m_drifts;
    drifts.insert_or_assign(owners.object, Compared{*drift, owners.at});
    m_drifts = std::make_shared<Drifts>(std::move(drifts));
}

void ShownViews::clear()
{
    m_views.clear();
    m_drifts = std::make_shared<Drifts>();
    m_toMeasure.clear();
    m_last = SessionTime::min();
}

} // namespace carina
