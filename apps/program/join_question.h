#pragma once

#include "engine/net/node/session_node.h"

#include <QString>

namespace carina::program
{

/// A program's way in, and the role it came in as.
struct Entered {
    std::unique_ptr<SessionNode> node; ///< none: its person does not want to come in
    Role role = Role::Trainee;
};

/// Lets a person choose a session that is found, or type its address, until they are in or leave.
/// @param settings what is known already; what is complete is tried at once, and asked about only
///                 if it is refused
/// @param link leads into a session; may be empty
[[nodiscard]] Entered askHowToJoin(const JoinSettings& settings, const QString& link,
                                   bool isComplete);

} // namespace carina::program
