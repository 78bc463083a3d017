#include "apps/lab/attack/witness.h"

#include "engine/core/monotonic_clock.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kWitnessLooks = 500us;

} // namespace

Witness::Witness(const SessionNode& node, std::string owner)
    : m_node{node},
      m_owner{std::move(owner)},
      m_lastArrival{monotonicNow()},
      m_lastLook{m_lastArrival},
      m_thread{[this] { watch(); }}
{
}

Witness::~Witness()
{
    m_ends = true;
    m_thread.join();
}

Seen Witness::take()
{
    const std::lock_guard lock{m_mutex};
    Seen seen = std::exchange(m_seen, {});
    seen.largestGap = std::max(seen.largestGap, monotonicNow() - m_lastArrival);
    return seen;
}

void Witness::watch()
{
    std::shared_ptr<const RemoteObject> object;
    for (; !m_ends; std::this_thread::sleep_for(kWitnessLooks)) {
        if (!object)
            object = tube();
        const auto now = m_node.now();
        if (!object || !now)
            continue;
        const std::lock_guard lock{m_mutex};
        look(*object, monotonicNow(), *now);
    }
}

std::shared_ptr<const RemoteObject> Witness::tube() const
{
    const auto state = m_node.state();
    for (const auto& [id, object] : state->objects()) {
        const auto owner = state->participants().find(object.owner);
        if (object.kind == ObjectKind::Tube && owner != state->participants().end()
            && owner->second.name == m_owner)
            return m_node.object(id);
    }
    return nullptr;
}

void Witness::look(const RemoteObject& object, LocalTime now, SessionTime session)
{
    m_seen.latest = std::max(m_seen.latest, now - std::exchange(m_lastLook, now));
    if (const auto newest = object.newest(); newest && newest->time != m_newest) {
        if (m_sees) {
            m_seen.largestGap = std::max(m_seen.largestGap, now - m_lastArrival);
            ++m_seen.samples;
        }
        m_newest = newest->time;
        m_lastArrival = now;
        m_sees = true;
        m_seen.places.heard(*newest, session);
    }
    const auto shown = object.at(session);
    if (!shown)
        return;
    m_seen.places.shown(session, shown->X_FO.translation(),
                        [&object](SessionTime t) -> std::optional<Vec3> {
                            const auto was = object.at(t);
                            if (!was || was->validity == Validity::Lost)
                                return std::nullopt;
                            return was->X_FO.translation();
                        });
}

} // namespace carina::lab
