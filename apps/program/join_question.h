#pragma once

#include "engine/net/node/session_node.h"

#include <QString>

namespace carina::program
{

/// The node of a joined session, and the role in it.
struct Entered {
    std::unique_ptr<SessionNode> node; ///< null: the person cancelled
    Role role = Role::Trainee;
};

/// Shows the join dialog until the person is admitted or cancels.
/// @param settings the known settings; if isComplete, they are tried first, and the dialog is shown
///                 only after a refusal
/// @param link a join link to fill in; may be empty
/// @param isNamed whether the name is known; else the one of the last time is filled in
[[nodiscard]] Entered askHowToJoin(const JoinSettings& settings, const QString& link,
                                   bool isComplete, bool isNamed);

} // namespace carina::program
