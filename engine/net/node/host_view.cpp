#include "engine/net/node/host_view.h"

#include <algorithm>

namespace carina
{
namespace
{

/// Of showing when each peer was last heard; who comes or goes is shown at once.
constexpr Duration kLinkInterval = std::chrono::milliseconds{50};

} // namespace

Duration HostView::showsWithin(const SessionState& session)
{
    const std::uint64_t facts = session.lastApplied().value;
    const std::uint64_t more = facts - std::min(facts, kShownAtOnce);
    return std::min(static_cast<Duration::rep>(more) * kShownLater, kShownLatest);
}

NodeBoard::View HostView::at(LocalTime now, const FactLedger& ledger, const SyncHost& core)
{
    showState(now, ledger.stored().state());
    showLinks(now, core);
    showPending(ledger);
    NodeBoard::View view;
    const Duration offset = core.sessionTime(now).time_since_epoch() - now.time_since_epoch();
    view.clock = ClockMapping{now, offset};
    view.clockReport = ClockReport{offset};
    view.state = m_state;
    view.pending = m_pending;
    view.links = m_links;
    return view;
}

void HostView::showState(LocalTime now, const SessionState& stored)
{
    if (now < nextWake())
        return;
    m_state = std::make_shared<SessionState>(stored);
    m_hasNewState = false;
    m_nextState = now + showsWithin(stored);
}

void HostView::showLinks(LocalTime now, const SyncHost& core)
{
    if (now < m_nextLinks && m_links->size() == core.peers().size())
        return;
    m_nextLinks = now + kLinkInterval;
    std::vector<NodeBoard::Link> links;
    for (const auto& [address, peer] : core.peers())
        links.push_back(linkReport(peer.participant, LinkState::Connected, peer.link));
    m_links = std::make_shared<std::vector<NodeBoard::Link>>(std::move(links));
}

/// What is in the session as it is shown waits no longer, nor what was given up.
void HostView::showPending(const FactLedger& ledger)
{
    std::erase_if(m_awaited, [shown = m_state->lastApplied(),
                              decided = ledger.decided().state().lastApplied()](const auto& own) {
        return own.first <= shown || own.first > decided;
    });
    std::vector<FactBody> bodies;
    for (const auto& [number, body] : m_awaited)
        bodies.push_back(body);
    if (bodies != *m_pending)
        m_pending = std::make_shared<std::vector<FactBody>>(std::move(bodies));
}

} // namespace carina
