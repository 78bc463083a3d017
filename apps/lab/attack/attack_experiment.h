#pragma once

#include "apps/lab/attack/attacks.h"
#include "apps/lab/attack/witness.h"
#include "apps/lab/programs/started_session.h"

#include <QStringList>

#include <functional>
#include <optional>

namespace carina::lab
{

struct AttackSettings {
    SessionPrograms programs;
    Duration length = std::chrono::seconds{10};
    std::vector<const AttackKind*> kinds{};
    int guests = 0; ///< who come in before the first attack and only take part
    std::function<void(const AttackKind&)> begins = [](const AttackKind&) {}; ///< called with each
};

/// What one attack did to a session.
struct AttackFigures {
    const AttackKind* kind = nullptr;
    std::int64_t sent = 0; ///< as the attack counts
    bool isTakenForAnother = false;
    Seen before{}; ///< in as much time before it
    Seen during{}; ///< in the time of the attack
    std::optional<Duration>
        joined{};           ///< how long a newcomer took meanwhile; nothing: not within 10 s
    std::int64_t facts = 0; ///< by which the log is longer afterwards
    std::vector<double> memory_kb{}; ///< by which console and trainee hold more afterwards
};

/// Starts a session of a console and a trainee, and attacks it in one way after another, while an
/// observer watches the trainee's tube and a newcomer joins.
/// @returns the errors of StartedSession; HostSilent where not all come in or a program ends.
[[nodiscard]] Result<std::vector<AttackFigures>> attackSession(const AttackSettings& settings);

} // namespace carina::lab
