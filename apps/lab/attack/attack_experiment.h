#pragma once

#include "apps/lab/attack/attack_figures.h"
#include "apps/lab/programs/started_session.h"

#include <QStringList>

#include <functional>

namespace carina::lab
{

struct AttackSettings {
    SessionPrograms programs;
    Duration length = std::chrono::seconds{10}; ///< at least
    std::vector<const AttackKind*> kinds{};
    int guests = 0; ///< who come in before the first attack and only take part
    std::function<void(const AttackKind&)> begins = [](const AttackKind&) {}; ///< called with each
};

/// Starts a session of a console and a trainee, and attacks it in one way after another, while an
/// observer watches the trainee's tube and newcomers join.
/// @returns the errors of StartedSession; HostSilent where not all come in or a program ends.
[[nodiscard]] Result<std::vector<AttackFigures>> attackSession(const AttackSettings& settings);

} // namespace carina::lab
