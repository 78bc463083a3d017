#include "apps/lab/drift/live_participant.h"

#include "engine/core/monotonic_clock.h"
#include "engine/io/fact_store/sql_fact_store.h"

namespace carina::lab
{
namespace
{

constexpr std::array kNames{"turned", "moved"};

Result<std::unique_ptr<SessionNode>> makeNode(const LiveOrders& orders, const QString& folder)
{
    // The launcher gives everybody the key that a join code would be made into.
    const auto derive = [key = orders.key](const JoinCode&, const SessionKey&) {
        return Result<AccessKey>{key};
    };
    if (orders.part != LiveOrders::Part::Host)
        return SessionNode::join({.port = orders.port,
                                  .participantName = orders.name,
                                  .role = Role::Trainee,
                                  .code = JoinCode::random(),
                                  .address = orders.address,
                                  .derive = derive});
    return openFactStore(folder.toStdString() + "/session.sqlite")
        .and_then([&](std::unique_ptr<FactStore> store) {
            return SessionNode::host({.sessionName = "Drift",
                                      .participantName = orders.name,
                                      .port = orders.port,
                                      .open = orders.isOpen,
                                      .derive = derive},
                                     std::move(store));
        });
}

/// The first time of a sequence that is not over yet.
LocalTime after(LocalTime next, Duration interval)
{
    const LocalTime now = machineTime(monotonicNow());
    return next > now ? next : next + ((now - next) / interval + 1) * interval;
}

} // namespace

LiveParticipant::LiveParticipant(const LiveOrders& orders)
    : m_orders{orders}, m_script{orders.script, orders.seed}, m_started{monotonicNow()}
{
}

Result<std::unique_ptr<LiveParticipant>> LiveParticipant::start(const LiveOrders& orders)
{
    std::unique_ptr<LiveParticipant> participant{new LiveParticipant{orders}};
    auto node = makeNode(orders, participant->m_folder.path());
    if (!node)
        return tl::unexpected(node.error());
    participant->m_node = *std::move(node);
    const StrategyChoice choice{.kind = orders.strategy,
                                .asa = {.delays = orders.asaDelays},
                                .longestLag = orders.longestLag};
    if (orders.part == LiveOrders::Part::Host && choice != StrategyChoice{})
        participant->m_node->propose(kNoStation, fact::StrategyChosen{choice});
    return participant;
}

std::optional<ObjectId> LiveParticipant::find(Which which) const
{
    const auto state = m_node->state();
    for (const auto& [id, object] : state->objects())
        if (object.name == kNames[which])
            return id;
    return std::nullopt;
}

void LiveParticipant::share()
{
    for (const char* name : kNames)
        m_node->propose(ownStation(*m_node),
                        fact::ObjectShared{{}, m_node->self(), ObjectKind::Tube, name});
    m_hasShared = true;
}

bool LiveParticipant::comeIn()
{
    const auto now = m_node->now();
    if (!now || m_node->self() == kNobody)
        return false;
    if (m_log.handshake == Duration{} && m_orders.part != LiveOrders::Part::Host)
        m_log.handshake = monotonicNow() - m_started;
    const bool isActor = m_orders.part == LiveOrders::Part::Actor;
    if (isActor && !m_hasShared)
        share();
    const auto turned = find(Turned);
    const auto moved = find(Moved);
    if (!turned || !moved)
        return false;
    if (isActor && !m_isAtRest) {
        act(-1);
        m_isAtRest = true;
    }
    return m_node->shown(*turned, *now) && m_node->shown(*moved, *now);
}

void LiveParticipant::act(int action)
{
    const bool isMoving = action >= 0 && action < m_script.actions();
    const EventCpo rotation = m_script.rotation(isMoving ? action : -1);
    const EventCpo translation = m_script.translation(isMoving ? action : -1);
    m_node->act(*find(Turned),
                {ActionKind::Rotation, rotation.axis_A.cast<double>(), double{rotation.rate}, {}});
    m_node->act(
        *find(Moved),
        {ActionKind::Translation, translation.axis_A.cast<double>(), double{translation.rate}, {}});
}

void LiveParticipant::beginAt(LocalTime begin)
{
    m_begin = begin;
    m_nextSample = begin - kBefore;
    const DisplayFrames& frames = m_orders.frames;
    if (frames.interval > Duration{})
        m_nextFrame = begin + frames.first - kBefore / frames.interval * frames.interval;
}

void LiveParticipant::step()
{
    const LocalTime now = machineTime(monotonicNow());
    if (m_orders.part == LiveOrders::Part::Actor) {
        noteBeginning();
        if (m_acted <= m_script.actions() && now >= m_begin + ActionScript::startOf(m_acted)) {
            m_log.actions.push_back({.called = now});
            m_begun = {m_node->action(*find(Turned))->start, m_node->action(*find(Moved))->start};
            act(m_acted++);
        }
    }
    if (now >= m_nextFrame) {
        m_frame = draw(monotonicNow());
        m_nextFrame = after(m_nextFrame, m_orders.frames.interval);
    }
    if (now >= m_nextSample) {
        sample();
        m_nextSample = after(m_nextSample, kSampleInterval);
    }
}

void LiveParticipant::noteBeginning()
{
    if (m_log.actions.empty() || m_log.actions.back().movedSince != LocalTime{})
        return;
    const auto turning = m_node->action(*find(Turned));
    const auto moving = m_node->action(*find(Moved));
    if (turning->start == m_begun[Turned] || moving->start == m_begun[Moved])
        return;
    // The session clock tells only how long ago it was.
    const LocalTime now = monotonicNow();
    const SessionTime session = *m_node->sessionTime(now);
    DeclaredAction& declared = m_log.actions.back();
    declared.turnedSince = machineTime(now - (session - turning->start));
    declared.movedSince = machineTime(now - (session - moving->start));
    declared.q_AO = turning->q_AO;
    declared.p_AO = moving->p_AO;
}

LiveParticipant::Picture LiveParticipant::draw(LocalTime now) const
{
    const auto session = m_node->sessionTime(now);
    const auto poseOf = [&](Which which) -> std::optional<RigidTransform> {
        const auto object = find(which);
        const auto shown = object && session ? m_node->shown(*object, *session) : std::nullopt;
        return shown ? std::optional{shown->acted.X_AO} : std::nullopt;
    };
    return {poseOf(Turned), poseOf(Moved)};
}

void LiveParticipant::sample()
{
    const LocalTime now = monotonicNow();
    m_log.strategy = m_node->state()->strategy().kind;
    const Picture seen = m_nextFrame == LocalTime::max() ? draw(now) : m_frame;
    m_log.samples.push_back({.machine = machineTime(now),
                             .session = m_node->sessionTime(now),
                             .X_AO_turned = seen[Turned],
                             .X_AO_moved = seen[Moved]});
}

} // namespace carina::lab
