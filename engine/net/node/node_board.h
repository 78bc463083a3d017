#pragma once

#include "engine/net/node/session_node.h"
#include "engine/net/objects/remote_objects.h"
#include "engine/net/objects/shown_views.h"
#include "engine/sync/actions/shared_actions.h"
#include "engine/sync/clock/clock_mapping.h"
#include "engine/sync/connection/peer_link.h"

#include <mutex>

namespace carina
{

/// State of a node for other threads: its own thread writes, any thread reads.
class NodeBoard
{
public:
    struct Link {
        LinkReport report; ///< without sinceLastDatagram
        LocalTime lastHeard{};
    };
    /// What a part of a view is that has nothing yet; one for all views, so that a turn of the node
    /// makes none. Shared with the threads that read it.
    template <class Part> [[nodiscard]] static const std::shared_ptr<const Part>& none()
    {
        static const std::shared_ptr<const Part> one = std::make_shared<Part>();
        return one;
    }
    /// Made anew in each turn of the node: what is large in it is shared with the view before.
    struct View {
        ParticipantId self = kNobody;
        std::optional<ClockMapping> clock;
        std::optional<ClockReport> clockReport;
        std::shared_ptr<const SessionState> state = none<SessionState>();
        std::shared_ptr<const SharedActions> actions = none<SharedActions>();
        std::shared_ptr<const ShownViews::Drifts> drifts = none<ShownViews::Drifts>();
        std::shared_ptr<const std::vector<FactBody>> pending = none<std::vector<FactBody>>();
        std::shared_ptr<const std::vector<Link>> links = none<std::vector<Link>>();
        std::shared_ptr<const std::vector<PathReport>> paths = none<std::vector<PathReport>>();
        LocalTime nextPaths = LocalTime::min(); ///< when they are to be measured again
        std::optional<Error> refusal;
    };

    /// One part of the view, such as `part(&NodeBoard::View::clock)`.
    template <class Part> [[nodiscard]] Part part(Part View::*member) const
    {
        const std::scoped_lock lock{m_mutex};
        return m_view.*member;
    }
    [[nodiscard]] std::optional<ClockMapping> clock() const { return part(&View::clock); }
    [[nodiscard]] std::shared_ptr<const SessionState> state() const { return part(&View::state); }
    /// Reports on all objects with samples or actions, at session time `now`.
    [[nodiscard]] std::vector<ObjectReport> objectReports(SessionTime now) const;
    /// v_k of all who act, at session time `now`.
    [[nodiscard]] std::map<ParticipantId, double> actionFrequencies(SessionTime now) const;
    /// Puts the node's actions into a view; the shown copy is reused where nothing changed.
    void showActions(View& view, const SharedActions& actions) const;
    /// Puts the path reports into a view; they are measured again where the shown ones are too old.
    void showPaths(View& view, LocalTime now,
                   const std::function<std::vector<PathReport>()>& measure) const;
    /// Replaces the view. @returns whether anything changed that onChange announces.
    bool show(View view);

    void setJoinCodes(JoinCodes codes)
    {
        const std::scoped_lock lock{m_mutex};
        m_joinCodes = std::move(codes);
    }
    [[nodiscard]] JoinCodes joinCodes() const
    {
        const std::scoped_lock lock{m_mutex};
        return m_joinCodes;
    }

    void setDoor(HostDoor door)
    {
        const std::scoped_lock lock{m_mutex};
        m_door = std::move(door);
    }
    [[nodiscard]] std::optional<HostDoor> door() const
    {
        const std::scoped_lock lock{m_mutex};
        return m_door;
    }

    void onChange(std::function<void()> callback);
    void announce() const;

    RemoteObjects objects;

private:
    mutable std::mutex m_mutex;
    View m_view;
    JoinCodes m_joinCodes;
    std::optional<HostDoor> m_door;
    std::function<void()> m_callback;
};

/// The measured link to a peer, without sinceLastDatagram.
[[nodiscard]] NodeBoard::Link linkReport(ParticipantId peer, LinkState state, const PeerLink& link);

} // namespace carina
