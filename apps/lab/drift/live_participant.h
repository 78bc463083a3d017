#pragma once

#include "apps/lab/drift/live_log.h"
#include "apps/lab/drift/live_orders.h"
#include "engine/net/node/session_node.h"

#include <QTemporaryDir>

#include <algorithm>
#include <array>

namespace carina::lab
{

/// A program's part in a live drift experiment: comes in, acts if it is the actor, and writes down
/// what it shows.
class LiveParticipant
{
public:
    /// No simple fraction of an action, so that samples meet all phases of one.
    static constexpr Duration kSampleInterval = std::chrono::microseconds{5003};
    /// Of the samples before the first action.
    static constexpr Duration kBefore = std::chrono::milliseconds{100};

    /// @returns what SessionNode::host or join does, or openFactStore.
    [[nodiscard]] static Result<std::unique_ptr<LiveParticipant>> start(const LiveOrders& orders);

    [[nodiscard]] std::uint16_t port() const { return m_node->port(); }
    /// Goes on with coming in; called again and again. @returns whether both objects are shown.
    [[nodiscard]] bool comeIn();
    /// From now on step() is to be called. @param begin of the first action, on the machine's clock
    void beginAt(LocalTime begin);
    /// When step() is to be called next.
    [[nodiscard]] LocalTime nextStep() const { return std::min(m_nextSample, m_nextFrame); }
    /// Acts if it is time to, draws and samples.
    void step();
    [[nodiscard]] const LiveLog& log() const { return m_log; }
    /// Why it is not let in, if it is not.
    [[nodiscard]] std::optional<Error> refusal() const { return m_node->refusal(); }

private:
    enum Which : std::size_t { Turned, Moved };
    using Picture = std::array<std::optional<RigidTransform>, 2>;

    explicit LiveParticipant(const LiveOrders& orders);
    [[nodiscard]] std::optional<ObjectId> find(Which which) const;
    void share();
    void act(int action);
    void noteBeginning();
    [[nodiscard]] Picture draw(LocalTime now) const;
    void sample();

    LiveOrders m_orders;
    ActionScript m_script;
    LocalTime m_started{};
    QTemporaryDir m_folder; // of the host's log
    std::unique_ptr<SessionNode> m_node;
    bool m_hasShared = false;
    bool m_isAtRest = false;
    int m_acted = 0;                      // actions, the one that stops both included
    std::array<SessionTime, 2> m_begun{}; // of the newest action on each
    LocalTime m_begin{};                  // of the first action; all three on the machine's clock
    LocalTime m_nextSample{};
    LocalTime m_nextFrame = LocalTime::max(); // of a view that has frames
    Picture m_frame{};                        // that is seen there
    LiveLog m_log;
};

} // namespace carina::lab
