#pragma once

#include "engine/net/objects/remote_objects.h"
#include "engine/session/session_state.h"
#include "engine/sync/actions/shared_actions.h"
#include "engine/sync/strategies/view_comparison.h"

#include <functional>
#include <memory>
#include <vector>

namespace carina
{

/// An object at session time t, local time `drawn`, as it is acted on, else as its owner's samples
/// have it; nothing where neither is known, and where it is lost.
[[nodiscard]] std::optional<ActedPose> shownPoseOf(const SharedActions& actions,
                                                   const RemoteObjects& others, ObjectId object,
                                                   SessionTime t, LocalTime drawn);

/// Takes note of what this node shows of the shared objects a few times a second, and compares it
/// with what their owners showed at the same session times. Used on the node's thread.
class ShownViews
{
public:
    /// A tracked object of this node is measured for a time once samples around that time are here.
    static constexpr Duration kMeasuredAfter = std::chrono::milliseconds{100};
    /// How long a comparison holds.
    static constexpr Duration kHolds = std::chrono::seconds{2};

    /// An object as this node shows it at session time t; nothing where it shows none.
    using ShownOf = std::function<std::optional<ActedPose>(ObjectId, SessionTime)>;
    /// X_AO of an object as it was measured for session time t; nothing where it was not.
    using MeasuredOf = std::function<std::optional<RigidTransform>(ObjectId, SessionTime)>;
    /// @param shown of objects of others, and of own ones that are acted on
    /// @param measured of own tracked objects
    ShownViews(ShownOf shown, MeasuredOf measured)
        : m_shownPose{std::move(shown)}, m_measuredPose{std::move(measured)}
    {
    }

    /// @returns what was shown of own objects, to be sent to all others
    [[nodiscard]] std::vector<ShownPose> advance(const SessionState& state, ParticipantId self,
                                                 SessionTime now);
    /// When advance() is to be called next. @param now present session time
    [[nodiscard]] SessionTime nextDue(SessionTime now) const;
    void compare(const ShownPose& owners);
    void clear();

    /// A comparison for this session time.
    struct Compared {
        Drift drift;
        SessionTime at{};
    };
    using Drifts = std::map<ObjectId, Compared>;
    /// The newest comparison of each object of others, of the last kHolds; shared with the threads
    /// that read it.
    [[nodiscard]] const std::shared_ptr<const Drifts>& drifts() const { return m_drifts; }

private:
    void forgetOld(const SessionState& state, ParticipantId self, SessionTime now);

    ShownOf m_shownPose;
    MeasuredOf m_measuredPose;
    ViewComparison m_views;
    std::shared_ptr<const Drifts> m_drifts = std::make_shared<Drifts>();
    SessionTime m_last = SessionTime::min();
    std::vector<ObjectId> m_toMeasure; // at m_last
};

} // namespace carina
