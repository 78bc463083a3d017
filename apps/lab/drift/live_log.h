#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/sync/strategies/strategy_choice.h"

#include <QJsonObject>

#include <optional>
#include <vector>

namespace carina::lab
{

/// What one program of a live session showed at an instant.
struct LiveSample {
    LocalTime machine{}; ///< CLOCK_MONOTONIC, which all programs of a machine share
    std::optional<SessionTime> session{};
    std::optional<RigidTransform> X_AO_turned{};
    std::optional<RigidTransform> X_AO_moved{};
};

/// An action as its actor declared it: from where each object goes on, and since when.
struct DeclaredAction {
    LocalTime called{}; ///< when it was asked for; all times are the machine's
    LocalTime turnedSince{};
    LocalTime movedSince{};
    Quat q_AO = Quat::Identity();
    Vec3 p_AO = Vec3::Zero();
};

/// What one program of a live session wrote down.
struct LiveLog {
    Duration handshake{}; ///< from the first hello until it had a part in the session and its clock
    StrategyKind strategy = StrategyKind::SessionClock; ///< of the session, as it knew it last
    std::vector<LiveSample> samples;                    ///< in their order
    std::vector<DeclaredAction> actions; ///< the actor's; the last is the one that stops both
};

[[nodiscard]] QJsonObject toJson(const LiveLog& log);
/// @returns FileMalformed for anything but what toJson makes.
[[nodiscard]] Result<LiveLog> liveLogFrom(const QJsonObject& json);

} // namespace carina::lab
