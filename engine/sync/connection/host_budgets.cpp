#include "engine/sync/connection/host_budgets.h"

namespace carina
{

PeerBudget* HostBudgets::known(ParticipantId participant)
{
    const auto found = m_budgets.find(participant);
    return found == m_budgets.end() ? nullptr : &found->second;
}

PeerBudget& HostBudgets::comesIn(ParticipantId participant,
                                 const std::function<PeerLimits(ParticipantId)>& limits,
                                 std::shared_ptr<SharedBudget> shared, LocalTime now)
{
    if (PeerBudget* before = known(participant)) {
        before->comes(std::move(shared), now);
        return *before;
    }
    PeerBudget& budget =
        m_budgets.emplace(participant, PeerBudget{limits(participant)}).first->second;
    budget.comes(std::move(shared), now);
    // It is charged only now, for nobody knew before whose it is; a new budget has enough.
    static_cast<void>(budget.takesComing(now));
    return budget;
}

void HostBudgets::bar(ParticipantId participant, LocalTime now)
{
    std::erase_if(m_barredUntil, [now](const auto& entry) { return entry.second <= now; });
    m_barredUntil.insert_or_assign(participant, now + kBarred);
    if (PeerBudget* budget = known(participant))
        budget->pardon();
}

bool HostBudgets::isBarred(ParticipantId participant, LocalTime now) const
{
    const auto barred = m_barredUntil.find(participant);
    return barred != m_barredUntil.end() && now < barred->second;
}

} // namespace carina
