#include "apps/lab/attack/witness.h"

#include "engine/core/monotonic_clock.h"
#include "engine/core/units.h"

#include <algorithm>
#include <cmath>

namespace carina::lab
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kLook = 500us;
constexpr Duration kShownInterval = 20ms;
constexpr Duration kArrived = 300ms; ///< by then the samples around a time are there

} // namespace

Witness::Witness(const SessionNode& node, std::string owner)
    : m_node{node}, m_owner{std::move(owner)}, m_lastArrival{monotonicNow()}, m_thread{[this] {
          watch();
      }}
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
    if (seen.places > 0)
        seen.drift_mm = std::sqrt(m_squares / double(seen.places));
    m_squares = 0.0;
    m_shown.clear();
    return seen;
}

void Witness::watch()
{
    std::shared_ptr<const RemoteObject> object;
    for (; !m_ends; std::this_thread::sleep_for(kLook)) {
        if (!object)
            object = tube();
        const auto now = m_node.now();
        if (!object || !now)
            continue;
        const std::lock_guard lock{m_mutex};
        heard(*object, monotonicNow());
        compare(*object, *now);
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

void Witness::heard(const RemoteObject& object, LocalTime now)
{
    const auto newest = object.newest();
    if (!newest || newest->time == m_newest)
        return;
    if (m_sees) {
        m_seen.largestGap = std::max(m_seen.largestGap, now - m_lastArrival);
        ++m_seen.samples;
    }
    m_newest = newest->time;
    m_lastArrival = now;
    m_sees = true;
}

void Witness::compare(const RemoteObject& object, SessionTime now)
{
    if (const auto shown = object.at(now); shown && now >= m_nextShown) {
        m_nextShown = now + kShownInterval;
        m_shown.push_back({now, shown->X_FO.translation()});
    }
    while (!m_shown.empty() && m_shown.front().time + kArrived < now) {
        const auto was = object.at(m_shown.front().time);
        if (was && was->validity != Validity::Lost) {
            const double apart =
                inMillimetres(metres((was->X_FO.translation() - m_shown.front().p_A).norm()));
            m_squares += apart * apart;
            ++m_seen.places;
        }
        m_shown.pop_front();
    }
}

} // namespace carina::lab
