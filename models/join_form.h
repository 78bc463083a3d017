#pragma once

#include "engine/net/session_node.h"

#include <QString>

namespace carina
{

/// What a person types to come into a session.
struct JoinForm {
    QString address{};
    QString port{};
    QString code{};
    QString name{};
    Role role = Role::Trainee;
};

/// What is still to be mended, as one sentence; empty when the form can be used.
[[nodiscard]] QString whatIsMissing(const JoinForm& form);

/// Takes over what the form says. @pre nothing is missing.
void fillIn(JoinSettings& settings, const JoinForm& form);

/// How others come into a session that is hosted here, with a shape before the words.
[[nodiscard]] QString reachText(const SessionNode& host);

} // namespace carina
