#pragma once

#include "engine/net/node/session_node.h"

#include <QString>

#include <optional>

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

enum class JoinField : std::uint8_t { Address, Port, Code, Name, Certificate };

/// What is to be mended in a form before it opens a session, and where.
struct JoinGap {
    JoinField field = JoinField::Address;
    QString sentence{};
};

/// The form with what a join link says that stands in the place of the address; as it is where none
/// stands there, or a wrong one.
[[nodiscard]] JoinForm withLinkRead(JoinForm form);

/// What is still to be mended; nothing when the form can be used. A code may be missing only where
/// a token of an earlier visit under this name and role was kept.
/// @param tokens the folder that keeps them
[[nodiscard]] std::optional<JoinGap> whatIsMissing(const JoinForm& form,
                                                   const std::filesystem::path& tokens);

/// What is to be mended in the form after the session was tried with it and refused it.
[[nodiscard]] JoinGap gapOf(const Error& refusal, const JoinForm& form);

/// What settings say already, as a person would have typed it.
[[nodiscard]] JoinForm formOf(const JoinSettings& settings);

/// Takes over what the form says. @pre nothing is missing but a code.
void fillIn(JoinSettings& settings, const JoinForm& form);

/// The link that leads a guest in this role into a session that is hosted here: at the first of
/// this computer's addresses, or on this computer alone where it is not open to others.
[[nodiscard]] QString joinLinkText(const SessionNode& host, Role role);

/// Which name guests are to expect in the host's certificate; empty where it has none.
[[nodiscard]] QString certificateText(const SessionNode& host);

/// How others come into a session that is hosted here, with a shape before the words.
[[nodiscard]] QString reachText(const SessionNode& host);

} // namespace carina
