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
    QString certificate{}; ///< the name in the host's, where it has one
};

/// The form with what a join link says that stands in the place of the address; as it is where none
/// stands there, or a wrong one.
[[nodiscard]] JoinForm withLinkRead(JoinForm form);

/// What is still to be mended, as one sentence; empty when the form can be used.
[[nodiscard]] QString whatIsMissing(const JoinForm& form);

/// Takes over what the form says. @pre nothing is missing.
void fillIn(JoinSettings& settings, const JoinForm& form);

/// The link that leads a guest in this role into a session that is hosted here: at the first of
/// this computer's addresses, or on this computer alone where it is not open to others.
[[nodiscard]] QString joinLinkText(const SessionNode& host, Role role);

/// Which name guests are to expect in the host's certificate; empty where it has none.
[[nodiscard]] QString certificateText(const SessionNode& host);

/// How others come into a session that is hosted here, with a shape before the words.
[[nodiscard]] QString reachText(const SessionNode& host);

} // namespace carina
