#pragma once

#include "engine/net/node/fact_ledger.h"
#include "engine/net/node/node_board.h"
#include "engine/sync/connection/sync_host.h"

namespace carina
{

/// What the host shows to the other threads of its session, its clients and its own proposals.
class HostView
{
public:
    /// A session of so many facts is shown as soon as there are new ones. Each time it is copied,
    /// which takes the longer the more facts there are: for each one more it is shown this much
    /// less often, so that copying takes up no more than a part of the time. Changes take effect as
    /// much later, so that none does before it is shown (CheckpointKeeper).
    static constexpr std::uint64_t kShownAtOnce = 10'000;
    static constexpr Duration kShownLater = std::chrono::microseconds{1};
    static constexpr Duration kShownLatest = std::chrono::milliseconds{50};

    /// How long a new fact may wait until it is shown.
    [[nodiscard]] static Duration showsWithin(const SessionState& session);

    /// The session has facts that are not shown yet.
    void changed() { m_hasNewState = true; }
    /// An own proposal was decided; pending until it is shown as a fact, or given up.
    void await(FactNumber number, FactBody body)
    {
        m_awaited.emplace_back(number, std::move(body));
    }
    /// When a change is due to be shown.
    [[nodiscard]] LocalTime nextWake() const
    {
        return m_hasNewState ? m_nextState : LocalTime::max();
    }

    /// State, clock, links and pending proposals of a view.
    [[nodiscard]] NodeBoard::View at(LocalTime now, const FactLedger& ledger, const SyncHost& core);

private:
    void showState(LocalTime now, const SessionState& stored);
    /// Newest contact with each peer, as shown last where that is not long ago.
    void showLinks(LocalTime now, const SyncHost& core);
    void showPending(const FactLedger& ledger);

    std::shared_ptr<const SessionState> m_state;
    bool m_hasNewState = true;
    LocalTime m_nextState = LocalTime::min();
    std::shared_ptr<const std::vector<NodeBoard::Link>> m_links =
        NodeBoard::none<std::vector<NodeBoard::Link>>();
    LocalTime m_nextLinks = LocalTime::min();
    std::vector<std::pair<FactNumber, FactBody>> m_awaited;
    std::shared_ptr<const std::vector<FactBody>> m_pending =
        NodeBoard::none<std::vector<FactBody>>();
};

} // namespace carina
