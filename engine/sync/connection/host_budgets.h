#pragma once

#include "engine/core/ids.h"
#include "engine/sync/connection/peer_budget.h"

#include <functional>
#include <map>

namespace carina
{

/// The budgets of all who take part or took part: who comes again goes on with the one that it had.
/// As many as the session has names.
class HostBudgets
{
public:
    /// For this long a participant whose program sent far too much stays out.
    static constexpr Duration kBarred = std::chrono::seconds{30};

    /// Of one who is here or was; null before.
    [[nodiscard]] PeerBudget* known(ParticipantId participant);
    /// Of one who comes in, with what it shares from now on; valid as long as this.
    /// @param limits asked where it never was here
    [[nodiscard]] PeerBudget& comesIn(ParticipantId participant,
                                      const std::function<PeerLimits(ParticipantId)>& limits,
                                      std::shared_ptr<SharedBudget> shared, LocalTime now);

    /// The participant stays out for a while, for its excess. What it has used of its budget stays
    /// used, or else whoever is barred would have a new one. @pre it is not here
    void bar(ParticipantId participant, LocalTime now);
    [[nodiscard]] bool isBarred(ParticipantId participant, LocalTime now) const;

private:
    std::map<ParticipantId, PeerBudget> m_budgets;
    std::map<ParticipantId, LocalTime> m_barredUntil;
};

} // namespace carina
