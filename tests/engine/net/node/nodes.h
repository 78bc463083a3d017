#pragma once

#include "engine/core/monotonic_clock.h"
#include "engine/net/node/session_node.h"
#include "tests/engine/net/node/memory_store.h"
#include "tests/support/patience.h"

namespace carina
{

using namespace std::chrono_literals;

inline constexpr StationId kStation{0};
inline constexpr Duration kClockTolerance = 5ms;

/// A key at once; what Argon2id makes of a code is tested with the codes.
inline Result<AccessKey> cheapKey(const JoinCode& code, const SessionKey& session)
{
    AccessKey key{};
    for (std::size_t i = 0; i < session.size(); ++i)
        key[i] = session[i];
    for (std::size_t i = 0; i < JoinCode::kCharacters; ++i)
        key[session.size() + i] = static_cast<std::byte>(code.characters()[i]);
    return key;
}

inline HostSettings hostSettings(const MemoryDisk& disk, std::uint16_t port = 0)
{
    return {.sessionName = "Course",
            .participantName = "Dr Hall",
            .port = port,
            .secrets = disk.folder.filePath(QStringLiteral("secrets.json")).toStdString(),
            .derive = cheapKey};
}

inline std::unique_ptr<SessionNode> host(MemoryDisk& disk, std::uint16_t port = 0)
{
    auto node = SessionNode::host(hostSettings(disk, port), std::make_unique<MemoryStore>(disk));
    return node ? *std::move(node) : nullptr;
}

inline JoinSettings joinSettings(const SessionNode& host, const char* name,
                                 Role role = Role::Trainee)
{
    return {.port = host.port(),
            .participantName = name,
            .role = role,
            .code = host.joinCodes().at(role),
            .derive = cheapKey};
}

inline std::unique_ptr<SessionNode> join(const JoinSettings& settings)
{
    auto node = SessionNode::join(settings);
    return node ? *std::move(node) : nullptr;
}

/// With the code of the role.
inline std::unique_ptr<SessionNode> join(const SessionNode& host, const char* name,
                                         Role role = Role::Trainee)
{
    return join(joinSettings(host, name, role));
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
    return inPerMinute(station->second.respiration.settingsAt(*node.now() + 10s).pattern.rate);
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

inline std::shared_ptr<const RemoteObject> onlyObject(const SessionNode& node)
{
    const auto state = node.state();
    return state->objects().empty() ? nullptr : node.object(state->objects().begin()->first);
}

} // namespace carina
