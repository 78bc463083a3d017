#pragma once

#include "engine/net/node/session_node.h"

#include <QString>

namespace carina::program
{

/// How to come in, as far as it is known.
struct KnownEntry {
    JoinSettings settings;
    QString link{};          ///< that a person is still to complete; may be empty
    bool isComplete = false; ///< the settings are tried first, and a person asked after a refusal
    bool isNamed = false;    ///< else name and role are those of the last time
    bool isAnother = false;  ///< not into the session of the last time
};

/// The node of a joined session, and the role in it.
struct Entered {
    std::unique_ptr<SessionNode> node; ///< null: the person cancelled
    Role role = Role::Trainee;
};

/// Shows the join dialog until the person is admitted or cancels. A person who was in a session
/// before finds it filled in, wherever its host is now.
[[nodiscard]] Entered askHowToJoin(const KnownEntry& known);

} // namespace carina::program
