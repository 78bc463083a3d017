#pragma once

#include "engine/core/monotonic_clock.h"
#include "engine/net/session_node.h"
#include "tests/engine/net/memory_store.h"

namespace carina
{

using namespace std::chrono_literals;

inline constexpr int kSoonMs = 2000;
inline constexpr StationId kStation{0};
inline constexpr Duration kClockTolerance = 5ms;

inline std::unique_ptr<SessionNode> host(MemoryDisk& disk, std::uint16_t port = 0)
{
    auto node = SessionNode::host({"Course", "Dr Hall", port}, std::make_unique<MemoryStore>(disk));
    return node ? *std::move(node) : nullptr;
}

inline std::unique_ptr<SessionNode> join(std::uint16_t port, const char* name,
                                         Role role = Role::Trainee)
{
    auto node = SessionNode::join({port, name, role, kStation});
    return node ? *std::move(node) : nullptr;
}

inline LinkState linkOf(const SessionNode& client) { return client.links().at(0).state; }

inline bool isIn(const SessionNode& client)
{
    return linkOf(client) == LinkState::Connected && client.now().has_value();
}

inline double ratePerMinute(const SessionNode& node)
{
    const auto state = node.state();
    const auto station = state->stations().find(kStation);
    if (station == state->stations().end())
        return 0.0;
    return inPerMinute(station->second.breathing.settingsAt(*node.now() + 10s).rate);
}

inline Duration apart(const SessionNode& a, const SessionNode& b)
{
    const LocalTime now = monotonicNow();
    return std::chrono::abs(*a.sessionTime(now) - *b.sessionTime(now));
}

/// A tube that stands still, seen anew at each asking.
inline PoseSource stillTube(const SessionNode& node)
{
    return [&node]() -> std::optional<PoseSample> {
        const auto now = node.now();
        if (!now)
            return std::nullopt;
        PoseSample sample;
        sample.time = *now;
        sample.X_FO = RigidTransform::translation(Vec3{0.1, 0.2, 0.3});
        sample.motion = Motion{};
        return sample;
    };
}

inline std::shared_ptr<const PoseHistory> onlyObject(const SessionNode& node)
{
    const auto state = node.state();
    return state->objects().empty() ? nullptr : node.object(state->objects().begin()->first);
}

} // namespace carina
